"""The figures of a game that the player reads. No window, no page."""

from typing import NamedTuple

from game.effects import Streak
from game.effects.streaks import NO_STREAK
from game.language import tr
from game.levels import number_of
from game.rules import Game, layers_left


class Readings(NamedTuple):
    """The figures, as they are shown.

    score, combo, lives: of the game.
    level_number: from 1. level_count, level_name: of all levels, and of this one.
    layers: left to be broken.
    muted: whether the sound is off.
    badge: what kind of game this is, when it is not simply played.
    streak: the bricks in a row with their effect; NO_STREAK for players who want none, who see the combo alone.
    """

    score: int
    combo: int
    lives: int
    level_number: int
    level_count: int
    level_name: str
    layers: int
    muted: bool = False
    badge: str = ""
    streak: Streak = NO_STREAK


def readings(game: Game, streak: Streak = NO_STREAK, *, muted: bool = False, badge: str = "") -> Readings:
    """The figures of a game. The other arguments are those of `Readings`."""
    number, count = number_of(game.level, game.levels)
    left = layers_left(game)
    return Readings(game.score, game.combo, game.lives, number, count, tr(game.level.name), left, muted, badge, streak)
