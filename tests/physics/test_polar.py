"""Angles and polar coordinates: the half-open range, and comparisons across the polar axis in both directions."""

import math

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import (
    add_angles,
    min_difference,
    normalize_angle,
    on_left,
    signed_difference,
    subtract_angles,
    to_cartesian,
    to_polar,
)
from physics.tolerances import SMALLEST
from tests.support.strategies import AXES, angles, points, reals

LAST = math.nextafter(math.tau, 0.0)
ANY_ANGLE = st.floats(-1e9, 1e9) | st.sampled_from([-5e-324, -1e-17, -math.tau, math.tau, LAST, -LAST, 4.0 * math.tau])


@given(ANY_ANGLE)
def test_a_normalised_angle_lies_in_the_half_open_range(angle):
    """From 0 included to 2 pi excluded, for any angle however small its distance from 0."""
    assert 0.0 <= normalize_angle(angle) < math.tau


@pytest.mark.parametrize("angle", [-5e-324, -1e-300, -1e-17, -2e-16, -4.4e-16])
def test_a_hair_below_zero_is_zero_not_two_pi(angle):
    """`angle % tau` rounds to `tau` itself, the one number outside of the range."""
    assert angle % math.tau == math.tau
    assert normalize_angle(angle) == 0.0


@given(angles())
def test_normalising_twice_is_normalising_once(angle):
    """An angle in the range is left alone, to the bit."""
    assert normalize_angle(angle) == angle


@given(angles(), st.integers(-(10**6), 10**6))
def test_whole_turns_do_not_count(angle, turns):
    """Adding up to a million turns changes the angle by no more than the roundings of product, sum, folding and comparison."""
    far = angle + turns * math.tau
    assert min_difference(normalize_angle(far), angle) <= 2.0**-53 * (2.0 * abs(far) + 3.0 * math.tau)


@given(angles(), angles())
def test_what_was_added_can_be_subtracted(a, b):
    """(a + b) - b = a round the circle, and both results are normalised."""
    total = add_angles(a, b)
    assert 0.0 <= total < math.tau
    back = subtract_angles(total, b)
    assert 0.0 <= back < math.tau
    assert min_difference(back, a) < 2e-15


@given(angles(), angles())
def test_a_difference_is_how_far_one_turns_counter_clockwise(a, b):
    """a - b is the turn from b to a; the two turns, there and back, make a full one or none."""
    there, back = subtract_angles(a, b), subtract_angles(b, a)
    assert add_angles(there, back) == 0.0


@given(angles(), angles())
def test_the_signed_difference_is_in_range_and_turns_b_into_a(a, b):
    """In (-pi, pi], and b turned by it points where a does."""
    difference = signed_difference(a, b)
    assert -math.pi < difference <= math.pi
    turned = to_cartesian(1.0, b + difference)
    assert abs(turned - to_cartesian(1.0, a)) < 4e-15


@given(angles(), angles())
def test_the_signed_difference_changes_sign_with_its_arguments(a, b):
    """Exactly, but for opposite directions, where pi stands for both ways."""
    difference = signed_difference(a, b)
    if difference == math.pi:
        assert signed_difference(b, a) in {math.pi, -math.pi}
    else:
        assert signed_difference(b, a) == -difference


@given(angles(), angles())
def test_the_minimal_difference_agrees_with_the_angle_between_two_arrows(a, b):
    """It is symmetric, in [0, pi], and the angle between unit vectors (by the length of the chord)."""
    difference = min_difference(a, b)
    assert difference == min_difference(b, a)
    assert 0.0 <= difference <= math.pi
    chord = abs(to_cartesian(1.0, a) - to_cartesian(1.0, b))
    assert abs(2.0 * math.sin(difference / 2.0) - chord) < 2e-15


@given(angles(), reals(1e-9, 3.0))
def test_left_is_counter_clockwise(angle, turn):
    """Turning counter-clockwise by less than half a turn gets on the left, wherever the polar axis is; back, on the right."""
    ahead = add_angles(angle, turn)
    assert on_left(ahead, angle)
    assert not on_left(angle, ahead)


@pytest.mark.parametrize("turn", [1e-12, 1e-3, 0.1, 1.0, 3.0])
@pytest.mark.parametrize("axis", AXES)
def test_comparisons_hold_across_every_axis_in_both_directions(axis, turn):
    """Just before and just after an axis: the same answers at 0 = 2 pi as anywhere else."""
    before, after = subtract_angles(axis, turn / 2.0), add_angles(axis, turn / 2.0)
    assert on_left(after, before)
    assert not on_left(before, after)
    assert min_difference(before, after) == pytest.approx(turn, rel=1e-9, abs=2e-15)
    assert signed_difference(after, before) == pytest.approx(turn, rel=1e-9, abs=2e-15)
    assert signed_difference(before, after) == pytest.approx(-turn, rel=1e-9, abs=2e-15)


@given(angles())
def test_a_direction_is_neither_left_of_itself_nor_of_its_opposite(angle):
    """Both borders of "left" are excluded."""
    assert not on_left(angle, angle)
    opposite = add_angles(angle, math.pi)
    assume(signed_difference(opposite, angle) == math.pi)
    assert not on_left(opposite, angle)


@pytest.mark.parametrize("a", [0.0, LAST])
@pytest.mark.parametrize("b", [0.0, LAST])
def test_the_two_ends_of_the_range_are_neighbours(a, b):
    """0 and the float below 2 pi are one rounding apart."""
    assert min_difference(a, b) < 1e-15


@given(points())
def test_polar_coordinates_lead_back_to_the_point(p):
    """And the angle is already normalised, as the source's notes ask.

    The bound is what the arc tangent (9.3e-16) and the sine (2.1e-16) may be off, and the rounding of the product.
    """
    radius, angle = to_polar(p)
    assert 0.0 <= angle < math.tau
    assert abs(to_cartesian(radius, angle) - p) <= 1.3e-15 * abs(p) + SMALLEST


@given(reals(1e-3, 100.0), angles())
def test_a_point_leads_back_to_its_polar_coordinates(radius, angle):
    """The other way round."""
    again, there = to_polar(to_cartesian(radius, angle))
    assert math.isclose(again, radius, rel_tol=1e-15)
    assert min_difference(there, angle) < 2e-15


def test_the_origin_has_angle_zero():
    """By convention, whatever the signs of its zeros."""
    for x in (0.0, -0.0):
        for y in (0.0, -0.0):
            assert to_polar(complex(x, y)) == (0.0, 0.0)


def test_the_negative_x_axis_has_one_angle():
    """The library's arc tangent answers +pi or -pi by the sign of a zero; here both are pi."""
    assert to_polar(complex(-1.0, 0.0)) == to_polar(complex(-1.0, -0.0)) == (1.0, math.pi)


def test_an_angle_turned_a_hundred_million_ticks_stays_true():
    """normalize_angle of the whole turning equals the exact remainder: nothing accumulates but one rounding."""
    ticks, spin = 10**8, 1.7
    angle = normalize_angle(ticks * (spin / 240.0))
    with mpmath.workdps(50):
        exact = mpmath.fmod(mpmath.mpf(ticks) * mpmath.mpf(spin) / 240, mpmath.mpf(math.tau))
        assert abs(angle - exact) < 2e-10
