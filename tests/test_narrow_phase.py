"""Contact with one sector: the foot of the perpendicular, the two cases, and `contact` against brute force."""

import math

import pytest
import source_oracle
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import angles, balls, balls_beside_an_end, points, reals, rings, units

from physics import (
    Ball,
    Feature,
    Ring,
    angle_of,
    broad_phase,
    closest_point_on_line,
    contact,
    cross,
    direction,
    dot,
    length,
    narrow_phase_case_1,
    narrow_phase_case_2,
    nearest_slot,
    signed_difference,
    to_cartesian,
)
from physics.trig import bearing_of

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
    return narrow_phase_case_2(p, ball_radius, angle_of(p), 10.0, -0.25 * end, 2.0, 0.25)


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
        found = narrow_phase_case_2(complex(x, 0.0), 0.5, 1e-9 * end, 10.0, -0.25 * end, 2.0, 0.25)
        assert found == 1j * end
        theta = (1e-9 * end) % math.tau
        assert source_oracle.narrow_phase_case_2(complex(x, 0.0), 0.5, theta, 10.0, -0.25 * end, 2.0, 0.25) in (None, 1j * end)

    def test_a_hair_behind_the_end_the_normal_still_leads_into_the_gap(self, end):
        """Case 2 is for a ball before the end: that it is behind it can be rounding only."""
        found = narrow_phase_case_2(complex(10.0, -1e-17 * end), 0.5, 1e-9 * end, 10.0, -0.25 * end, 2.0, 0.25)
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


@st.composite
def contacts(draw):
    """A ball, a ring and a slot: near it often enough, inside of the material too."""
    ring = draw(rings())
    slot = draw(st.integers(0, ring.count - 1))
    if draw(st.booleans()):
        return draw(balls()), ring, slot
    distance = ring.radius + draw(reals(-1.5, 1.5)) * ring.half_width
    angle = ring.angle(slot) + draw(reals(-1.5, 1.5)) * ring.half_angle
    return Ball(to_cartesian(distance, angle), draw(points(20.0)), draw(reals(0.05, 1.0))), ring, slot


def boundary(ring, slot, count=60):
    """Points all along the edge of a sector."""
    middle = ring.angle(slot)
    for k in range(count + 1):
        share = 2.0 * k / count - 1.0
        along = direction(middle + share * ring.half_angle)
        yield along * ring.inner_radius
        yield along * ring.outer_radius
        for sign in (-1.0, 1.0):
            yield direction(middle + sign * ring.half_angle) * (ring.radius + share * ring.half_width)


def is_inside(p, ring, slot):
    """Whether a point is in the material of a sector."""
    beside = abs(signed_difference(angle_of(p), ring.angle(slot))) > ring.half_angle
    return not beside and ring.inner_radius < length(p) < ring.outer_radius


@given(contacts())
def test_no_point_of_the_sectors_edge_is_nearer_than_the_contact(case):
    """Brute force all round the edge; from inside the material, it is the least depth."""
    ball, ring, slot = case
    found = contact(ball, ring, slot)
    centre_gap = found.gap + ball.radius
    assert min(abs(ball.position - q) for q in boundary(ring, slot)) >= abs(centre_gap) - 1e-12
    if abs(centre_gap) > 1e-9:
        assert (centre_gap < 0.0) == is_inside(ball.position, ring, slot)


@given(contacts())
def test_the_contact_point_is_on_the_feature_it_names(case):
    """On the arc, on the straight end or on a corner, and as far from the ball as the gap says, along the normal."""
    ball, ring, slot = case
    found = contact(ball, ring, slot)
    assert abs(length(found.normal) - 1.0) < 1e-15
    away = ball.position - found.point
    assert abs(dot(away, found.normal) - (found.gap + ball.radius)) < 1e-12
    assert abs(cross(away, found.normal)) < 1e-12
    distance, offset = length(found.point), abs(signed_difference(angle_of(found.point), ring.angle(slot)))
    radii = {
        Feature.OUTER_FACE: (ring.outer_radius, ring.outer_radius),
        Feature.INNER_FACE: (ring.inner_radius, ring.inner_radius),
        Feature.END: (ring.inner_radius, ring.outer_radius),
        Feature.CORNER: (ring.inner_radius, ring.outer_radius),
    }
    least, most = radii[found.feature]
    assert least - 1e-12 <= distance <= most + 1e-12
    assert offset <= ring.half_angle + 1e-12 / distance
    if found.feature in {Feature.END, Feature.CORNER}:
        assert offset >= ring.half_angle - 1e-12 / distance
    if found.feature is Feature.CORNER:
        assert min(distance - ring.inner_radius, ring.outer_radius - distance) < 1e-12


def near_points(a, b):
    """Whether two contacts' points and normals are one but for rounding, amplified by a short distance to the corner."""
    return abs(a[0] - b[0]) < 1e-9 and abs(a[1] - b[1]) < 1e-9


@given(contacts(), angles())
def test_turning_everything_turns_the_contact(case, turn):
    """Ball and ring together, also across the polar axis: the gap stays, the normal and the point turn along."""
    ball, ring, slot = case
    arrow = direction(turn)
    here = contact(ball, ring, slot)
    there = contact(Ball(ball.position * arrow, 0j, ball.radius), ring._replace(phase=(ring.phase + turn) % math.tau), slot)
    assert abs(here.gap - there.gap) < 1e-12
    # In the material the nearest side may change by rounding, as the farthest bearing may; at the centre there is none.
    opposite = abs(signed_difference(angle_of(ball.position), ring.angle(slot))) > math.pi - 1e-9
    if here.gap + ball.radius > 1e-3 and length(ball.position) > 1e-3 and not opposite:
        assert near_points((here.normal * arrow, here.point * arrow), (there.normal, there.point))


@given(contacts())
def test_a_mirrored_arena_has_the_mirrored_contact_to_the_bit(case):
    """Ball and ring mirrored about the x axis: same gap, same feature, conjugate normal and point. Not one bit more."""
    ball, ring, slot = case
    # On the negative x axis, pi and -pi are one angle, which no mirror tells apart; halfway between two ends, the
    # clockwise one is taken.
    assume(ball.position.imag != 0.0 and ring.phase != math.pi)
    bearing = bearing_of(ball.position)
    assume(abs(bearing - ring.angle_near(slot, bearing)) not in {0.0, math.pi})
    here = contact(ball, ring, slot)
    mirrored = Ring(*ring[:4], -ring.phase, -ring.spin)
    there = contact(Ball(ball.position.conjugate(), 0j, ball.radius), mirrored, -slot % ring.count)
    assert there == (here.normal.conjugate(), here.point.conjugate(), here.gap, here.feature)


@given(contacts(), st.integers(-300, 300))
def test_doubling_every_length_doubles_gap_and_point_to_the_bit(case, exponent):
    """Any power of two: no length is built in."""
    ball, ring, slot = case
    assume(exponent == 0 or min(abs(ball.position.real), abs(ball.position.imag)) > 1e-9)
    factor = 2.0**exponent
    larger = Ring(ring.radius * factor, ring.half_width * factor, *ring[2:])
    here = contact(ball, ring, slot)
    there = contact(Ball(ball.position * factor, 0j, ball.radius * factor), larger, slot)
    assert there == (here.normal, here.point * factor, here.gap * factor, here.feature)


@given(contacts(), reals(0.0, 0.999))
def test_moving_towards_the_contact_point_changes_the_gap_by_as_much(case, share):
    """From outside the gap shrinks by the way gone, from inside the overlap does: the normal leads from sector to ball."""
    ball, ring, slot = case
    found = contact(ball, ring, slot)
    way = -share * (found.gap + ball.radius)
    moved = Ball(ball.position + found.normal * way, 0j, ball.radius)
    assert abs(contact(moved, ring, slot).gap - (found.gap + way)) < 1e-9


@given(rings(), st.integers(0, 11), st.sampled_from([-1, 1]), reals(0.05, 0.95), st.integers(-3, 3))
def test_a_centre_on_the_very_end_leaves_into_the_gap(ring, slot, sign, share, ulps):
    """By rounding it may be a hair behind the end although its bearing is a hair before it: the normal once led inwards."""
    slot %= ring.count
    angle = ring.angle(slot) + sign * ring.half_angle
    p = to_cartesian(ring.inner_radius + share * 2.0 * ring.half_width, angle)
    p = complex(p.real, p.imag + ulps * math.ulp(p.imag))
    found = contact(Ball(p, 0j, 10.0 * ring.radius), ring, slot)
    assert found.feature is Feature.END or share * 2.0 * ring.half_width < 1e-12
    assert abs(found.normal - direction(angle) * 1j * sign) < 1e-12


@given(rings(), reals(0.5, 15.0), reals(0.05, 1.0), st.sampled_from([-1, 1]), st.integers(0, 11))
def test_the_gap_does_not_jump_between_face_and_end(ring, distance, ball_radius, sign, slot):
    """A rounding to either side of the border between the cases, the answer is one but for rounding."""
    slot %= ring.count
    assume(not ring.inner_radius <= distance <= ring.outer_radius)
    border = ring.angle(slot) + sign * ring.half_angle
    within = contact(Ball(to_cartesian(distance, border - 1e-12 * sign), 0j, ball_radius), ring, slot)
    beyond = contact(Ball(to_cartesian(distance, border + 1e-12 * sign), 0j, ball_radius), ring, slot)
    assert within.feature in {Feature.OUTER_FACE, Feature.INNER_FACE}
    assert beyond.feature is Feature.CORNER
    assert abs(within.gap - beyond.gap) < 1e-9
    assert abs(within.point - beyond.point) < 1e-9


@given(contacts())
def test_the_two_cases_of_the_source_are_the_contacts(case):
    """The normal of an overlap, found through the source's own functions, is the contact's."""
    ball, ring, _ = case
    theta = angle_of(ball.position)
    slot = nearest_slot(ring, theta)
    offset = abs(signed_difference(theta, ring.angle(slot)))
    assume(abs(offset - ring.half_angle) > 1e-9)
    assume(math.pi / ring.count - offset > 1e-9)
    assume(abs(length(ball.position) - ring.radius) > 1e-9)
    assume(not is_inside(ball.position, ring, slot))
    found = contact(ball, ring, slot)
    assume(found.gap + ball.radius > 1e-6)
    assume(abs(found.gap) > 1e-9)
    positions = [(ring.radius, ring.angle(k)) for k in range(ring.count)]
    normal = broad_phase(ball.position, ball.radius, theta, positions, ring.half_width, ring.half_angle)
    if offset > ring.half_angle and found.gap > 0.0:
        assert normal is None
    else:
        assert abs(normal - found.normal) < 1e-9


@given(reals(1.0, 10.0), reals(0.01, 0.9), st.integers(1, 12), angles(), angles(), reals(1e-6, 15.0))
def test_a_closed_ring_has_no_ends(radius, width, count, phase, theta, distance):
    """No ghost corner at a seam, nor at pi: the nearest sector always shows a face, alone as in company."""
    ring = Ring(radius, width * radius, math.pi / count, count, phase)
    ball = Ball(to_cartesian(distance, theta), 0j, 0.25)
    assume(count == 1 or not ring.inner_radius <= length(ball.position) <= ring.outer_radius)
    offset = abs(signed_difference(theta, ring.angle(nearest_slot(ring, theta))))
    assume(count == 1 or offset < ring.half_angle - 1e-9)
    found = contact(ball, ring, nearest_slot(ring, theta))
    assert found.feature in {Feature.OUTER_FACE, Feature.INNER_FACE}
    expected = max(ring.inner_radius - length(ball.position), length(ball.position) - ring.outer_radius)
    assert abs(found.gap - (expected - ball.radius)) < 1e-12


@pytest.mark.parametrize("sign", [-1, 1])
def test_a_full_ring_has_no_seam_at_pi(sign):
    """A single sector of half angle pi: opposite its middle, a hair to either side, there is only its face."""
    ring = Ring(10.0, 1.0, math.pi, 1)
    for distance, feature in ((8.0, Feature.INNER_FACE), (10.5, Feature.OUTER_FACE), (12.0, Feature.OUTER_FACE)):
        found = contact(Ball(complex(-distance, sign * 1e-17), 0j, 0.5), ring, 0)
        assert found.feature is feature
        assert abs(found.normal - (1.0 if distance < 10.0 else -1.0)) < 1e-15


@pytest.mark.parametrize("distance", [0.0, 5e-324, 1e-300, 1e-17])
def test_a_ball_at_the_centre_has_a_contact_with_every_slot(distance):
    """No division by 0: in the hole every sector is as far as its inner radius."""
    ring = Ring(10.0, 1.0, 0.3, 5, 0.7)
    for slot in range(5):
        found = contact(Ball(complex(-distance, distance), 1j, 0.5), ring, slot)
        assert abs(found.gap - 8.5) < 1e-14
        assert abs(length(found.normal) - 1.0) < 1e-15
