"""The line that says what to do now, on a plate where it hides neither bricks nor the ball."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.overlay.notice_words import Notice
from game.scene import Scene
from physics import Ball

# Lengths are in units of text.
_TITLE, _ABOUT, _HINT = 1.5, 0.95, 1.0
"""Sizes of letters."""
_GAP, _LINE_GAP = 0.25, 0.1
"""Between title, what the level is about, and hint; and between the lines of what it is about."""
_MARGIN = complex(0.8, 0.5)
"""From the words to the plate's edges, across and down."""
_WIDEST, _HIGHEST = 0.52, 0.19
"""Shares of the surface's width and height for the words, which are smaller where they need more: the figures are beside them,
and the wall below."""
_ABOUT_WIDE = 0.44
"""Share of the surface's width in which what the level is about is broken into lines."""
_SHRINK, _LEAST = 0.94, 4.0
"""Letters are tried so much smaller, and at last of so many pixels."""
_CORNER, _EDGE_LINE = 0.6, 0.06
"""Radius of the plate's corners, and width of its edge."""
_TOP, _NARROW_TOP = 0.6, 0.115
"""From the surface's upper edge to the plate: where the figures stand beside the arena; and where they are above it, in
shares of the height."""
_SQUARE = 1.2
"""Aspect ratios up to this have the figures above the arena."""


class _Line(NamedTuple):
    """A line of words, and the room above it, pixels."""

    words: pygame.Surface
    gap: float


def draw(canvas: Canvas, shown: Notice, scene: Scene) -> None:
    """The words on a plate at the upper edge of the arena, at the lower one while a ball is at the upper: never over bricks."""
    unit, (lines, size) = canvas.unit, _fitting(canvas, shown, canvas.unit)
    while unit > _LEAST and (size.real > _WIDEST * canvas.size[0] or size.imag > _HIGHEST * canvas.size[1]):
        unit *= _SHRINK
        lines, size = _fitting(canvas, shown, unit)
    margin = _MARGIN * unit
    plate = pygame.Rect(0, 0, round(size.real + 2.0 * margin.real), round(size.imag + 2.0 * margin.imag))
    edge = round(_edge(canvas))
    plate.midtop = (canvas.size[0] // 2, edge)
    if any([_is_near(canvas, ball, plate) for ball in scene.balls]):
        plate.bottom = canvas.size[1] - edge
    draw_box(canvas.surface, plate, unit * _CORNER, canvas.theme.panel, canvas.theme.panel_edge, unit * _EDGE_LINE)
    y = plate.top + margin.imag
    for line in lines:
        y += line.gap
        canvas.surface.blit(line.words, line.words.get_rect(midtop=(plate.centerx, round(y))))
        y += line.words.get_height()


def _fitting(canvas: Canvas, shown: Notice, unit: float) -> tuple[list[_Line], complex]:
    """The lines in letters of a size, and how wide and how high they are together, pixels."""
    type_, theme = canvas.type, canvas.theme
    lines = [_Line(type_.rendered(shown.title, unit * _TITLE, theme.text), 0.0)]
    for paragraph in shown.about.splitlines():
        for index, words in enumerate(type_.wrapped(paragraph, unit * _ABOUT, _ABOUT_WIDE * canvas.size[0])):
            gap = unit * (_LINE_GAP if index else _GAP)
            lines.append(_Line(type_.rendered(words, unit * _ABOUT, theme.text), gap))
    if shown.hint:
        lines.append(_Line(type_.rendered(shown.hint, unit * _HINT, theme.faint), unit * _GAP))
    height = sum([line.gap + line.words.get_height() for line in lines])
    return lines, complex(max([line.words.get_width() for line in lines]), height)


def _edge(canvas: Canvas) -> float:
    """From the surface's upper edge to the plate, pixels."""
    width, height = canvas.size
    return canvas.unit * _TOP if width > _SQUARE * height else _NARROW_TOP * height


def _is_near(canvas: Canvas, ball: Ball, plate: pygame.Rect) -> bool:
    """Whether a plate hides a ball, or where it will be in a moment."""
    pixel = canvas.camera.project(ball.position, ball.radius)
    room = round(2.0 * canvas.unit)
    return bool(plate.inflate(2 * room, 2 * room).collidepoint(pixel.real, pixel.imag))
