"""The source's algorithm as the slides have it: what it gets wrong is part of it."""

import math

import pytest

from physics import PERMANENT, Arena, Ball, Ring, advance, source_mode
from physics.source_mode import (
    FRAME,
    normal_at,
    slides_closest_point_on_line,
    slides_narrow_phase_case_2,
    slides_normalize_angle,
    slides_response,
)
from tests.support.oracles import source_oracle

TICK = 1.0 / 240.0
WALL = Ring(10.0, 0.5, math.pi, 1)


def arena(position, velocity, *rings):
    """One ball of radius 0.25 among whole rings."""
    return Arena((Ball(position, velocity, 0.25),), rings, tuple((PERMANENT,) * ring.count for ring in rings))


def flown(state, ticks, speed=8.0, dt=TICK):
    """The state after some ticks of the source mode, and all hits."""
    hits, flight = [], None
    for _ in range(ticks):
        step = source_mode.advance(state, dt, speed, flight)
        state, flight = step.arena, step.flight
        hits += step.hits
    return state, hits


def test_the_overlap_is_tested_once_a_frame():
    """A ball at a wall bounces at the end of the frame in which it touches, not within; swept it bounces in time."""
    start = arena(9.24 + 0j, 8 + 0j, WALL)
    assert flown(start, 3)[1] == []
    (hit,) = flown(start, 4)[1]
    assert hit.contact.gap < -0.1
    assert abs(advance(start, TICK, 8.0).hits[0].contact.gap) < 1e-13


def test_a_fast_ball_flies_through_a_wall():
    """In one frame from one side to the other: 1.6 units thick with the ball, 2 units a frame."""
    fast = 2.0 / FRAME
    state, hits = flown(arena(8.5 + 0j, complex(fast, 0.0), WALL), 8, fast)
    assert hits == []
    assert state.balls[0].position.real > 11.0


def test_the_bounce_is_the_slides_formula():
    """The same velocity as the oracle's, which knows nothing of this package."""
    ring = WALL._replace(spin=0.3, friction=0.5)
    (hit,) = flown(arena(9.2 + 0j, 6.4 + 4.8j, ring), 4)[1]
    surface = ring.surface_velocity(10.0 * (math.cos(0.3 * 4 * TICK) + 1j * math.sin(0.3 * 4 * TICK)))
    expected = source_oracle.collision_response(hit.before, hit.contact.normal, surface, 0.5, 8.0)
    assert abs(hit.after - expected) < 1e-12


def test_a_wide_sector_is_hit_at_its_wrong_end():
    """on_left(theta, theta_p + phi_p) picks the farther end of 2 x 165 degrees: the ball touches and is not seen."""
    ring = Ring(10.0, 1.0, math.radians(165.0), 1)
    theta = math.radians(185.0)
    p = 10.0 * complex(math.cos(theta), math.sin(theta))
    arguments = p, 1.8, theta, 10.0, 0.0, 1.0, math.radians(165.0)
    assert slides_narrow_phase_case_2(*arguments) is None
    assert source_oracle.narrow_phase_case_2(*arguments) is None
    assert normal_at(Ball(p, 1j, 1.8), ring, (1,)) is None


def test_the_line_ab_is_endless():
    """Far out on the line of an end the slides see a contact in thin air."""
    assert slides_closest_point_on_line(8 + 0j, 12 + 0j, 20 + 0.1j) == 20
    assert slides_closest_point_on_line(8 + 0j, 8 + 0j, 20 + 0.1j) is None


def test_zero_over_zero_stops_the_ball():
    """An end that retreats at half the ball's speed: v_res = 0, and the slides divide by its length."""
    assert slides_response(-4j, 1j, -2j, 1.0, 4.0) is None
    with pytest.raises(ZeroDivisionError):
        source_oracle.collision_response(-4j, 1j, -2j, 1.0, 4.0)


def test_a_hair_below_the_axis_is_a_full_turn():
    """-1e-17 by a plain remainder is 2 pi, outside of its own range."""
    assert slides_normalize_angle(-1e-17) == math.tau


def test_bricks_break_and_empty_slots_are_not_searched():
    """A hit takes a layer; the next ball flies on through the gap to the brick behind it."""
    bricks = Ring(5.0, 0.5, 0.3, 8)
    state = Arena((Ball(6.2 + 0j, -8 + 0j, 0.25),), (bricks,), ((1,) * 8,))
    state, hits = flown(state, 30)
    assert [(hit.slot, hit.layers) for hit in hits] == [(0, 0)]
    assert state.layers == ((0, 1, 1, 1, 1, 1, 1, 1),)
    back = state._replace(balls=(Ball(6.2 + 0j, -8 + 0j, 0.25),))
    assert flown(back, 20)[1] == []


@pytest.mark.parametrize("dt", [-1.0, math.nan, math.inf])
def test_a_time_that_is_none_is_refused(dt):
    """As by the swept engine."""
    with pytest.raises(ValueError, match="dt must be finite"):
        source_mode.advance(arena(0j, 8 + 0j), dt, 8.0)
