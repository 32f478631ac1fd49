"""What hypothesis draws: angles that love the polar axis, balls near rings, rings of every kind."""

import math
from typing import NamedTuple

from hypothesis import strategies as st

from physics import Ball, Ring

AXES = [0.0, math.pi / 2.0, math.pi, 1.5 * math.pi]
NEAR_AXES = sorted({math.nextafter(axis, to) % math.tau for axis in AXES for to in (-10.0, 10.0)} | {*AXES, 1e-17, 5e-324})


def angles():
    """Angles in [0, 2 pi), the axes and their neighbours among them."""
    plain = st.floats(0.0, math.tau, exclude_max=True, allow_subnormal=False)
    return plain | st.sampled_from([angle for angle in NEAR_AXES if angle < math.tau])


def reals(least, most):
    """Finite floats in a range, without the subnormal ones."""
    return st.floats(least, most, allow_nan=False, allow_infinity=False, allow_subnormal=False)


def points(size=10.0):
    """Points of a square around the origin."""
    return st.builds(complex, reals(-size, size), reals(-size, size))


def velocities(size):
    """Vectors of a square around the origin: 0, or long enough for a ball."""
    return points(size).map(lambda v: v if abs(v) > 1e-30 else 0j)


def units():
    """Vectors of length 1."""
    return angles().map(lambda angle: complex(math.cos(angle), math.sin(angle)))


@st.composite
def rings(draw, least_count=1):
    """Rings whose sectors keep at least a hundredth of the pitch free."""
    radius = draw(reals(1.0, 10.0))
    count = draw(st.integers(least_count, 12))
    half_angle = draw(reals(0.02, 0.99)) * math.pi / count
    half_width = draw(reals(0.01, 0.9)) * radius
    friction = draw(reals(0.0, 1.0))
    return Ring(radius, half_width, half_angle, count, draw(angles()), draw(reals(-3.0, 3.0)), friction)


@st.composite
def balls(draw):
    """Balls in an arena of size 12."""
    return Ball(draw(points(12.0)), draw(velocities(20.0)), draw(reals(0.05, 1.0)))


class BesideAnEnd(NamedTuple):
    """A ball whose centre is beside a straight end of a slot's sector, between the two corners."""

    ball: Ball
    ring: Ring
    slot: int
    sign: int  # +1 the counter-clockwise end, -1 the clockwise one
    along: float  # distance from the origin of the foot on the end
    across: float  # distance from the end


@st.composite
def balls_beside_an_end(draw):
    """Balls nearest to the middle of an end, half of them touching it; the ring's sectors are at most half turns."""
    ring = draw(rings(least_count=2))
    slot = draw(st.integers(0, ring.count - 1))
    sign = draw(st.sampled_from([-1, 1]))
    along = ring.inner_radius + draw(reals(0.01, 0.99)) * 2.0 * ring.half_width
    aside = draw(reals(0.01, 0.99)) * min(math.pi / ring.count - ring.half_angle, 1.2)
    across = along * math.tan(aside)
    angle = ring.angle(slot) + sign * (ring.half_angle + aside)
    distance = along / math.cos(aside)
    position = complex(distance * math.cos(angle), distance * math.sin(angle))
    ratio = draw(reals(0.3, 0.99) | reals(1.01, 3.0))
    return BesideAnEnd(Ball(position, draw(velocities(20.0)), across * ratio), ring, slot, sign, along, across)
