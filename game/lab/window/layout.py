"""How the lab's window is divided: head, world, words, and the side with the controls; in a lecture room without it."""

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
"""Height of the title and the idea; their height where the width beside the controls is below the third number. In units."""
_LINES, _MORE_LINES = 8.2, 9.3
"""Lines of formula and notes; their number in a narrow window."""
_LINE = 1.25
"""Height of a line of text, in units."""
_SIDE = 20.0
"""Width of the side, in units."""
_MOST_PEN = 1.6
"""Lines and points grow with the text up to this."""
_PRESENTED_HEAD, _PRESENTED_WORDS = 1.6, 3.8
"""Heights in a lecture room, in units: of the head, and of the words; of these no more than fit are shown."""


class WindowLayout(NamedTuple):
    """Where everything is, pixels.

    unit: size of body text, the measure of all spacing. head: title and idea. world: the picture, all its panes.
    words: formula, cited line and note. side: sliders and buttons.
    focus: the part of the world in which the scene is shown whole, free of other things. pen: the measure of lines and points.
    presents: whether it is for a lecture room.
    """

    size: tuple[int, int]
    unit: float
    head: pygame.Rect
    world: pygame.Rect
    words: pygame.Rect
    side: pygame.Rect
    focus: pygame.Rect
    pen: float
    presents: bool = False

    @property
    def letters(self) -> float:
        """Size of words in the world, in pens."""
        return self.unit / self.pen * (1.0 if self.presents else 0.95)


def layout_of(size: tuple[int, int], scale: float | None = None, text: float = 1.0) -> WindowLayout:
    """The division of a surface of that size, pixels. scale: of a lecture room's text; None for the window with controls.

    text: how much larger than usual the player wants the controls' texts; the side is wider then, as far as the picture allows.
    """
    width, height = max(size[0], _SMALLEST[0]), max(size[1], _SMALLEST[1])
    unit = max(unit_of((width, height)) * _BODY, _LEAST)
    if scale is not None:
        return _presented((width, height), unit, scale)
    side = min(max(round(unit * _SIDE * text), round(width * 0.24)), round(width * 0.4))
    left = width - side
    head_units, lines = (_HEAD, _LINES) if left > _NARROW * unit else (_TALL_HEAD, _MORE_LINES)
    head, words = round(unit * head_units), round(unit * (_LINE * lines + 1.0))
    world = pygame.Rect(0, head, left, max(height - head - words, 1))
    return WindowLayout(
        (width, height),
        unit,
        pygame.Rect(0, 0, left, head),
        world,
        pygame.Rect(0, height - words, left, words),
        pygame.Rect(left, 0, side, height),
        world,
        unit,
    )


def _presented(size: tuple[int, int], body: float, scale: float) -> WindowLayout:
    """The picture fills the screen; head and words lie over it. body: size of the text in the window, pixels."""
    (width, height), unit = size, body * scale
    head = round(unit * _PRESENTED_HEAD)
    words = min(round(unit * _PRESENTED_WORDS), height // 2)
    return WindowLayout(
        size,
        unit,
        pygame.Rect(0, 0, width, head),
        pygame.Rect(0, 0, width, height),
        pygame.Rect(0, height - words, width, words),
        pygame.Rect(width, 0, 0, height),
        pygame.Rect(0, head, width, max(height - head - words, 1)),
        body * min(scale, _MOST_PEN),
        presents=True,
    )


def pane_areas(layout: WindowLayout, count: int) -> list[pygame.Rect]:
    """The world's area in so many equal parts, side by side."""
    return _columns(layout.world, count)


def focus_areas(layout: WindowLayout, count: int) -> list[pygame.Rect]:
    """The part of each pane in which its scene is shown whole."""
    return _columns(layout.focus, count)


def _columns(area: pygame.Rect, count: int) -> list[pygame.Rect]:
    """An area in equal parts, side by side."""
    width = area.width / count
    return [
        pygame.Rect(area.left + round(k * width), area.top, round((k + 1) * width) - round(k * width), area.height)
        for k in range(count)
    ]
