"""How the lab's window is divided: head, world, words, and the side with the widgets."""

from typing import NamedTuple

import pygame

from game.drawing.camera import unit_of

_BODY = 0.8
"""Size of the lab's text in the game's."""
_LEAST = 14.5
"""Pixels: smaller letters cannot be read from a chair."""
_SMALLEST = (640, 480)
"""Pixels: of a smaller window, the rest is cut off."""
_HEAD, _TALL_HEAD, _NARROW = 5.8, 6.6, 40.0
"""Height of the title and the idea; their height where the width beside the widgets is below the third number. In units."""
_LINES, _MORE_LINES = 8.2, 9.3
"""Lines of formula and notes; their number in a narrow window."""
_LINE = 1.25
"""Height of a line of text, in units."""


class WindowLayout(NamedTuple):
    """Where everything is, pixels.

    unit: size of body text, the measure of all spacing. head: title and idea. world: the picture, all its panes.
    words: formula, cited line and note. side: sliders and buttons.
    """

    size: tuple[int, int]
    unit: float
    head: pygame.Rect
    world: pygame.Rect
    words: pygame.Rect
    side: pygame.Rect


def layout_of(size: tuple[int, int]) -> WindowLayout:
    """The division of a surface of that size, pixels."""
    width, height = max(size[0], _SMALLEST[0]), max(size[1], _SMALLEST[1])
    unit = max(unit_of((width, height)) * _BODY, _LEAST)
    side = min(max(round(unit * 20.0), round(width * 0.24)), round(width * 0.4))
    left = width - side
    head_units, lines = (_HEAD, _LINES) if left > _NARROW * unit else (_TALL_HEAD, _MORE_LINES)
    head, words = round(unit * head_units), round(unit * (_LINE * lines + 1.0))
    return WindowLayout(
        (width, height),
        unit,
        pygame.Rect(0, 0, left, head),
        pygame.Rect(0, head, left, max(height - head - words, 1)),
        pygame.Rect(0, height - words, left, words),
        pygame.Rect(left, 0, side, height),
    )


def pane_areas(layout: WindowLayout, count: int) -> list[pygame.Rect]:
    """The world's area in so many equal parts, side by side."""
    width = layout.world.width / count
    return [
        pygame.Rect(round(k * width), layout.world.top, round((k + 1) * width) - round(k * width), layout.world.height)
        for k in range(count)
    ]
