"""What the player reads while playing: score, combo, lives, level, and how many layers are left."""

from typing import NamedTuple

import pygame

from game.camera import Layout
from game.levels import built_in
from game.palette import Theme
from game.rules import LIVES, Game, bricks_left
from game.shapes2d import draw_dot
from game.text import Type


class Readings(NamedTuple):
    """The figures, as they are shown."""

    score: int
    combo: int
    lives: int
    level_number: int  # from 1
    level_count: int
    level_name: str
    bricks: int
    muted: bool = False
    badge: str = ""  # what kind of game this is, when it is not simply played


def readings(game: Game, *, muted: bool = False, badge: str = "") -> Readings:
    """The figures of a game."""
    levels = built_in() if game.level in built_in() else game.levels
    number = levels.index(game.level) + 1
    return Readings(game.score, game.combo, game.lives, number, len(levels), game.level.name, bricks_left(game), muted, badge)


def draw(surface: pygame.Surface, place: Layout, shown: Readings, theme: Theme, type_: Type) -> None:
    """The figures in the surface's four corners."""
    width, height = place.size
    unit = place.unit
    edge = unit * 0.8
    box = type_.write(surface, "SCORE", unit * 0.9, theme.faint, complex(edge, edge))
    box = type_.write(surface, f"{shown.score:,}", unit * 2.0, theme.text, complex(edge, box.bottom + unit * 0.1))
    if shown.combo > 1:
        _write_combo(surface, place, shown, theme, type_, box)
    right = width - edge
    box = type_.write(surface, "LIVES", unit * 0.9, theme.faint, complex(right, edge), "topright")
    _draw_lives(surface, complex(right, box.bottom + unit * 0.75), unit, shown.lives, theme)
    low = height - edge
    box = type_.write(surface, shown.level_name, unit * 1.3, theme.text, complex(edge, low), "bottomleft")
    number = f"LEVEL {shown.level_number} of {shown.level_count}"
    type_.write(surface, number, unit * 0.9, theme.faint, complex(edge, box.top - unit * 0.2), "bottomleft")
    box = type_.write(surface, "H  help", unit * 0.9, theme.faint, complex(right, low), "bottomright")
    left = f"{shown.bricks} layers left"
    box = type_.write(surface, left, unit * 0.9, theme.text, complex(right, box.top - unit * 0.25), "bottomright")
    state = "   ".join(filter(None, [shown.badge, "sound off (M)" if shown.muted else ""]))
    type_.write(surface, state, unit * 0.9, theme.accent, complex(right, box.top - unit * 0.25), "bottomright")


def _write_combo(
    surface: pygame.Surface, place: Layout, shown: Readings, theme: Theme, type_: Type, under: pygame.Rect
) -> None:
    """The bricks in a row, below the score where there is room, else beside it."""
    text = f"combo x{shown.combo}"
    if place.beside:
        type_.write(surface, text, place.unit * 1.1, theme.accent, complex(under.left, under.bottom + place.unit * 0.2))
    else:
        type_.write(surface, text, place.unit * 1.1, theme.accent, complex(under.right + place.unit, under.centery), "midleft")


def _draw_lives(surface: pygame.Surface, place: complex, unit: float, lives: int, theme: Theme) -> None:
    """A ball per life, from right to left; those lost are hollow."""
    radius = unit * 0.42
    for index in range(max(LIVES, lives)):
        spot = place - complex(radius + index * radius * 2.7, 0.0)
        if index < lives:
            draw_dot(surface, spot, radius, theme.ball)
        else:
            draw_dot(surface, spot, radius, theme.faint)
            draw_dot(surface, spot, radius - max(1.0, unit * 0.08), theme.background)
