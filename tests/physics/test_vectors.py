"""Products and lengths of plane vectors."""

import math

from hypothesis import given

from physics.vectors import cross, dot, length, quarter_turn, unit
from tests.support.strategies import points, reals


@given(points(), points())
def test_products_are_those_of_complex_numbers(a, b):
    """conj(a) b = dot(a, b) + i cross(a, b)."""
    product = a.conjugate() * b
    scale = 1e-14 * (1.0 + abs(a) * abs(b))
    assert math.isclose(dot(a, b), product.real, rel_tol=0.0, abs_tol=scale)
    assert math.isclose(cross(a, b), product.imag, rel_tol=0.0, abs_tol=scale)


@given(points(), points())
def test_the_scalar_product_commutes_and_the_vector_product_changes_sign(a, b):
    """Both to the bit: a replay does not depend on the order of the factors."""
    assert dot(a, b) == dot(b, a)
    assert cross(a, b) == -cross(b, a)


@given(points())
def test_length_is_the_hypotenuse(a):
    """Up to the rounding of two products, a sum and a root."""
    assert math.isclose(length(a), math.hypot(a.real, a.imag), rel_tol=1e-15, abs_tol=1e-160)


@given(points())
def test_four_quarter_turns_are_none(a):
    """A quarter turn is exact: it is perpendicular, keeps the length, and its fourth power is 1."""
    b = quarter_turn(a)
    assert dot(a, b) == 0.0
    assert length(b) == length(a)
    assert cross(a, b) >= 0.0
    assert quarter_turn(quarter_turn(quarter_turn(b))) == a


@given(points(1.0).filter(lambda a: max(abs(a.real), abs(a.imag)) > 1e-3), reals(-306.0, 99.0))
def test_a_unit_vector_has_length_one_and_the_same_direction_at_every_size(a, exponent):
    """Also where the squares of the components are subnormal or 0: |a| = 1e-160 once gave a normal of length 1.0002."""
    a = a * 10.0**exponent
    n = unit(a)
    assert abs(length(n) - 1.0) < 1e-15
    larger = max(abs(a.real), abs(a.imag))
    turn = complex(a.real / larger, a.imag / larger)
    assert abs(cross(n, turn)) < 1e-15
    assert dot(n, turn) > 0.0


def test_the_shortest_vectors_have_a_direction():
    """5e-324 is the least float there is."""
    assert unit(complex(5e-324, 0.0)) == 1.0
    assert unit(complex(0.0, -5e-324)) == -1j
