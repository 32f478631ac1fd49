"""Angle to unit vector and back, by polynomials: the same bits on every machine.

The C library's `sin`, `cos` and `atan2` differ in the last bit between processors, and a bounce
amplifies one bit to a different game. Both functions here use only `+ - * /`, `math.floor` and
comparisons; both are off by less than 2e-15 (`tests/physics/test_trig.py` measures it with mpmath), and
both are exactly odd about the x axis: mirroring the argument mirrors the result bit for bit.
"""

import math

# pi/2 as a sum of three floats of 33, 33 and 53 bits (Cody and Waite): the products of the first two
# with a quadrant number below 2**20 are exact, so the reduced angle keeps its full precision.
_HALF_PI_HIGH = float.fromhex("0x1.921fb54400000p+0")
_HALF_PI_MIDDLE = float.fromhex("0x1.0b4611a600000p-34")
_HALF_PI_LOW = float.fromhex("0x1.3198a2e037073p-69")
_QUADRANTS_PER_RADIAN = 2.0 / math.pi
_EXACT_RANGE = 2.0**20

# Outside of this range a product of the octants' reduction could underflow or overflow: the point is scaled first.
_SMALL, _LARGE = 2.0**-800, 2.0**800
_GROWTH, _SHRINKAGE = 2.0**600, 2.0**-600

_TAN_22_5_DEG = math.sqrt(2.0) - 1.0
_TAN_11_25_DEG = 0.198912367379658
_TAN_33_75_DEG = 0.6681786379192989


def direction(angle: float) -> complex:
    """Unit vector at an angle in radians, counter-clockwise from the x axis.

    Off by less than 2e-15 for |angle| <= 2**20; larger angles are first folded by the float `math.tau`.

    >>> direction(0.0)
    (1+0j)
    """
    if not -_EXACT_RANGE <= angle <= _EXACT_RANGE:
        angle = angle % math.tau if angle > 0.0 else -(-angle % math.tau)
    turns = angle * _QUADRANTS_PER_RADIAN
    quadrant = math.floor(turns + 0.5) if turns >= 0.0 else -math.floor(0.5 - turns)
    rest = ((angle - quadrant * _HALF_PI_HIGH) - quadrant * _HALF_PI_MIDDLE) - quadrant * _HALF_PI_LOW
    cos, sin = _cos_sin(rest)
    quadrant &= 3
    if quadrant == 0:
        return complex(cos, sin)
    if quadrant == 1:
        return complex(-sin, cos)
    if quadrant == 2:
        return complex(-cos, -sin)
    return complex(sin, -cos)


def angle_of(point: complex) -> float:
    """Angle of a point seen from the origin, radians in [0, 2 pi); 0 for the origin itself. point: in any unit of length.

    The angle lies on the angle grid (`on_angle_grid`), so the mirrored point has exactly the negated angle, 2 pi - angle.

    >>> angle_of(0 - 2j) == 1.5 * math.pi
    True
    """
    x, y = abs(point.real), abs(point.imag)
    angle = math.pi / 2.0 - _first_octant(x, y) if y > x else _first_octant(y, x)
    if point.real < 0.0:
        angle = math.pi - angle
    angle = on_angle_grid(angle)
    return math.tau - angle if point.imag < 0.0 and angle > 0.0 else angle


def on_angle_grid(angle: float) -> float:
    """The multiple of 2**-50 nearest to an angle in [0, 8): moved by at most 4.5e-16.

    2 pi as a float is such a multiple, and so is every float from 4 to 8. Multiples of 2**-50 below 8 fit into a float, so
    sums, differences and negations of angles on the grid, folded to [0, 2 pi), are exact: nothing is lost on passing the
    polar axis, and a mirrored arena stays mirrored to the bit.
    """
    return (angle + 4.0) - 4.0 if angle < 4.0 else angle


def _cos_sin(angle: float) -> tuple[float, float]:
    """Cosine and sine for |angle| <= pi/4: Taylor's series to degree 16 and 15, remainder < 5e-17."""
    s = angle * angle
    cos = 1.0 + s * (
        -1 / 2
        + s
        * (
            1 / 24
            + s
            * (
                -1 / 720
                + s * (1 / 40320 + s * (-1 / 3628800 + s * (1 / 479001600 + s * (-1 / 87178291200 + s / 20922789888000))))
            )
        )
    )
    sin = angle + angle * s * (
        -1 / 6
        + s * (1 / 120 + s * (-1 / 5040 + s * (1 / 362880 + s * (-1 / 39916800 + s * (1 / 6227020800 - s / 1307674368000)))))
    )
    return cos, sin


def _first_octant(y: float, x: float) -> float:
    """Angle of (x, y) with 0 <= y <= x, in [0, pi/4].

    The point is first turned clockwise by 0, 22.5 or 45 degrees, whichever brings it within 11.25
    degrees of the x axis, where the series of the arc tangent to degree 23 leaves less than 1e-18.
    """
    if not _SMALL < x < _LARGE:
        if x == 0.0:
            return 0.0
        scale = _GROWTH if x < 1.0 else _SHRINKAGE
        x, y = x * scale, y * scale
    if y < x * _TAN_11_25_DEG:
        base, z = 0.0, y / x
    elif y < x * _TAN_33_75_DEG:
        base, z = math.pi / 8.0, (y - _TAN_22_5_DEG * x) / (x + _TAN_22_5_DEG * y)
    else:
        base, z = math.pi / 4.0, (y - x) / (x + y)
    s = z * z
    series = -1 / 3 + s * (
        1 / 5
        + s
        * (
            -1 / 7
            + s * (1 / 9 + s * (-1 / 11 + s * (1 / 13 + s * (-1 / 15 + s * (1 / 17 + s * (-1 / 19 + s * (1 / 21 - s / 23)))))))
        )
    )
    return base + (z + z * s * series)
