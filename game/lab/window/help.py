"""The lab's help: what the mouse does, and what the keys do."""

import pygame

from game.drawing.camera import unit_of
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.input.key_names import code_names
from game.lab.window.commands import KEYS, MORE_HELP
from game.screens.toolkit.plate import dim, draw_panel

_COLUMNS = 2
_WIDTH, _KEYS = 52.0, 8.0
"""Of the panel, and of the keys' part of a column, in units."""
_TITLE, _ROW, _FOOT = 2.8, 1.3, 1.9
"""Heights of the title, of a row, and of the last line, in units."""
_LETTERS = 1.0
"""Size of the letters, in units."""


def draw_help(surface: pygame.Surface, theme: Theme, type_: Type) -> None:
    """A panel with the keys over what is drawn already."""
    size = surface.get_size()
    lines = [*MORE_HELP, *[("  ".join(code_names(key.keys)), key.meaning) for key in KEYS]]
    rows = -(-len(lines) // _COLUMNS)
    high = _TITLE + _ROW * rows + _FOOT
    unit = min(unit_of(size), size[0] / (_WIDTH + 1.0), size[1] / (high + 0.5))
    panel = pygame.Rect(0, 0, round(unit * _WIDTH), round(unit * high))
    panel.center = size[0] // 2, size[1] // 2
    dim(surface, theme)
    draw_panel(surface, panel, theme, unit)
    left, top = panel.left + unit * 1.4, panel.top + unit * 0.7
    type_.write(surface, "The lab", unit * 1.8, theme.text, complex(left, top))
    for number, (keys, meaning) in enumerate(lines):
        column, row = divmod(number, rows)
        pixel = complex(left + column * unit * _WIDTH / _COLUMNS, panel.top + unit * (_TITLE + _ROW * row))
        type_.write(surface, keys, unit * _LETTERS, theme.accent, pixel)
        type_.write(surface, meaning, unit * _LETTERS, theme.text, pixel + unit * _KEYS)
    close = "any key or a click closes this panel"
    type_.write(surface, close, unit * 0.9, theme.faint, complex(panel.centerx, panel.bottom - unit * 0.5), "midbottom")
