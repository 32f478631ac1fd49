"""Two opinions on a contact, drawn side by side: the game's normal and that of another engine."""

import pygame

from game.drawing.camera import Camera
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.second_opinion import Opinions

_LENGTH = 1.6
"""World units, of the game's normal; the other's is drawn longer and thinner, so that both are seen when they agree."""
_LONGER = 1.45


def draw(surface: pygame.Surface, shown: tuple[Opinions, ...], camera: Camera, theme: Theme, type_: Type, unit: float) -> None:
    """Both normals of every contact, and the angle between them: ours thick, pymunk's thin and longer."""
    caption = "normals: ours thick, pymunk's thin, and the angle between them"
    type_.write(surface, caption, unit * 0.8, theme.faint, complex(surface.get_width() / 2.0, unit * 0.2), "midtop")
    for one in shown:
        start = camera.project(one.point)
        _line(surface, start, camera.project(one.point + one.ours * _LENGTH), theme.accent, max(2, round(unit * 0.22)))
        if one.theirs is not None:
            end = camera.project(one.point + one.theirs * _LENGTH * _LONGER)
            _line(surface, start, end, theme.text, max(1, round(unit * 0.07)))
        label = camera.project(one.point + one.ours * _LENGTH * _LONGER) + 0.8j * unit
        type_.write(surface, one.text, unit * 0.8, theme.text, label, "center")


def _line(surface: pygame.Surface, start: complex, end: complex, colour: tuple[int, int, int], width: int) -> None:
    """A straight line, anti-aliased."""
    ends = (start.real, start.imag), (end.real, end.imag)
    pygame.draw.line(surface, colour, *ends, width)
    pygame.draw.aaline(surface, colour, *ends)
