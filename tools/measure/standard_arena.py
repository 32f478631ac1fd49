"""The arena that every contender of the benchmark plays in: three turning paddles, three rows of bricks, one ball."""

import cmath
import math
from random import Random

from physics import PERMANENT, Arena, Ball, Ring

TICK = 1.0 / 240.0
SPEED = 8.0
BALL_RADIUS = 0.25
GROUND = 12.0
BRICK_ROWS = (2.6, 3.8, 5.0)
PADDLES = Ring(10.0, 0.3, 0.35, 3, 0.0, 0.72)
"""As fast as a level lets them turn: 0.93 of the ball at the rim."""
CHECK_EVERY = 20
"""Ticks between two looks at where the ball is, the same for every contender."""


def arena(per_row: int) -> Arena:
    """The standard arena, with so many bricks in each of the three rows."""
    return _arena(per_row, 0.9, 1)


def closed_arena(per_row: int) -> Arena:
    """The standard arena, with rows that have no gaps and bricks that never break.

    All balls fly the same, to the bit, into however many bricks a row is divided: what differs is the cost of the bricks alone.
    """
    return _arena(per_row, 1.0, PERMANENT)


def _arena(per_row: int, share: float, stacked: int) -> Arena:
    """share: of a row that is brick, the rest is gaps. stacked: layers of each brick."""
    rows = [Ring(radius, 0.4, share * math.pi / per_row, per_row) for radius in BRICK_ROWS]
    layers = (PERMANENT,) * 3, *[(stacked,) * per_row for _ in rows]
    return Arena((served(Random(1)),), (PADDLES, *rows), layers)


def served(chance: Random) -> Ball:
    """A ball between bricks and paddles, somewhere, going somewhere."""
    position, velocity = cmath.rect(7.0, chance.random() * math.tau), cmath.rect(SPEED, chance.random() * math.tau)
    return Ball(position, velocity, BALL_RADIUS)
