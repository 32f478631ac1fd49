"""The lab's help: what the mouse does, and what the keys do."""

import pygame

from game.drawing.camera import unit_of
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.input.key_names import code_names
from game.lab.window.commands import KEYS, MORE_HELP
from game.screens.toolkit.plate import dim, draw_panel


def draw_help(surface: pygame.Surface, theme: Theme, type_: Type) -> None:
    """A panel with the keys over what is drawn already."""
    size = surface.get_size()
    unit = unit_of(size)
    lines = [*MORE_HELP, *[("  ".join(code_names(key.keys)), key.meaning) for key in KEYS]]
    width, height = unit * 30.0, unit * (5.6 + 1.3 * len(lines))
    panel = pygame.Rect(round((size[0] - width) / 2), round((size[1] - height) / 2), round(width), round(height))
    dim(surface, theme)
    draw_panel(surface, panel, theme, unit)
    left, top = panel.left + unit * 2.0, panel.top + unit * 1.0
    type_.write(surface, "The lab", unit * 2.0, theme.text, complex(left, top))
    for number, (keys, meaning) in enumerate(lines):
        y = top + unit * (2.8 + 1.3 * number)
        type_.write(surface, keys, unit * 1.05, theme.accent, complex(left, y))
        type_.write(surface, meaning, unit * 1.05, theme.text, complex(left + unit * 9.0, y))
    close = "any key or a click closes this panel"
    type_.write(surface, close, unit * 0.95, theme.faint, complex(panel.centerx, panel.bottom - unit * 0.6), "midbottom")
