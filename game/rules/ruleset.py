"""Which rules a game follows: the source's, or the arcade's at one of three difficulties."""

from enum import IntEnum
from typing import NamedTuple

LIVES = 3
"""Lives of a game under the source's rules, and of one at normal difficulty."""


class Difficulty(IntEnum):
    """How hard the arcade rules make a level."""

    EASY = 0
    NORMAL = 1
    HARD = 2


class Handicap(NamedTuple):
    """What a difficulty changes: the lives, and some of the level's numbers by a factor.

    lives: at the start of the game; at the start of every level, fewer are topped up to as many.
    paddle_width: of a paddle's half angle. ball_speed: of the speed at a serve, and of the speed at which it stops growing.
    drop_chance: of the chance that a broken brick leaves a power-up. turn: of the most that the position of a hit turns a ball.
    shielded: whether every serve begins with a shield.
    """

    lives: int
    paddle_width: float
    ball_speed: float
    drop_chance: float
    turn: float
    shielded: bool = False


_EASY = Handicap(5, 1.3, 0.85, 1.5, 1.0, shielded=True)
_NORMAL = Handicap(LIVES, 1.0, 1.0, 1.0, 1.0)
_HARD = Handicap(LIVES, 0.85, 1.15, 0.75, 1.0)
_HANDICAPS = (_EASY, _NORMAL, _HARD)
"""By `Difficulty`. Not a dictionary: the hash of an enumeration's member is a call, and every tick asks several times."""
_NO_HANDICAP = Handicap(LIVES, 1.0, 1.0, 0.0, 0.0)


class Ruleset(NamedTuple):
    """The rules of a game.

    arcade: False for the source's rules: one speed, no power-ups, no turn by the position of a hit, no wells, and a difficulty
    changes nothing. versus: whether two players play against each other, each with one paddle in a half of the ring; it needs
    the arcade rules.
    """

    difficulty: Difficulty = Difficulty.NORMAL
    arcade: bool = True
    versus: bool = False

    @property
    def handicap(self) -> Handicap:
        """What the difficulty changes; nothing under the source's rules."""
        return _HANDICAPS[self.difficulty] if self.arcade else _NO_HANDICAP


SOURCE_RULES = Ruleset(arcade=False)
