"""Lines of text at the lower edge of a pane, each in the colour of its role."""

import pygame

from game.drawing.palette import Theme
from game.drawing.text import Type
from game.lab.drawing.colours import text_colour
from game.lab.kit.picture import Pane

_SIZE, _LINE, _EDGE = 0.92, 1.22, 0.6
"""Size of letters and height of a line in units; from the words to the pane's edges."""


def draw_pane_lines(surface: pygame.Surface, area: pygame.Rect, pane: Pane, theme: Theme, type_: Type, unit: float) -> None:
    """The lines of a pane, on a plate over its picture. area: of the pane, pixels. unit: size of body text, pixels."""
    size, edge = unit * _SIZE, unit * _EDGE
    wrapped = [(part, role) for text, role in pane.lines for part in type_.wrapped(text, size, area.width - 2.0 * edge)]
    if not wrapped:
        return
    height = size * _LINE * len(wrapped) + edge
    top = area.bottom - height
    pygame.draw.rect(surface, theme.panel, pygame.Rect(area.left, round(top), area.width, area.bottom - round(top)))
    for number, (text, role) in enumerate(wrapped):
        pixel = complex(area.left + edge, top + edge / 2.0 + size * _LINE * number)
        type_.write(surface, text, size, text_colour(theme, role), pixel)
