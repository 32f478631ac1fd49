"""What hypothesis draws: angles that love the polar axis, balls near rings, rings of every kind."""

import math

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


def units():
    """Vectors of length 1."""
    return angles().map(lambda angle: complex(math.cos(angle), math.sin(angle)))


@st.composite
def rings(draw):
    """Rings whose sectors keep at least a hundredth of the pitch free."""
    radius = draw(reals(1.0, 10.0))
    count = draw(st.integers(1, 12))
    half_angle = draw(reals(0.02, 0.99)) * math.pi / count
    half_width = draw(reals(0.01, 0.9)) * radius
    friction = draw(reals(0.0, 1.0))
    return Ring(radius, half_width, half_angle, count, draw(angles()), draw(reals(-3.0, 3.0)), friction)


@st.composite
def balls(draw):
    """Balls in an arena of size 12."""
    return Ball(draw(points(12.0)), draw(points(20.0)), draw(reals(0.05, 1.0)))
