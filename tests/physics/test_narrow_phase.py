"""Contact with one sector: the foot of the perpendicular, and the two cases of the source."""

import math

import pytest
from hypothesis import assume, given

from physics import (
    Feature,
    angle_of,
    closest_point_on_line,
    contact,
    direction,
    dot,
    length,
    narrow_phase_case_1,
    narrow_phase_case_2,
)
from tests.support.oracles import source_oracle
from tests.support.strategies import angles, balls_beside_an_end, points, reals, units

LINES = {
    "level": (1 + 2j, 5 + 2j),
    "upright": (1 - 3j, 1 + 5j),
    "rising": (-2 - 2j, 6 + 4j),
    "falling": (6 - 4j, -2 + 2j),
    "short": (1 + 1j, 1 + 1j + 2.0**-40 * (1 + 1j)),
}
ASIDE = [-3.0, -1.0, 0.0, 1.0, 3.0]


@pytest.mark.parametrize("aside", ASIDE)
@pytest.mark.parametrize("line", LINES)
class TestClosestPointOnLine:
    """Every configuration of the line's points and the reference point, on both sides of the line and on it.

    The coordinates are small binary fractions, so every foot is exact. `aside` is measured in lengths of AB.
    """

    def reference(self, line, along, aside):
        """The point `along` the way from A to B and `aside` of it."""
        a, b = LINES[line]
        return a, b, a + (b - a) * along + (b - a) * 1j * aside

    def test_before_a_it_is_a(self, line, aside):
        """Half a length before."""
        a, b, p = self.reference(line, -0.5, aside)
        assert closest_point_on_line(a, b, p) == a

    def test_at_a_it_is_a(self, line, aside):
        """On the border of the clamp."""
        a, b, p = self.reference(line, 0.0, aside)
        assert closest_point_on_line(a, b, p) == a

    @pytest.mark.parametrize("along", [0.125, 0.5, 0.875])
    def test_between_it_is_the_foot_of_the_perpendicular(self, line, aside, along):
        """Wherever between."""
        a, b, p = self.reference(line, along, aside)
        assert closest_point_on_line(a, b, p) == a + (b - a) * along

    def test_at_b_it_is_b(self, line, aside):
        """On the other border."""
        a, b, p = self.reference(line, 1.0, aside)
        assert closest_point_on_line(a, b, p) == b

    def test_beyond_b_it_is_b(self, line, aside):
        """Half a length beyond."""
        a, b, p = self.reference(line, 1.5, aside)
        assert closest_point_on_line(a, b, p) == b


@given(points(), points())
def test_a_line_of_no_length_is_its_point(a, p):
    """A = B: no division by 0, and p = A as well."""
    assert closest_point_on_line(a, a, p) == a
    assert closest_point_on_line(a, a, a) == a


@given(points(), points())
def test_an_end_is_nearest_to_itself(a, b):
    """p = A gives A, p = B gives B, to the bit."""
    assume(a == b or abs(b - a) > 1e-100)  # the square of a shorter length is 0
    assert closest_point_on_line(a, b, a) == a
    assert closest_point_on_line(a, b, b) == b


@given(points(), points(), points())
def test_no_point_of_the_segment_is_nearer(a, b, p):
    """Brute force over a hundred of them; and the point found is on the segment."""
    found = closest_point_on_line(a, b, p)
    assert min(abs(p - (a + (b - a) * (k / 100))) for k in range(101)) >= abs(p - found) - 1e-13
    assert abs(abs(found - a) + abs(found - b) - abs(b - a)) < 1e-7 * (1e-6 + abs(b - a))


@given(points(), points(), points())
def test_the_segment_has_no_direction(a, b, p):
    """From A to B or from B to A, the nearest point is the same."""
    assert abs(closest_point_on_line(a, b, p) - closest_point_on_line(b, a, p)) < 1e-13


@given(points(), points(), points())
def test_between_the_ends_the_clamped_foot_is_the_sources(a, b, p):
    """The source's endless line and the segment differ beyond the ends only."""
    assume(abs(b - a) > 1e-3)
    share = dot(p - a, b - a) / dot(b - a, b - a)
    expected = source_oracle.closest_point_on_line(a, b, p)
    if 0.0 <= share <= 1.0:
        assert abs(closest_point_on_line(a, b, p) - expected) < 1e-12
    else:
        assert closest_point_on_line(a, b, p) in (a, b)


@given(units(), reals(0.0, 20.0), reals(0.1, 20.0))
def test_case_1_points_away_from_the_middle_radius(way, distance, radius):
    """Inwards for a ball inside of it, outwards for a ball outside: the gap grows along the normal."""
    p = way * distance
    n = narrow_phase_case_1(p, radius)
    assert abs(length(n) - 1.0) < 1e-15
    closer = abs(length(p + n * 1e-3) - radius) < abs(length(p) - radius)
    assert not closer or distance < 1e-3


@given(units(), reals(1e-3, 20.0), reals(0.1, 20.0))
def test_case_1_is_the_sources(way, distance, radius):
    """For every ball off the centre and not, by rounding, on the middle radius."""
    assume(abs(distance - radius) > 1e-12)
    p = way * distance
    assert abs(narrow_phase_case_1(p, radius) - source_oracle.narrow_phase_case_1(p, radius)) < 1e-15


def test_at_the_middle_radius_case_1_points_outwards():
    """The source's < leaves |p| = r_p to the outside."""
    assert narrow_phase_case_1(3 + 4j, 5.0) == 0.6 + 0.8j
    assert narrow_phase_case_1(3 + 4j, math.nextafter(5.0, 6.0)) == -0.6 - 0.8j


@pytest.mark.parametrize("p", [0j, complex(-0.0, 0.0), complex(0.0, -0.0), complex(-0.0, -0.0)])
def test_at_the_centre_case_1_has_a_normal_too(p):
    """The bearing of the origin is 0 by convention; the source divides by 0."""
    assert narrow_phase_case_1(p, 5.0) == -1.0


@given(angles(), reals(-323.0, -100.0))
def test_next_to_the_centre_the_normal_is_still_a_unit_vector(angle, exponent):
    """Where the square of the distance is subnormal or 0."""
    size = 10.0**exponent
    p = complex(math.cos(angle) * size, math.sin(angle) * size)
    assert abs(length(narrow_phase_case_1(p, 5.0)) - 1.0) < 1e-15


# A sector from -0.5 to 0 radians has its counter-clockwise end exactly on the x axis, from 8 to 12; its mirror image from
# 0 to 0.5 has its clockwise end there. What is above the axis for the one is below it for the other.
ENDS = [-1, 1]


def case_2(p, ball_radius, end):
    """Case 2 for the end on the x axis, seen from the gap: above the axis for end = +1, below it for end = -1."""
    p = complex(p.real, p.imag * end)
    return narrow_phase_case_2(p, ball_radius, angle_of(p), 10.0, (-0.25 * end) % math.tau, 2.0, 0.25)


@pytest.mark.parametrize("end", ENDS)
class TestCase2:
    """Both ends, both corners of each, touching and at distance 0. Distances are Pythagorean, so they are exact."""

    def test_beside_the_end_the_normal_is_the_ends_own(self, end):
        """Perpendicular, into the gap."""
        assert case_2(10 + 0.25j, 0.5, end) == 1j * end
        assert case_2(8.5 + 0.25j, 0.5, end) == 1j * end

    @pytest.mark.parametrize("corner", [8.0, 12.0])
    def test_beyond_a_corner_the_normal_comes_from_the_corner(self, end, corner):
        """(ball centre - corner) / distance, for the inner corner and the outer."""
        outward = math.copysign(1.0, corner - 10.0)
        n = case_2(corner + outward * 0.1875 + 0.25j, 0.5, end)
        assert n == complex(0.6 * outward, 0.8 * end)

    @pytest.mark.parametrize("corner", [8.0, 12.0])
    def test_at_the_height_of_a_corner_both_answers_are_one(self, end, corner):
        """On the border between end and corner, and a rounding to either side."""
        for x in (math.nextafter(corner, 0.0), corner, math.nextafter(corner, 20.0)):
            assert abs(case_2(complex(x, 0.25), 0.5, end) - 1j * end) < 1e-14

    def test_a_ball_that_touches_the_end_is_no_contact_yet(self, end):
        """The source's open interval: |p - q| < r."""
        assert case_2(10 + 0.25j, 0.25, end) is None
        assert case_2(10 + 0.25j, math.nextafter(0.25, 1.0), end) == 1j * end

    @pytest.mark.parametrize("corner", [8.0, 12.0])
    def test_a_ball_that_touches_a_corner_is_no_contact_yet(self, end, corner):
        """The same border, round the corner."""
        p = corner + math.copysign(0.1875, corner - 10.0) + 0.25j
        assert case_2(p, 0.3125, end) is None
        assert case_2(p, math.nextafter(0.3125, 1.0), end) is not None

    def test_far_away_there_is_no_contact(self, end):
        """Beside the end, and along its line: the line ends at the corners."""
        for p in (10 + 3j, 13 + 0.1j, 7 + 0.1j, 20 + 0.01j, 0.1 + 0.01j):
            assert case_2(p, 0.5, end) is None

    @pytest.mark.parametrize("x", [8.0, 9.0, 10.0, 12.0])
    def test_at_distance_0_the_normal_is_the_ends_own(self, end, x):
        """On the end and on its corners, where the source has none."""
        theta, angle = (1e-9 * end) % math.tau, (-0.25 * end) % math.tau
        found = narrow_phase_case_2(complex(x, 0.0), 0.5, theta, 10.0, angle, 2.0, 0.25)
        assert found == 1j * end
        assert source_oracle.narrow_phase_case_2(complex(x, 0.0), 0.5, theta, 10.0, -0.25 * end, 2.0, 0.25) in (None, 1j * end)

    def test_a_hair_behind_the_end_the_normal_still_leads_into_the_gap(self, end):
        """Case 2 is for a ball before the end: that it is behind it can be rounding only."""
        theta, angle = (1e-9 * end) % math.tau, (-0.25 * end) % math.tau
        found = narrow_phase_case_2(complex(10.0, -1e-17 * end), 0.5, theta, 10.0, angle, 2.0, 0.25)
        assert found == 1j * end


@given(balls_beside_an_end())
def test_case_2_is_the_sources_beside_the_end_of_a_narrow_sector(beside):
    """The same end, the same normal, the same distance at which there is none."""
    ball, ring = beside.ball, beside.ring
    sector = ring.radius, ring.angle(beside.slot), ring.half_width, ring.half_angle
    arguments = ball.position, ball.radius, angle_of(ball.position), *sector
    found, expected = narrow_phase_case_2(*arguments), source_oracle.narrow_phase_case_2(*arguments)
    assert (found is None) == (expected is None) == (beside.across >= ball.radius)
    if found is not None:
        assert abs(found - expected) < 1e-10


@given(balls_beside_an_end())
def test_the_contact_with_an_end_is_where_it_was_built(beside):
    """The foot at `along`, the gap `across` less the ball's radius, the normal into the gap."""
    ball, ring, slot, sign, along, across = beside
    found = contact(ball, ring, slot)
    end = direction(ring.angle(slot) + sign * ring.half_angle)
    assert found.feature is Feature.END
    assert abs(found.point - end * along) < 1e-12
    assert abs(found.gap - (across - ball.radius)) < 1e-12 * (1.0 + across)
    assert abs(found.normal - end * 1j * sign) < 1e-14
