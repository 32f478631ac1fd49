"""Which two ends bound the gap that the ball is in?

Over a gap of a ring, the ball stays in that gap until it touches one of the gap's two ends: every other sector is farther
at every radius. So a search costs the same with any number of sectors.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.narrow_phase import end_angle
from physics.shapes import Ring


class End(NamedTuple):
    """One straight end of a sector, facing the gap the ball is in.

    Attributes:
        slot: of its sector.
        side: +1 the counter-clockwise end of its sector, -1 the clockwise one.
        away: radians from the ball's angle to the end, across the gap; < 0 where the ball is over the sector.
    """

    slot: int
    side: int
    away: float


def angle_of_end(ring: Ring, end: End) -> float:
    """Where an end is, radians, normalised, wherever its ring has turned."""
    return end_angle(ring.angle(end.slot), ring.half_angle, end.side)


def gap_end(ring: Ring, alive: Sequence[int], slot: int, offset: float, side: int, first: int, reach: float) -> End | None:
    """The end that bounds the ball's gap on one side, or None where there is none within reach.

    alive: per slot, 0 where it is empty. slot: the one nearest to the ball. offset: of the ball's angle from that slot's
    middle, radians, > 0 counter-clockwise. side: of the ball, +1 counter-clockwise, -1 clockwise.
    first: 0, or 1 to leave out the nearest slot. reach: radians.
    """
    pitch = math.tau / ring.count
    if side * offset > 0.0:
        first = 1  # the nearest slot's middle lies on the other side
    away = first * pitch - side * offset - ring.half_angle
    for step in range(first, first + ring.count):
        if away > reach:
            return None
        there = (slot + side * step) % ring.count
        if alive[there] != 0:
            return End(there, -side, away)
        away += pitch
    return None
