"""`contact` against brute force, under turns, mirrors and doublings, and at the borders of its cases."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import (
    Ball,
    Feature,
    Ring,
    angle_of,
    broad_phase,
    contact,
    cross,
    direction,
    dot,
    length,
    min_difference,
    nearest_slot,
    signed_difference,
    to_cartesian,
)
from physics.narrow_phase import end_angle
from tests.support.strategies import angles, balls, reals, rings, velocities


@st.composite
def contacts(draw):
    """A ball, a ring and a slot: near it often enough, inside of the material too."""
    ring = draw(rings())
    slot = draw(st.integers(0, ring.count - 1))
    if draw(st.booleans()):
        return draw(balls()), ring, slot
    distance = ring.radius + draw(reals(-1.5, 1.5)) * ring.half_width
    angle = ring.angle(slot) + draw(reals(-1.5, 1.5)) * ring.half_angle
    return Ball(to_cartesian(distance, angle), draw(velocities(20.0)), draw(reals(0.05, 1.0))), ring, slot


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
    # On the negative x axis, pi and -pi are one angle, which no mirror tells apart; neither may a ball, a ring or an end
    # lie there. Halfway between two ends, the clockwise one is taken.
    ends = {end_angle(ring.angle(slot), ring.half_angle, side) for side in (1, -1)}
    assume(ball.position.imag != 0.0 and math.pi not in ends | {ring.phase})
    assume(min_difference(angle_of(ball.position), ring.angle(slot)) not in {0.0, math.pi})
    here = contact(ball, ring, slot)
    mirrored = Ring(*ring[:4], -ring.phase, -ring.spin)
    there = contact(Ball(ball.position.conjugate(), 0j, ball.radius), mirrored, -slot % ring.count)
    assert there == (here.normal.conjugate(), here.point.conjugate(), here.gap, here.feature)


@given(contacts(), st.integers(-100, 100))
def test_doubling_every_length_doubles_gap_and_point_to_the_bit(case, exponent):
    """Any power of two: no length is built in."""
    ball, ring, slot = case
    assume(exponent == 0 or min(abs(ball.position.real), abs(ball.position.imag)) > 1e-9)
    factor = 2.0**exponent
    larger = Ring(ring.radius * factor, ring.half_width * factor, *ring[2:])
    here = contact(ball, ring, slot)
    there = contact(Ball(ball.position * factor, ball.velocity, ball.radius * factor), larger, slot)
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
    assume(ball.position != 0.0)
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
