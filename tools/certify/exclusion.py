"""Which sectors a flight can come near at all: plain floats, with a margin far above their rounding.

Each bound below is a handful of operations on positive numbers and two functions of the C library, each off by a few units
in the last place, 1e-15 of the largest number that enters. `MARGIN` is a million times that: what is left out is certainly
not touched.
"""

import math
from collections.abc import Iterator

from physics import Ring

MARGIN = 1e-9
"""Fraction of the lengths that enter, and radians."""


def ring_is_far(position: complex, reach: float, ring: Ring) -> bool:
    """Whether no point within `reach` of a position lies in the ring's annulus."""
    distance = math.hypot(position.real, position.imag)
    room = abs(distance - ring.radius) - ring.half_width - reach
    return room > MARGIN * (distance + ring.radius + ring.half_width + reach)


def sectors_near(position: complex, reach: float, ring: Ring, start: float, stop: float) -> Iterator[int]:
    """The slots whose sectors can have a point within `reach` of a position between two moments of the tick.

    A disc of radius s at distance d > s from the centre is seen under asin(s / d) to each side of its bearing; the
    sectors turn by |spin| (stop - start) meanwhile.
    """
    distance = math.hypot(position.real, position.imag)
    if reach * (1.0 + MARGIN) >= distance:
        yield from range(ring.count)
        return
    sight = math.asin(reach / distance) + ring.half_angle + abs(ring.spin) * (stop - start)
    bearing = math.atan2(position.imag, position.real) - ring.phase - ring.spin * start
    margin = MARGIN * (1.0 + abs(bearing))
    for slot in range(ring.count):
        away = abs(math.remainder(bearing - slot * (math.tau / ring.count), math.tau))
        if away <= sight + margin:
            yield slot
