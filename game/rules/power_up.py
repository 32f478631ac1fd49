"""Power-ups: their kinds, those that drift, and those that last."""

from enum import IntEnum
from typing import NamedTuple

TICKS_PER_SECOND = 240


class PowerUp(IntEnum):
    """What a brick may leave.

    MULTI_BALL: two more balls. WIDE, NARROW: the paddles' width. SLOW, FAST: the balls' speed. STICKY: a paddle holds a ball
    that it catches. LIFE: one more. SHIELD: a ring at the rim that returns one ball. PIERCE: balls fly through bricks and
    break them.
    """

    MULTI_BALL = 0
    WIDE = 1
    NARROW = 2
    SLOW = 3
    FAST = 4
    STICKY = 5
    LIFE = 6
    SHIELD = 7
    PIERCE = 8


LASTING = {
    PowerUp.WIDE: 20 * TICKS_PER_SECOND,
    PowerUp.NARROW: 12 * TICKS_PER_SECOND,
    PowerUp.SLOW: 12 * TICKS_PER_SECOND,
    PowerUp.FAST: 10 * TICKS_PER_SECOND,
    PowerUp.STICKY: 20 * TICKS_PER_SECOND,
    PowerUp.SHIELD: 0,
    PowerUp.PIERCE: 6 * TICKS_PER_SECOND,
}
"""Ticks for which a power-up lasts; 0 for the shield, which lasts until a ball hits it. The others act at once."""

OPPOSITES = {
    PowerUp.WIDE: PowerUp.NARROW,
    PowerUp.NARROW: PowerUp.WIDE,
    PowerUp.SLOW: PowerUp.FAST,
    PowerUp.FAST: PowerUp.SLOW,
}
"""Each of these ends the other."""

OF_PADDLES = (PowerUp.WIDE, PowerUp.NARROW, PowerUp.STICKY, PowerUp.SHIELD)
"""Of two players who play against each other, each has these alone; the others act on the balls, which are everybody's."""

HARMFUL = (PowerUp.NARROW, PowerUp.FAST)
"""Those that a player would rather not catch."""


class Drop(NamedTuple):
    """A power-up on its way outward. position: world units; velocity: world units per second."""

    kind: PowerUp
    position: complex
    velocity: complex


class ActivePower(NamedTuple):
    """A power-up that lasts.

    ticks_left: until it ends. ticks_total: how long it lasts from when it was caught. Both are 0 for the shield, which lasts
    until a ball hits it. player: who has it, of two who play against each other; else 0, as for those that act on the balls.
    """

    kind: PowerUp
    ticks_left: int
    ticks_total: int
    player: int = 0

    @property
    def share_left(self) -> float:
        """Share of its time that is left, 0 to 1; 1 for the shield."""
        return self.ticks_left / self.ticks_total if self.ticks_total else 1.0
