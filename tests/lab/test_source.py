"""What the lab shows as the source's answer is the source's answer."""

import math

from hypothesis import assume, given

from game.lab import source
from tests.support.oracles import source_oracle
from tests.support.strategies import angles, points, reals


@given(reals(-1e6, 1e6))
def test_a_plain_remainder(angle):
    """The lab's plain remainder is the source's; for -1e-17 it is 2π itself."""
    assert source.normalize_angle(angle) == source_oracle.normalize_angle(angle)
    assert source.normalize_angle(-1e-17) == math.tau


@given(angles(), angles())
def test_on_the_left(a, b):
    """The lab's `on_left` is the source's."""
    assert source.on_left(a, b) == source_oracle.on_left(a, b)


@given(points(), points(), points())
def test_the_foot_on_the_endless_line(a, b, p):
    """Wherever A and B differ, the foot on the line is the source's closest point; where A = B there is none."""
    assume(abs(b - a) > 1e-3)
    expected = source_oracle.closest_point_on_line(a, b, p)
    assert abs(source.foot_on_line(a, b, p) - expected) < 1e-6
    assert source.foot_on_line(a, a, p) is None


@given(points(), reals(0.1, 5.0), reals(2.0, 12.0), angles(), reals(0.1, 1.5), reals(0.01, 3.1))
def test_the_normal_of_the_end_that_the_source_looks_at(p, ball_radius, radius, angle, half_width, half_angle):
    """Sign, corners, foot and normal in a row are the source's case 2."""
    assume(p != 0.0)
    theta = source_oracle.to_polar(p)[1]
    sign = source.end_sign(theta, angle, half_angle)
    a, b = source.end_points(radius, half_width, angle + sign * half_angle)
    found = source.end_normal(p, ball_radius, a, b)
    expected = source_oracle.narrow_phase_case_2(p, ball_radius, theta, radius, angle, half_width, half_angle)
    distance = abs(p - source_oracle.closest_point_on_line(a, b, p))
    assume(abs(distance - ball_radius) > 1e-9 and distance > 1e-6)
    assert (found is None) == (expected is None)
    assert found is None or abs(found - expected) < 1e-6
