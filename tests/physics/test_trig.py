"""Own sine, cosine and arc tangent: measured against mpmath over the whole range, mirrored exactly about the x axis."""

import math
import random

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import angle_of, direction
from physics.trig import on_angle_grid
from physics.vectors import length
from tests.support.strategies import AXES, points, reals

BOUND = 2e-15
BOUND_OF_DIRECTION = 3e-16  # the largest error ever measured is 2.1e-16; a term dropped from the reduction shows here
DIGITS = 40


def error_of_direction(angle):
    """Distance between `direction` and the true unit vector."""
    got = direction(angle)
    with mpmath.workdps(DIGITS):
        return float(abs(mpmath.mpc(got.real, got.imag) - mpmath.expj(mpmath.mpf(angle))))


def error_of_angle(p):
    """Distance between `angle_of` and the true angle, the shorter way round."""
    with mpmath.workdps(DIGITS):
        exact = mpmath.atan2(mpmath.mpf(p.imag), mpmath.mpf(p.real))
        difference = abs(mpmath.mpf(angle_of(p)) - exact)
        return float(min(difference, abs(difference - 2 * mpmath.pi)))


def neighbours(x):
    """A float and the floats next to it."""
    return [math.nextafter(x, -math.inf), x, math.nextafter(x, math.inf)]


def angles_of_every_size(count):
    """Angles drawn evenly from a turn, and evenly in size up to 2**20, of both signs."""
    chance = random.Random(1)
    turn = [chance.random() * math.tau for _ in range(count)]
    sized = [2.0 ** (chance.random() * 60.0 - 40.0) for _ in range(count)]
    return turn + sized + [-x for x in turn + sized]


def borders_of_quadrants():
    """Multiples of pi/4 and their neighbours: where the reduction changes and where it cancels."""
    multiples = [*range(-40, 41), 2**18 - 1, 2**18, 1_335_087, 1_335_088]
    return [x for k in multiples for x in neighbours(k * math.pi / 4.0) if abs(x) <= 2.0**20]


def test_direction_is_within_the_bound_over_a_turn_and_up_to_two_to_the_twenty():
    """The largest error over eight thousand angles of every size."""
    assert max(error_of_direction(x) for x in angles_of_every_size(2000)) < BOUND_OF_DIRECTION


def test_direction_is_within_the_bound_where_the_reduction_cancels():
    """Next to a multiple of pi/2 the reduced angle is all that is left after cancellation, and must be exact."""
    assert max(error_of_direction(x) for x in borders_of_quadrants()) < BOUND_OF_DIRECTION
    assert max(error_of_direction(x) for x in (2.0**20, -(2.0**20))) < BOUND_OF_DIRECTION


@given(st.floats(-(2.0**20), 2.0**20))
def test_direction_is_within_the_bound_for_any_angle(angle):
    """Whatever hypothesis finds, subnormal angles included."""
    assert error_of_direction(angle) < BOUND_OF_DIRECTION


@given(st.floats(-(2.0**20), 2.0**20))
def test_direction_has_length_one(angle):
    """Within a few roundings."""
    assert abs(length(direction(angle)) - 1.0) < 5e-16


@given(st.floats(-1e300, 1e300))
def test_directions_of_opposite_angles_are_mirrored_to_the_bit(angle):
    """direction(-a) is the conjugate of direction(a)."""
    assert direction(-angle) == direction(angle).conjugate()


def test_directions_halfway_between_quadrants_are_mirrored_to_the_bit():
    """Odd multiples of pi/4, where the rounding to a quadrant ties: both signs must round away from 0, or both to it."""
    odd = [k * math.pi / 4.0 for k in range(1, 20_001, 2)]
    assert any((x * (2.0 / math.pi) + 0.5).is_integer() for x in odd)
    assert all(direction(-x) == direction(x).conjugate() for x in odd)


@pytest.mark.parametrize("turns", [1, 1000, 10**6, 10**9])
def test_larger_angles_are_folded_by_the_float_tau(turns):
    """The same turn a billion times later gives the same arrow, but for the rounding of the angle itself."""
    far = turns * math.tau + 1.0
    assert abs(direction(far) - direction(math.fmod(far, math.tau))) < turns * 3e-16 + 1e-15


def test_the_fold_of_large_angles_starts_beyond_two_to_the_twenty():
    """Just beyond, the angle is reduced by the float 2 pi, whose error of 2.4e-16 counts once a turn."""
    beyond = math.nextafter(2.0**20, math.inf)
    assert error_of_direction(beyond) > 1e-12
    assert abs(direction(beyond) - direction(math.fmod(beyond, math.tau))) == 0.0


def points_of_every_kind(count):
    """Points in all octants, at every size from the least float to the greatest."""
    chance = random.Random(2)
    for _ in range(count):
        turn = chance.random() * math.tau
        size = 2.0 ** (chance.random() * 660.0 - 330.0)
        yield complex(size * math.cos(turn), size * math.sin(turn))
    for x in (5e-324, 1.5e-323, 1e-310, 1e-300, 1e-160, 1.0, 1e160, 1e300, 1.7e308):
        for y in (5e-324, 1e-323, 1e-310, 1e-300, 1e-160, 0.3, 1.0, 1e160, 1e300, 1.7e308):
            yield from (complex(x, y), complex(-x, y), complex(x, -y), complex(-x, -y))


def test_angle_of_is_within_the_bound_for_points_of_every_kind():
    """All octants, subnormal and huge coordinates: (3, 1) least floats once had the angle of (2.4, 1)."""
    assert max(error_of_angle(p) for p in points_of_every_kind(4000)) < BOUND


def test_angle_of_is_within_the_bound_where_the_series_changes():
    """Around the borders at 11.25 and 33.75 degrees, the axes and the diagonals, of every octant."""
    slopes = [math.tan(k * math.pi / 16.0) for k in range(8)]
    points = [complex(x, y) for slope in slopes for y in neighbours(slope) for x in (1.0, -1.0)]
    points += [p.conjugate() for p in points] + [complex(p.imag, p.real) for p in points]
    assert max(error_of_angle(p) for p in points) < BOUND


@given(reals(-1e300, 1e300), reals(-1e300, 1e300))
def test_angle_of_is_within_the_bound_for_any_point(x, y):
    """Whatever hypothesis finds."""
    assume((x, y) != (0.0, 0.0))
    assert error_of_angle(complex(x, y)) < BOUND


@given(st.floats(-1e300, 1e300), st.floats(-1e300, 1e300))
def test_the_angle_lies_in_the_half_open_range(x, y):
    """Also a hair below the x axis, where the sum with 2 pi rounds up to it."""
    assert 0.0 <= angle_of(complex(x, y)) < math.tau


@pytest.mark.parametrize("y", [-5e-324, -1e-300, -1e-17, -2e-16, -4.4e-16])
def test_a_point_a_hair_below_the_x_axis_has_angle_zero(y):
    """2 pi less that hair is no float but 2 pi itself."""
    assert angle_of(complex(1.0, y)) == 0.0


@given(st.floats(-1e300, 1e300), st.floats(0.0, 1e300, exclude_min=True))
def test_angles_of_mirrored_points_add_up_to_a_full_turn_to_the_bit(x, y):
    """2 pi less the one is the other, both ways round: no bit is lost on passing the polar axis."""
    p = complex(x, y)
    assert angle_of(p.conjugate()) == (math.tau - angle_of(p)) % math.tau
    assert angle_of(p) == (math.tau - angle_of(p.conjugate())) % math.tau


@given(st.floats(-1e300, 0.0, exclude_max=True))
def test_the_negative_x_axis_has_the_angle_pi(x):
    """Whatever the sign of its zero."""
    assert angle_of(complex(x, 0.0)) == angle_of(complex(x, -0.0)) == math.pi


@given(points(1e6))
def test_the_angle_lies_on_the_angle_grid(p):
    """A whole number of 2**-50 radians, as are its sums and differences with others."""
    angle = angle_of(p)
    assert (angle * 2.0**50).is_integer()
    assert on_angle_grid(angle) == angle


@given(st.floats(0.0, 8.0, exclude_max=True))
def test_the_angle_grid_moves_an_angle_by_half_its_pitch_at_most(angle):
    """Half of 2**-50 radians; the float 2 pi and all floats from 4 to 8 stay where they are."""
    assert abs(on_angle_grid(angle) - angle) <= 2.0**-51
    assert (on_angle_grid(angle) * 2.0**50).is_integer()
    assert angle < 4.0 or on_angle_grid(angle) == angle


@pytest.mark.parametrize("quarter", range(4))
def test_the_axes_have_exact_angles(quarter):
    """A quarter turn each, also for the least and the greatest floats."""
    for size in (5e-324, 1.0, 1.7e308):
        axis = (complex(size, 0.0), complex(0.0, size), complex(-size, 0.0), complex(0.0, -size))[quarter]
        assert angle_of(axis) == AXES[quarter]


@given(reals(-1e-3, 1e-3))
def test_small_angles_are_their_own_sines(angle):
    """sin x = x - x^3/6 keeps the relative precision: a ball near the axis does not jump onto it."""
    assert math.isclose(direction(angle).imag, angle - angle**3 / 6.0, rel_tol=1e-13)


@given(st.floats(0.0, math.tau))
def test_angle_and_direction_are_inverse(angle):
    """There and back within the two bounds, 2 pi excepted, where 0 stands for it."""
    back = angle_of(direction(angle))
    assert min(abs(back - angle), math.tau - abs(back - angle)) < BOUND
