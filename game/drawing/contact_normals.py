"""The game's normal of every contact beside another engine's, and the angle between them."""

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour
from game.language import tr
from game.second_opinion import NormalPair

_LENGTH = 1.6
"""World units; length of the game's normal."""
_OTHER_LENGTH = 1.45 * _LENGTH
"""The other engine's normal is longer and thinner than the game's, so that both are seen when they agree."""
_WIDTH, _OTHER_WIDTH = 0.22, 0.07
"""Widths of the two lines, in units."""
_TEXT = 0.8
"""Size of the words, in units."""


def draw(canvas: Canvas, shown: tuple[NormalPair, ...]) -> None:
    """Both normals of every contact, and the angle between them: the game's thick, pymunk's thin and longer."""
    camera, theme, unit = canvas.camera, canvas.theme, canvas.unit
    caption = tr("normals: ours thick, pymunk's thin, and the angle between them")
    canvas.write(caption, _TEXT, theme.faint, complex(canvas.size[0] / 2.0, unit * 0.2), "midtop")
    for pair in shown:
        start = camera.project(pair.point)
        _draw_line(canvas.surface, start, camera.project(pair.point + pair.ours * _LENGTH), theme.accent, _WIDTH * unit, 2)
        if pair.theirs is not None:
            end = camera.project(pair.point + pair.theirs * _OTHER_LENGTH)
            _draw_line(canvas.surface, start, end, theme.text, _OTHER_WIDTH * unit, 1)
        label = camera.project(pair.point + pair.ours * _OTHER_LENGTH) + 0.8j * unit
        canvas.write(pair.text, _TEXT, theme.text, label, "center")


def _draw_line(surface: pygame.Surface, start: complex, end: complex, colour: Colour, width: float, least: int) -> None:
    """A straight line, anti-aliased. width: pixels, at least `least`."""
    ends = (start.real, start.imag), (end.real, end.imag)
    pygame.draw.line(surface, colour, *ends, max(least, round(width)))
    pygame.draw.aaline(surface, colour, *ends)
