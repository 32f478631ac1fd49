"""The line that says what to do now, on a plate where it hides neither bricks nor the ball."""

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.overlay.notice_words import Notice
from game.scene import Scene
from physics import Ball

# Lengths are in units of text.
_TITLE, _HINT = 1.5, 1.0
"""Sizes of letters."""
_GAP = 0.25
"""Between title and hint."""
_MARGIN = complex(0.8, 0.5)
"""From the words to the plate's edges, across and down."""
_WIDEST = 0.52
"""Share of the surface's width for the words, which are smaller where they need more: the figures are beside them."""
_CORNER, _EDGE_LINE = 0.6, 0.06
"""Radius of the plate's corners, and width of its edge."""
_TOP, _NARROW_TOP = 0.6, 0.115
"""From the surface's upper edge to the plate: where the figures stand beside the arena; and where they are above it, in
shares of the height."""
_SQUARE = 1.2
"""Aspect ratios up to this have the figures above the arena."""


def draw(canvas: Canvas, shown: Notice, scene: Scene) -> None:
    """The words on a plate at the upper edge of the arena, at the lower one while a ball is at the upper: never over bricks."""
    surface, theme, type_, unit = canvas.surface, canvas.theme, canvas.type, canvas.unit
    wide = max([type_.rendered(words, unit * size, theme.text).get_width() for words, size in _sized(shown)])
    unit *= min(_WIDEST * canvas.size[0] / wide, 1.0)
    title = type_.rendered(shown.title, unit * _TITLE, theme.text)
    hint = type_.rendered(shown.hint, unit * _HINT, theme.faint)
    gap = unit * _GAP if shown.hint else 0.0
    height = title.get_height() + (hint.get_height() + gap if shown.hint else 0.0)
    margin = _MARGIN * unit
    width = max(title.get_width(), hint.get_width())
    plate = pygame.Rect(0, 0, round(width + 2.0 * margin.real), round(height + 2.0 * margin.imag))
    edge = round(_edge(canvas))
    plate.midtop = (canvas.size[0] // 2, edge)
    if any([_is_near(canvas, ball, plate) for ball in scene.balls]):
        plate.bottom = canvas.size[1] - edge
    draw_box(surface, plate, unit * _CORNER, theme.panel, theme.panel_edge, unit * _EDGE_LINE)
    top = plate.top + margin.imag
    surface.blit(title, title.get_rect(midtop=(plate.centerx, round(top))))
    if shown.hint:
        surface.blit(hint, hint.get_rect(midtop=(plate.centerx, round(top + title.get_height() + gap))))


def _sized(shown: Notice) -> tuple[tuple[str, float], tuple[str, float]]:
    """Both lines and the sizes of their letters."""
    return (shown.title, _TITLE), (shown.hint, _HINT)


def _edge(canvas: Canvas) -> float:
    """From the surface's upper edge to the plate, pixels."""
    width, height = canvas.size
    return canvas.unit * _TOP if width > _SQUARE * height else _NARROW_TOP * height


def _is_near(canvas: Canvas, ball: Ball, plate: pygame.Rect) -> bool:
    """Whether a plate hides a ball, or where it will be in a moment."""
    pixel = canvas.camera.project(ball.position, ball.radius)
    room = round(2.0 * canvas.unit)
    return bool(plate.inflate(2 * room, 2 * room).collidepoint(pixel.real, pixel.imag))
