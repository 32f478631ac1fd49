"""Polar coordinates and the arithmetic of angles (the source: "Implementation notes").

Angles are radians, counter-clockwise. The source asks for angles to be normalised before they are compared, and proposes
to do so in the conversion to polar coordinates and in the operators for addition and subtraction. That is done here, and
nowhere else. The comparisons (`signed_difference`, `min_difference`, `on_left`) assert that it was done.
"""

import math

from physics.trig import angle_of, direction, on_angle_grid
from physics.vectors import length


def normalize_angle(angle: float) -> float:
    """The same angle in [0, 2 pi), half-open also in floating point.

    angle: radians, finite. `-1e-17 % tau` rounds to `tau` itself; the result here is 0.

    >>> normalize_angle(-1e-17), normalize_angle(math.tau)
    (0.0, 0.0)
    """
    angle %= math.tau
    return angle if angle < math.tau else 0.0


def add_angles(a: float, b: float) -> float:
    """a + b, normalised to [0, 2 pi). a, b: radians, normalised.

    The angles are first put on the angle grid, where their sum is exact.

    >>> add_angles(1.5 * math.pi, math.pi) == math.pi / 2.0
    True
    """
    rest = on_angle_grid(a) - (math.tau - on_angle_grid(b))
    return rest if rest >= 0.0 else rest + math.tau


def subtract_angles(a: float, b: float) -> float:
    """a - b, normalised to [0, 2 pi): how far one turns counter-clockwise from b to reach a. a, b: radians, normalised.

    The angles are first put on the angle grid, where their difference is exact.

    >>> subtract_angles(math.pi / 2.0, math.pi) == 1.5 * math.pi
    True
    """
    rest = on_angle_grid(a) - on_angle_grid(b)
    return rest if rest >= 0.0 else rest + math.tau


def signed_difference(a: float, b: float) -> float:
    """a - b by the shorter way round, in (-pi, pi]: > 0 when a lies counter-clockwise of b. a, b: radians, normalised.

    >>> round(signed_difference(0.1, math.tau - 0.1), 12)
    0.2
    """
    assert 0.0 <= a < math.tau, a
    assert 0.0 <= b < math.tau, b
    difference = a - b
    if difference > math.pi:
        return difference - math.tau
    return difference + math.tau if difference <= -math.pi else difference


def min_difference(a: float, b: float) -> float:
    """Angle between two directions by the shorter way round, in [0, pi]. a, b: radians, normalised.

    >>> round(min_difference(math.tau - 0.1, 0.1), 12)
    0.2
    """
    return abs(signed_difference(a, b))


def on_left(a: float, b: float) -> bool:
    """Whether a lies counter-clockwise of b by less than half a turn; never true for a = b. a, b: radians, normalised.

    >>> on_left(0.1, math.tau - 0.1), on_left(math.tau - 0.1, 0.1)
    (True, False)
    """
    difference = signed_difference(a, b)
    return 0.0 < difference < math.pi


def to_polar(p: complex) -> tuple[float, float]:
    """(radius, angle) of a point: the radius in the unit of the point, the angle in radians in [0, 2 pi), 0 for the origin.

    >>> to_polar(-2 + 0j) == (2.0, math.pi)
    True
    """
    return length(p), angle_of(p)


def to_cartesian(radius: float, angle: float) -> complex:
    """The point at a radius, in any unit of length, and an angle in radians (any angle, normalised or not).

    Angles above pi are taken as negative ones, so that angles mirrored about the x axis give mirrored points to the bit.

    >>> to_cartesian(2.0, 0.0)
    (2+0j)
    """
    return direction(angle - math.tau if math.pi < angle < math.tau else angle) * radius
