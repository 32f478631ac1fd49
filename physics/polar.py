"""Polar coordinates and the arithmetic of angles (the source: "Implementation notes").

Angles are radians, counter-clockwise. The source asks for angles to be normalised before they are
compared and proposes to do so in the conversion to polar coordinates and in the operators for
addition and subtraction. That is done here, and nowhere else; comparisons assert it.
"""

import math

from physics.trig import angle_of, direction
from physics.vectors import length


def normalize_angle(angle: float) -> float:
    """The same angle in [0, 2 pi), half-open also in floating point.

    `-1e-17 % tau` rounds to `tau` itself; the result here is 0.

    >>> normalize_angle(-1e-17), normalize_angle(math.tau)
    (0.0, 0.0)
    """
    angle %= math.tau
    return angle if angle < math.tau else 0.0


def add_angles(a: float, b: float) -> float:
    """a + b, normalised to [0, 2 pi)."""
    return normalize_angle(a + b)


def subtract_angles(a: float, b: float) -> float:
    """a - b, normalised to [0, 2 pi): how far one turns counter-clockwise from b to reach a."""
    return normalize_angle(a - b)


def signed_difference(a: float, b: float) -> float:
    """a - b by the shorter way round, in (-pi, pi]: > 0 when a lies counter-clockwise of b.

    >>> round(signed_difference(0.1, math.tau - 0.1), 12)
    0.2
    """
    difference = a - b
    if -math.pi < difference <= math.pi:
        return difference
    difference = normalize_angle(difference)
    assert 0.0 <= difference < math.tau, difference
    return difference - math.tau if difference > math.pi else difference


def min_difference(a: float, b: float) -> float:
    """Angle between two directions by the shorter way round, in [0, pi].

    >>> round(min_difference(math.tau - 0.1, 0.1), 12)
    0.2
    """
    return abs(signed_difference(a, b))


def on_left(a: float, b: float) -> bool:
    """Whether a lies counter-clockwise of b by less than half a turn; never true for a = b.

    >>> on_left(0.1, math.tau - 0.1), on_left(math.tau - 0.1, 0.1)
    (True, False)
    """
    difference = signed_difference(a, b)
    return 0.0 < difference < math.pi


def to_polar(p: complex) -> tuple[float, float]:
    """(radius, angle) of a point, the angle in [0, 2 pi); the origin has angle 0.

    >>> to_polar(-2 + 0j) == (2.0, math.pi)
    True
    """
    return length(p), angle_of(p)


def to_cartesian(radius: float, angle: float) -> complex:
    """The point at a radius and an angle in radians (any angle, normalised or not).

    >>> to_cartesian(2.0, 0.0)
    (2+0j)
    """
    return direction(angle) * radius
