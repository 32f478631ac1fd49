"""Which obstacle the ball can touch: the four outcomes with their borders, the nearest slot, the source's search."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import (
    Outcome,
    Ring,
    angle_of,
    broad_phase,
    broad_phase_outcome,
    has_left,
    in_band,
    length,
    min_difference,
    nearest_slot,
    normalize_angle,
    signed_difference,
    to_cartesian,
)
from tests.support.oracles import source_oracle
from tests.support.strategies import angles, balls_beside_an_end, points, reals, rings

PADDLES = Ring(10.0, 0.5, 0.3, 3)
BRICKS = Ring(5.0, 1.0, 0.3, 8)
GROUND = 11.0
R = 0.25


def outcome(distance, ball_radius=R):
    """The outcome for a ball on the x axis."""
    return broad_phase_outcome(complex(distance, 0.0), ball_radius, GROUND, PADDLES, [BRICKS])


@pytest.mark.parametrize(
    ("distance", "expected"),
    [
        (0.0, Outcome.NO_COLLISION),
        (3.5, Outcome.NO_COLLISION),
        (5.0, Outcome.BRICKS),
        (8.0, Outcome.NO_COLLISION),
        (10.0, Outcome.PADDLES),
        (11.0, Outcome.NO_COLLISION),
        (12.0, Outcome.GAME_OVER),
    ],
)
def test_each_of_the_four_outcomes(distance, expected):
    """From the centre outwards: nothing, bricks, nothing, paddles, nothing, game over."""
    assert outcome(distance) is expected
    assert outcome(-distance) is expected


@pytest.mark.parametrize(
    ("border", "outward", "there", "beyond"),
    [
        (3.75, -1, Outcome.BRICKS, Outcome.NO_COLLISION),  # |p| + r = r_b - w_b
        (6.25, +1, Outcome.BRICKS, Outcome.NO_COLLISION),  # |p| - r = r_b + w_b
        (9.25, -1, Outcome.PADDLES, Outcome.NO_COLLISION),  # |p| + r = r_p - w_p
        (10.75, +1, Outcome.PADDLES, Outcome.NO_COLLISION),  # |p| - r = r_p + w_p
        (11.25, +1, Outcome.NO_COLLISION, Outcome.GAME_OVER),  # |p| - r = r_g
    ],
)
def test_the_borders_belong_to_where_the_source_puts_them(border, outward, there, beyond):
    """>= and <= take the border in, > leaves it out; a billionth beyond, it is over."""
    assert outcome(border) is there
    assert outcome(border + outward * 1e-9) is beyond
    assert outcome(border - outward * 1e-9) is there


def test_the_first_outcome_that_holds_is_taken():
    """In the source's order: game over before paddles before bricks, for a ball that could have several."""
    everywhere = Ring(10.0, 9.0, 0.3, 3)
    assert broad_phase_outcome(20 + 0j, R, 5.0, everywhere, [everywhere]) is Outcome.GAME_OVER
    assert broad_phase_outcome(10 + 0j, R, 5.0, everywhere, [everywhere]) is Outcome.GAME_OVER
    assert broad_phase_outcome(10 + 0j, R, 50.0, everywhere, [everywhere]) is Outcome.PADDLES
    assert broad_phase_outcome(5 + 0j, 4.5, 50.0, PADDLES, [BRICKS]) is Outcome.PADDLES


@given(points(16.0), reals(0.05, 1.0))
def test_the_outcome_is_the_sources(p, ball_radius):
    """In its own words."""
    found = broad_phase_outcome(p, ball_radius, GROUND, PADDLES, [BRICKS])
    assert found.value == source_oracle.outcome(p, ball_radius, GROUND, 10.0, 0.5, 5.0, 1.0)


@given(points(16.0), reals(0.05, 1.0), rings())
def test_a_ball_is_in_a_band_when_a_point_of_it_is(p, ball_radius, ring):
    """The ball's own nearest and farthest distance from the centre overlap the ring's two radii."""
    nearest, farthest = abs(p) - ball_radius, abs(p) + ball_radius
    margin = min(abs(farthest - ring.inner_radius), abs(nearest - ring.outer_radius))
    inside = max(nearest, ring.inner_radius) <= min(farthest, ring.outer_radius)
    assert margin < 1e-12 or in_band(length(p), ball_radius, ring) == inside


@given(angles(), reals(0.0, 20.0), reals(0.05, 1.0))
def test_whether_a_ball_has_left_does_not_depend_on_its_angle(angle, distance, ball_radius):
    """Only on how far it is, but for the rounding of the turn."""
    p = to_cartesian(distance, angle)
    assert abs(distance - ball_radius - GROUND) < 1e-12 or has_left(p, ball_radius, GROUND) == has_left(
        complex(distance, 0.0), ball_radius, GROUND
    )


@given(rings(), angles())
def test_the_nearest_slot_is_the_one_a_search_finds(ring, angle):
    """Arithmetic instead of a loop; halfway between two slots either may be named."""
    slot = nearest_slot(ring, angle)
    assert 0 <= slot < ring.count
    nearest = min(min_difference(angle, ring.angle(k)) for k in range(ring.count))
    assert min_difference(angle, ring.angle(slot)) <= nearest + 4e-15


@given(st.integers(1, 10**7), angles(), st.data())
def test_every_slot_is_nearest_to_its_own_angle(count, phase, data):
    """At one price for ten million slots: the slots just across the polar axis too."""
    ring = Ring(10.0, 0.5, 1e-8, count, phase)
    slot = data.draw(st.integers(0, count - 1) | st.sampled_from([0, count - 1, count // 2]))
    assert nearest_slot(ring, ring.angle(slot)) == slot


def positions_of(ring):
    """A ring as the source's list."""
    return [(ring.radius, ring.angle(slot)) for slot in range(ring.count)]


@given(rings(), reals(0.5, 15.0), angles(), reals(0.05, 1.0))
def test_the_normal_of_a_face_is_the_sources(ring, distance, theta, ball_radius):
    """For a ball within a sector's angle and outside of its material."""
    middle = ring.angle(nearest_slot(ring, theta))
    theta = normalize_angle(middle + signed_difference(theta, middle) * ring.count * ring.half_angle / math.pi * (1.0 - 1e-9))
    assume(not ring.inner_radius <= distance <= ring.outer_radius)
    p = to_cartesian(distance, theta)
    arguments = p, ball_radius, theta, positions_of(ring), ring.half_width, ring.half_angle
    found = broad_phase(*arguments)
    assert found is not None
    assert_same_normal(found, source_oracle.broad_phase(*arguments))


@given(balls_beside_an_end())
def test_the_normal_of_an_end_is_the_sources(beside):
    """For a ball beside a narrow sector's end, between its corners: the same normal, or none at the same distance."""
    ball, ring = beside.ball, beside.ring
    arguments = ball.position, ball.radius, angle_of(ball.position), positions_of(ring), ring.half_width, ring.half_angle
    found = broad_phase(*arguments)
    assert (found is not None) == (beside.across < ball.radius)
    assert_same_normal(found, source_oracle.broad_phase(*arguments))


def assert_same_normal(found, expected):
    """Both None, or both the same vector but for rounding."""
    assert (found is None) == (expected is None)
    if found is not None:
        assert abs(found - expected) < 1e-10


@given(rings(), points(12.0), st.randoms(use_true_random=False))
def test_the_order_of_the_list_does_not_matter(ring, p, chance):
    """Unless two sectors are equally near."""
    theta = angle_of(p)
    positions = positions_of(ring)
    nearest = sorted(min_difference(theta, angle) for _, angle in positions)
    shuffled = chance.sample(positions, len(positions))
    if ring.count == 1 or nearest[0] != nearest[1]:
        rest = ring.half_width, ring.half_angle
        assert broad_phase(p, 0.5, theta, positions, *rest) == broad_phase(p, 0.5, theta, shuffled, *rest)


def test_of_equally_near_sectors_the_first_is_taken():
    """As the source's < has it: the one with the smaller radius, then the one with the greater."""
    p = to_cartesian(7.0, 1.0)
    small, great = (5.0, 0.5), (9.0, 1.5)
    outward, inward = p / 7.0, -p / 7.0
    assert abs(broad_phase(p, R, 1.0, [small, great], 0.1, 0.6) - outward) < 1e-15
    assert abs(broad_phase(p, R, 1.0, [great, small], 0.1, 0.6) - inward) < 1e-15


def test_the_search_crosses_the_polar_axis():
    """A ball just below the axis is nearest to a sector just above it, and the other way round."""
    positions = [(5.0, 1.0), (9.0, 0.1), (5.0, math.tau - 1.0)]
    for theta in (math.tau - 0.1, 0.0, 0.1):
        p = to_cartesian(7.0, theta)
        assert abs(broad_phase(p, R, theta, positions, 0.1, 0.3) + p / 7.0) < 1e-15
    positions = [(5.0, 1.0), (9.0, math.tau - 0.1), (5.0, math.tau - 1.0)]
    for theta in (math.tau - 0.1, 0.0, 0.1):
        p = to_cartesian(7.0, theta)
        assert abs(broad_phase(p, R, theta, positions, 0.1, 0.3) + p / 7.0) < 1e-15


def test_the_sectors_own_border_is_a_face():
    """<= in the source: a ball at exactly the half angle is answered by case 1, a hair beyond by case 2."""
    positions, half_angle = [(10.0, 1.0)], 0.25
    p = to_cartesian(10.6, 1.25)
    assert min_difference(1.25, 1.0) == half_angle
    assert abs(broad_phase(p, 0.05, 1.25, positions, 0.5, half_angle) - p / abs(p)) < 1e-15
    beyond = math.nextafter(1.25, 2.0)
    assert broad_phase(to_cartesian(10.6, beyond), 0.05, beyond, positions, 0.5, half_angle) is None
