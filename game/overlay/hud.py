"""What the player reads while playing: score, combo, lives, level, and how many layers are left."""

from typing import NamedTuple

import pygame

from game.drawing.camera import Layout
from game.drawing.palette import Theme, mixed
from game.drawing.primitives import draw_dot
from game.drawing.text import Type, stepped
from game.effects import Streak
from game.effects.streaks import BUMP_TICKS, ENDED_TICKS, NO_ROW
from game.input.key_names import key_name
from game.input.keys import Action
from game.levels import built_in
from game.rules import BEST_COMBO, LIVES, Game, bricks_left

_BUMP = 0.45
"""How much larger the combo is when it has just risen."""


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
    streak: Streak = NO_ROW  # the bricks in a row as they are felt; the combo alone for players who want no effects


def readings(game: Game, streak: Streak = NO_ROW, *, muted: bool = False, badge: str = "") -> Readings:
    """The figures of a game."""
    levels = built_in() if game.level in built_in() else game.levels
    number = levels.index(game.level) + 1
    left = bricks_left(game)
    return Readings(game.score, game.combo, game.lives, number, len(levels), game.level.name, left, muted, badge, streak)


def draw(surface: pygame.Surface, place: Layout, shown: Readings, theme: Theme, type_: Type) -> None:
    """The figures in the surface's four corners."""
    width, height = place.size
    unit = place.unit
    edge = unit * 0.8
    box = type_.write(surface, "SCORE", unit * 0.9, theme.faint, complex(edge, edge))
    box = type_.write(surface, f"{shown.score:,}", unit * 2.0, theme.text, complex(edge, box.bottom + unit * 0.1))
    streak = shown.streak if shown.streak.bricks else Streak(shown.combo, BUMP_TICKS)
    if streak.bricks > 1:
        _draw_combo(surface, place, streak, theme, type_, box)
    right = width - edge
    box = type_.write(surface, "LIVES", unit * 0.9, theme.faint, complex(right, edge), "topright")
    _draw_lives(surface, complex(right, box.bottom + unit * 0.75), unit, shown.lives, theme)
    low = height - edge
    box = type_.write(surface, shown.level_name, unit * 1.3, theme.text, complex(edge, low), "bottomleft")
    number = f"LEVEL {shown.level_number} of {shown.level_count}"
    type_.write(surface, number, unit * 0.9, theme.faint, complex(edge, box.top - unit * 0.2), "bottomleft")
    box = type_.write(surface, f"{key_name(Action.HELP)}  help", unit * 0.9, theme.faint, complex(right, low), "bottomright")
    left = f"{shown.bricks} layers left"
    box = type_.write(surface, left, unit * 0.9, theme.text, complex(right, box.top - unit * 0.25), "bottomright")
    state = "   ".join(filter(None, [shown.badge, "sound off (M)" if shown.muted else ""]))
    type_.write(surface, state, unit * 0.9, theme.accent, complex(right, box.top - unit * 0.25), "bottomright")


def _draw_combo(surface: pygame.Surface, place: Layout, streak: Streak, theme: Theme, type_: Type, score: pygame.Rect) -> None:
    """The bricks in a row and a dot for each that raises the points, below the score where there is room, else beside it."""
    unit, best = place.unit, min(streak.bricks, BEST_COMBO)
    corner = complex(score.left, score.bottom + unit * 0.3) if place.beside else complex(score.right + unit, score.top)
    fade = streak.age / ENDED_TICKS if streak.ended else 0.0
    colour = mixed(theme.faint if streak.ended else theme.accent, theme.background, fade)
    middle = corner + 1j * unit * 1.1
    bump = 0.0 if streak.ended else _BUMP * max(1.0 - streak.age / BUMP_TICKS, 0.0) ** 2
    size = unit * stepped((1.2 + 0.12 * best) * (1.0 + bump))
    type_.write(surface, f"combo x{streak.bricks}", size, colour, middle, "midleft")
    radius = unit * 0.24
    for index in range(BEST_COMBO):
        spot = corner + complex(radius + index * unit * 0.72, unit * 2.6)
        draw_dot(surface, spot, radius, colour if index < best else theme.panel_edge)
        if index >= best:
            draw_dot(surface, spot, radius - max(1.0, unit * 0.07), theme.background)


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
