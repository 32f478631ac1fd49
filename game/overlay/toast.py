"""A few words that say, for a moment, what a key has just changed."""

from typing import NamedTuple

import pygame

from game.drawing.camera import unit_of
from game.drawing.palette import Theme
from game.drawing.primitives import draw_box
from game.drawing.text import Type

_SECONDS = 1.4
_BAR = 9.0
"""Width of a bar, in units of text."""


class Toast(NamedTuple):
    """What was changed."""

    text: str
    level: float | None = None  # a bar's, 0 to 1
    left: float = _SECONDS  # seconds


def later(toast: Toast | None, seconds: float) -> Toast | None:
    """The words some time later; None once they have been seen."""
    if toast is None or toast.left <= seconds:
        return None
    return toast._replace(left=toast.left - max(seconds, 0.0))


def draw(surface: pygame.Surface, toast: Toast, theme: Theme, type_: Type) -> None:
    """The words on a plate in the lower left corner, above the level's name: no ball and no paddle ever comes there."""
    size = surface.get_size()
    unit = unit_of(size)
    words = type_.rendered(toast.text, unit * 1.1, theme.text)
    bar = 0.0 if toast.level is None else _BAR * unit
    plate = pygame.Rect(0, 0, round(words.get_width() + unit * 2.0 + (bar + unit if bar else 0.0)), round(unit * 2.2))
    plate.bottomleft = (round(unit * 0.8), round(size[1] - unit * 4.4))
    draw_box(surface, plate, unit * 0.6, theme.panel, theme.panel_edge, unit * 0.06)
    surface.blit(words, words.get_rect(midleft=(plate.left + round(unit), plate.centery)))
    if toast.level is not None:
        track = pygame.Rect(0, 0, round(bar), round(unit * 0.5))
        track.midright = (plate.right - round(unit), plate.centery)
        draw_bar(surface, track, toast.level, theme)


def draw_bar(surface: pygame.Surface, track: pygame.Rect, level: float, theme: Theme) -> None:
    """How full something is. level: 0 to 1."""
    draw_box(surface, track, track.height / 2.0, theme.panel_edge)
    done = track.copy()
    done.width = round(track.width * level)
    draw_box(surface, done, track.height / 2.0, theme.accent)
