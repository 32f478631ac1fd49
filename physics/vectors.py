"""Products and lengths of plane vectors, written as `complex`, the same bits on every machine.

Complex `*` and `abs()` may be contracted or rounded differently from one platform to the next;
these three use only `+ - *` and `math.sqrt` on floats, which IEEE 754 fixes to the last bit.
"""

import math

# Below 1e-146 the squares in a length are subnormal and lose their bits, below 1e-162 all of them; grown by a power
# of two, which changes no bit, even the shortest float has a square of full precision.
_SQUARES_LOSE_BITS = 1e-140
_GROWTH = 2.0**600


def dot(a: complex, b: complex) -> float:
    """Scalar product of two vectors, in the product of their units.

    >>> dot(3 + 4j, 2 + 1j)
    10.0
    """
    return a.real * b.real + a.imag * b.imag


def cross(a: complex, b: complex) -> float:
    """Third component of the vector product, in the product of the units: > 0 when b points counter-clockwise of a.

    >>> cross(1 + 0j, 0 + 2j)
    2.0
    """
    return a.real * b.imag - a.imag * b.real


def length(a: complex) -> float:
    """Euclidean length, in the unit of a.

    >>> length(3 - 4j)
    5.0
    """
    return math.sqrt(a.real * a.real + a.imag * a.imag)


def unit(a: complex) -> complex:
    """The vector of length 1 along a, which must not be 0.

    >>> unit(3 - 4j)
    (0.6-0.8j)
    """
    size = length(a)
    if size < _SQUARES_LOSE_BITS:
        a = a * _GROWTH
        size = length(a)
    return complex(a.real / size, a.imag / size)


def quarter_turn(a: complex) -> complex:
    """The vector turned counter-clockwise by a quarter, exactly.

    >>> quarter_turn(3 + 1j)
    (-1+3j)
    """
    return complex(-a.imag, a.real)
