"""The line that says what to do now, on a plate where it hides neither bricks nor the ball."""

from functools import lru_cache
from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.drawing.slots.parts import LAYER_HEIGHT
from game.drawing.text import Type
from game.overlay.notice_words import Notice
from game.rules import PADDLES
from game.scene import Scene
from physics import Ball

# Lengths are in units of text.
_TITLE, _ABOUT, _HINT = 1.5, 0.95, 1.0
"""Sizes of letters."""
_GAP, _LINE_GAP = 0.25, 0.1
"""Between title, what the level is about, and hint; and between the lines of what it is about."""
_MARGIN = complex(0.8, 0.5)
"""From the words to the plate's edges, across and down."""
_WIDEST, _HIGHEST = 0.52, 0.22
"""Share of the surface's width for the words, and of its height for the plate: letters are smaller where they need more, for
the figures are beside them."""
_LEAST_HIGH, _ABOVE_WALL = 0.08, 0.4
"""Share of the surface's height that the words have at least, and from the plate to the wall."""
_BALANCED, _TRIES = 0.96, 16
"""Lines are tried in so much less width, so often, until they would be more: the last is then about as long as the others."""
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
    edge, highest = round(_edge(canvas)), _most_height(canvas, scene)
    while unit > _LEAST and (size.real > _WIDEST * canvas.size[0] or size.imag + 2.0 * _MARGIN.imag * unit > highest):
        unit *= _SHRINK
        lines, size = _fitting(canvas, shown, unit)
    margin = _MARGIN * unit
    plate = pygame.Rect(0, 0, round(size.real + 2.0 * margin.real), round(size.imag + 2.0 * margin.imag))
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
        for index, words in enumerate(_balanced(type_, paragraph, unit * _ABOUT, _ABOUT_WIDE * canvas.size[0])):
            gap = unit * (_LINE_GAP if index else _GAP)
            lines.append(_Line(type_.rendered(words, unit * _ABOUT, theme.text), gap))
    if shown.hint:
        lines.append(_Line(type_.rendered(shown.hint, unit * _HINT, theme.faint), unit * _GAP))
    height = sum([line.gap + line.words.get_height() for line in lines])
    return lines, complex(max([line.words.get_width() for line in lines]), height)


@lru_cache(maxsize=64)
def _balanced(type_: Type, text: str, size: float, width: float) -> tuple[str, ...]:
    """The text in as few lines as fit the width, all of them about as long as each other. size, width: pixels."""
    lines = type_.wrapped(text, size, width)
    for _ in range(_TRIES if len(lines) > 1 else 0):
        width *= _BALANCED
        narrower = type_.wrapped(text, size, width)
        if len(narrower) > len(lines):
            break
        lines = narrower
    return tuple(lines)


def _most_height(canvas: Canvas, scene: Scene) -> float:
    """How high the plate may be, pixels, so that it ends above the wall."""
    others = (PADDLES, scene.shield, scene.second_paddle)
    walls = [ring.outer_radius for k, ring in enumerate(scene.rings) if k not in others]
    away = 1j * max(walls, default=0.0) / canvas.camera.turning
    height = 0.0 if canvas.camera.flat else max(scene.tallest) * LAYER_HEIGHT * scene.ground_radius
    room = canvas.camera.project(away, height).imag - _edge(canvas) - _ABOVE_WALL * canvas.unit
    return max(min(_HIGHEST * canvas.size[1], room), _LEAST_HIGH * canvas.size[1])


def _edge(canvas: Canvas) -> float:
    """From the surface's upper edge to the plate, pixels."""
    width, height = canvas.size
    return canvas.unit * _TOP if width > _SQUARE * height else _NARROW_TOP * height


def _is_near(canvas: Canvas, ball: Ball, plate: pygame.Rect) -> bool:
    """Whether a plate hides a ball, or where it will be in a moment."""
    pixel = canvas.camera.project(ball.position, ball.radius)
    room = round(2.0 * canvas.unit)
    return bool(plate.inflate(2 * room, 2 * room).collidepoint(pixel.real, pixel.imag))
