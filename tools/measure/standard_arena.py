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
    rows = [Ring(radius, 0.4, 0.9 * math.pi / per_row, per_row) for radius in BRICK_ROWS]
    layers = (PERMANENT,) * 3, *[(1,) * per_row for _ in rows]
    return Arena((served(Random(1)),), (PADDLES, *rows), layers)


def served(chance: Random) -> Ball:
    """A ball between bricks and paddles, somewhere, going somewhere."""
    position, velocity = cmath.rect(7.0, chance.random() * math.tau), cmath.rect(SPEED, chance.random() * math.tau)
    return Ball(position, velocity, BALL_RADIUS)
