"""A few words that say, for a moment, what a key has just changed."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Theme
from game.drawing.raster.primitives import draw_box

_SECONDS = 1.4
# Lengths are in units of text.
_TEXT = 1.1
"""Size of letters."""
_HEIGHT, _MARGIN = 2.2, 1.0
"""Height of the plate, and from the words to its ends."""
_LEFT, _BOTTOM = 0.8, 4.4
"""From the surface's left and lower edges to the plate."""
_BAR_WIDTH, _BAR_HEIGHT = 9.0, 0.5
_CORNER, _EDGE_LINE = 0.6, 0.06
"""Radius of the plate's corners, and width of its edge."""


class Toast(NamedTuple):
    """What was changed.

    text: in words.
    level: how full a bar behind them is, 0 to 1; None for no bar.
    left: seconds that it is still shown.
    """

    text: str
    level: float | None = None
    left: float = _SECONDS


def later(toast: Toast | None, seconds: float) -> Toast | None:
    """The toast some time later; None once it has been shown for its time."""
    if toast is None or toast.left <= seconds:
        return None
    return toast._replace(left=toast.left - max(seconds, 0.0))


def draw(canvas: Canvas, toast: Toast) -> None:
    """The words on a plate in the lower left corner, above the level's name: no ball and no paddle ever comes there."""
    surface, theme, unit = canvas.surface, canvas.theme, canvas.unit
    words = canvas.type.rendered(toast.text, unit * _TEXT, theme.text)
    bar = 0.0 if toast.level is None else _BAR_WIDTH * unit
    margin = _MARGIN * unit
    width = words.get_width() + 2.0 * margin + (bar + margin if bar else 0.0)
    plate = pygame.Rect(0, 0, round(width), round(unit * _HEIGHT))
    plate.bottomleft = (round(unit * _LEFT), round(canvas.size[1] - unit * _BOTTOM))
    draw_box(surface, plate, unit * _CORNER, theme.panel, theme.panel_edge, unit * _EDGE_LINE)
    surface.blit(words, words.get_rect(midleft=(plate.left + round(margin), plate.centery)))
    if toast.level is not None:
        track = pygame.Rect(0, 0, round(bar), round(unit * _BAR_HEIGHT))
        track.midright = (plate.right - round(margin), plate.centery)
        draw_bar(surface, track, toast.level, theme)


def draw_bar(surface: pygame.Surface, track: pygame.Rect, level: float, theme: Theme) -> None:
    """How full something is. track: the whole bar; level: 0 to 1."""
    draw_box(surface, track, track.height / 2.0, theme.panel_edge)
    done = track.copy()
    done.width = round(track.width * level)
    draw_box(surface, done, track.height / 2.0, theme.accent)
