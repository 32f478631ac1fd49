"""Two sectors touched at the same moment: both are hit, and what is its own mirror image stays so."""

import math

import pytest

from physics import Ball, Contact, Feature, Ring, dot
from physics.bounce import bounce, bounce_off_two
from physics.time_of_impact import touched_now
from tests.support.games.ticks import SPEED, TICK, R, arena, at, played, ticked


def test_two_bricks_at_once_are_both_hit_and_the_ball_goes_straight_back():
    """Head on into the gap, each corner at 45 degrees: the lower slot first, then the other, at the same moment."""
    bricks = Ring(10.0, 0.5, math.pi / 4.0 - math.asin(R * math.sqrt(0.5) / 10.5), 4, math.pi / 4.0)
    step = ticked(arena([Ball(10.69 + 0j, -8 + 0j, R)], bricks, layers=[(1, 1, 1, 1)]))
    assert [hit.slot for hit in step.hits] == [0, 3]
    assert step.arena.layers == ((0, 1, 1, 0),)
    assert step.hits[0].time == step.hits[1].time
    assert step.arena.balls[0].velocity == pytest.approx(8 + 0j, abs=1e-9)


@pytest.mark.parametrize("velocity", [-8 + 0j, -6.4 + 4.8j])
@pytest.mark.parametrize("half_gap", [0.01, 0.005, 1e-4])
def test_a_ball_exactly_between_two_bricks_breaks_both_and_goes_straight_back(half_gap, velocity):
    """However narrow the gap: what is its own mirror image stays so, and the order of the slots decides nothing."""
    bricks = Ring(10.0, 0.5, math.pi / 4.0 - half_gap, 4, math.pi / 4.0)
    x = 10.5 * math.cos(half_gap) + math.sqrt(R * R - (10.5 * math.sin(half_gap)) ** 2)
    step = ticked(arena([Ball(x - velocity * TICK / 2.0, velocity, R)], bricks, layers=[(1, 1, 1, 1)]))
    if velocity.imag == 0.0:
        assert [hit.slot for hit in step.hits] == [0, 3]
        assert step.arena.layers == ((0, 1, 1, 0),)
        assert step.arena.balls[0].velocity == 8 + 0j
    assert abs(step.arena.balls[0].velocity) == pytest.approx(8.0, rel=1e-15)


def test_the_issue_s_ball_between_two_bricks():
    """It had left 55 degrees off its line of flight, with one brick broken."""
    bricks = Ring(5.0, 0.3, math.radians(20.0), 8, math.radians(22.5))
    state = arena([Ball(7 + 0j, -8 + 0j, 0.5)], bricks, layers=[(1,) * 8])
    state, hits, *_ = played(state, 60)
    assert [hit.slot for hit in hits] == [0, 7]
    assert hits[0].time == hits[1].time
    assert abs(state.balls[0].velocity - 8.0) < 1e-14


@pytest.mark.parametrize("turn", [k * 2.0 * math.pi / 7.0 for k in range(7)])
def test_a_ball_between_two_bricks_goes_straight_back_in_any_direction(turn):
    """Also where the angles round, so that its two touches differ by a rounding in time."""
    bricks = Ring(5.0, 0.3, math.radians(20.0), 8, math.radians(22.5) + turn)
    state, hits, *_ = played(arena([Ball(at(7.0, turn), at(-8.0, turn), 0.5)], bricks, layers=[(1,) * 8]), 60)
    assert len(hits) == 2
    assert abs(state.balls[0].velocity - at(8.0, turn)) < 1e-12


def test_only_what_the_ball_approaches_is_touched_now():
    """Of two corners that it touches, the one that it flies away from is left out."""
    half_gap = 0.01
    bricks = Ring(10.0, 0.5, math.pi / 4.0 - half_gap, 4, math.pi / 4.0)
    x = 10.5 * math.cos(half_gap) + math.sqrt(R * R - (10.5 * math.sin(half_gap)) ** 2)
    both = [found.slot for found in touched_now(Ball(x + 0j, -8 + 0j, R), bricks, (1, 1, 1, 1)) if found is not None]
    assert sorted(both) == [0, 3]
    for sign, slot in ((1.0, 0), (-1.0, 3)):
        ball = Ball(x + 0j, complex(-0.1, 8.0 * sign), R)
        assert [found.slot for found in touched_now(ball, bricks, (1, 1, 1, 1)) if found is not None] == [slot]


def test_a_surface_never_pulls():
    """Where one of two touched surfaces, pushing alone, makes the ball leave both, that one answers alone."""
    resting = Ring(10.0, 0.5, 0.3, 1)
    found = [Contact(normal, 10.0 * normal, 0.0, Feature.CORNER) for normal in (1 + 0j, 0.6 + 0.8j)]
    ball = Ball(11 + 0j, -1 - 4.25j, R)
    assert all(dot(contact.normal, ball.velocity) < 0.0 for contact in found)
    assert bounce_off_two(ball, found[0], resting, found[1], resting, SPEED) is None
    after = bounce(ball, found[1], resting, SPEED)
    assert all(dot(contact.normal, after) > 0.0 for contact in found)


def test_a_ball_in_the_mouth_of_a_ring_with_one_gap_goes_straight_back():
    """Both corners belong to the same sector: one hit, and no bounce off the one that throws it at the other."""
    ring = Ring(10.0, 0.5, math.pi - 0.02, 1, math.pi)
    state, hits, dropped, _ = played(arena([Ball(12 + 0j, -8 + 0j, R)], ring), 100)
    assert (len(hits), dropped) == (1, 0)
    assert abs(state.balls[0].velocity - 8.0) < 1e-12


def test_a_flush_joint_is_like_one_long_brick():
    """At the joint of equal neighbours the ball bounces off one of them as off the face of both."""
    bricks, ball = Ring(10.0, 0.5, math.pi / 4.0, 4, math.pi / 4.0), Ball(10.76 + 0.0j, -8 + 3j, R)
    one = ticked(arena([ball], Ring(10.0, 0.5, math.pi, 1)))
    joint = ticked(arena([ball], bricks, layers=[(1, 1, 1, 1)]))
    assert len(joint.hits) == 1
    assert abs(joint.arena.balls[0].velocity - one.arena.balls[0].velocity) < 1e-12
    straight = ticked(arena([Ball(10.76 + 0j, -8 + 0j, R)], bricks, layers=[(1, 1, 1, 1)]))
    assert straight.arena.balls[0].velocity == pytest.approx(8 + 0j, abs=1e-12)


def test_a_notch_of_brick_and_wall_keeps_the_speed():
    """Two contacts at once, in either order of the rings: the ball leaves both surfaces at its speed."""
    wall, brick = Ring(13.0, 0.5, math.pi, 1), Ring(12.0, 0.5, 0.2, 1)
    corner = at(12.25, 0.2) + 1j * at(1.0, 0.2) * R
    corner *= 12.25 / abs(corner)
    start = Ball(corner - (1 - 1j) * at(1.0, 0.2) * 0.01, (1 - 1j) * at(1.0, 0.2) * SPEED / math.sqrt(2.0), R)
    results = [ticked(arena([start], *order)) for order in ((wall, brick), (brick, wall))]
    assert all(len(result.hits) == 2 for result in results)
    a, b = (result.arena.balls[0] for result in results)
    assert abs(a.velocity - b.velocity) < 1e-9
    assert abs(a.velocity) == pytest.approx(SPEED, rel=1e-12)
    assert (a.velocity / at(1.0, 0.2)).real < 0.0 < (a.velocity / at(1.0, 0.2)).imag
