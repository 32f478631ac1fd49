"""The lab's copy of the source's loop against the oracle, a transcription of the source."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from game.lab.source import SourceBall, SourceGame, frame, game_frame, slides_response
from physics import Ball, Ring, dot, min_difference, response_steps
from physics.source_mode import normal_at
from tests.support.oracles import source_oracle
from tests.support.strategies import balls, points, reals, rings

FRAME = 1.0 / 60.0


def oracle_normal(p, ball_radius, ring):
    """The source's normal, from the oracle: broad phase, nearest sector, narrow phase. None where the band is not reached."""
    sizes = (ring.radius, ring.half_width)
    if source_oracle.outcome(p, ball_radius, math.inf, *sizes, *sizes) == "no collision":
        return None
    theta = source_oracle.to_polar(p)[1]
    positions = [(ring.radius, ring.angle(slot)) for slot in range(ring.count)]
    return source_oracle.broad_phase(p, ball_radius, theta, positions, ring.half_width, ring.half_angle)


def is_clear(p, ball_radius, ring):
    """Whether the ball is so far from every border between two answers that rounding cannot choose between them."""
    theta = source_oracle.to_polar(p)[1]
    if theta >= math.tau:
        return False
    offsets = sorted([min_difference(theta, ring.angle(slot)) for slot in range(ring.count)])
    tied = len(offsets) > 1 and offsets[1] - offsets[0] < 1e-6
    borders = abs(offsets[0] - ring.half_angle), abs(offsets[0] + ring.half_angle - math.pi), abs(math.pi - offsets[0])
    lines = [ring.angle(slot) + side * ring.half_angle for slot in range(ring.count) for side in (-1, 1)]
    across = [abs((p * complex(math.cos(line), -math.sin(line))).imag) for line in lines]
    ends = min([min(distance, abs(distance - ball_radius)) for distance in across])
    bands = [abs(p) - ring.radius, abs(p) + ball_radius - ring.inner_radius, abs(p) - ball_radius - ring.outer_radius]
    return abs(p) > 1e-3 and not tied and min(borders) > 1e-6 and ends > 1e-6 and min([abs(band) for band in bands]) > 1e-9


@given(balls(), rings())
def test_its_normal_is_the_sources(ball, ring):
    """The loop's normal is the source's, with its errors: the wrong end of a wide sector, and the endless line."""
    assume(is_clear(ball.position, ball.radius, ring))
    found, expected = normal_at(ball, ring, (1,) * ring.count), oracle_normal(ball.position, ball.radius, ring)
    assert (found is None) == (expected is None)
    assert found is None or abs(found - expected) < 1e-6


@given(points(8.0), points(5.0), reals(0.0, 1.0), reals(0.0, math.tau))
def test_its_bounce_is_the_sources(v, surface, friction, angle):
    """Wherever v_res is not 0, the reset gives the source's velocity."""
    normal = complex(math.cos(angle), math.sin(angle))
    steps = response_steps(v, normal, surface, friction, 7.0)
    assume(abs(v) > 1e-3 and abs(steps.result) > 1e-3)
    found = slides_response(v, normal, surface, friction, 7.0)
    if dot(steps.relative, normal) >= 0.0:
        assert found == v
    else:
        assert abs(found - source_oracle.collision_response(v, normal, surface, friction, 7.0)) < 1e-9


def test_zero_by_zero_has_no_velocity_and_the_ball_stands_still():
    """v_res = 0 leaves the source's ball without a velocity: it stays where it is."""
    assert slides_response(-4j, 1j, -2j, 0.0, 4.0) is None
    still = SourceBall(3 + 1j, None)
    assert frame(still, 0.5, (), FRAME, 4.0) is still


@pytest.mark.parametrize(("speed", "through"), [(3.0, False), (30.0, True)])
def test_a_fast_ball_tunnels_and_a_slow_one_does_not(speed, through):
    """With one test a frame, a ball passes a wall that is thinner than its flight in a frame."""
    wall, flight = Ring(8.0, 0.05, math.pi, 1), SourceBall(0j, complex(speed, 0.0))
    for _ in range(round(12.0 / speed / FRAME)):
        flight = frame(flight, 0.1, (wall,), FRAME, speed)
    assert (abs(flight.position) > 8.5) == through


@given(st.integers(1, 12))
def test_the_nearest_of_many_sectors_is_found(count):
    """A ball above the middle of a slot is case 1 with that slot."""
    ring = Ring(6.0, 0.5, 0.9 * math.pi / count, count, 0.4)
    for slot in range(count):
        position = 6.6 * complex(math.cos(ring.angle(slot)), math.sin(ring.angle(slot)))
        assert abs(normal_at(Ball(position, 0j, 0.3), ring, (1,) * count) - position / 6.6) < 1e-12


PADDLES, BRICKS = Ring(9.0, 0.3, 0.5, 2, 0.0, 0.4), Ring(4.0, 0.5, 0.3, 8)


def game_at(position, velocity, layers=(2,) * 8):
    """The source's game with the ball where the next frame finds it after 0.1 s."""
    return game_frame(SourceGame(SourceBall(position - velocity * 0.1, velocity), PADDLES, BRICKS, layers), 0.5, 12.0, 0.1, 5.0)


def test_a_brick_that_is_hit_loses_a_layer():
    """The nearest one, and only if the ball approaches it; the bounce is the mirrored velocity."""
    hit = game_at(4.8 + 0j, -5 + 0j)
    assert (hit.layers, hit.ball.velocity) == ((1, *(2,) * 7), 5 + 0j)
    left = game_at(4.8 + 0j, 5 + 0j)
    assert (left.layers, left.ball.velocity) == ((2,) * 8, 5 + 0j)


def test_an_empty_slot_is_not_hit():
    """The search goes over the bricks that are left: a ball in an empty slot meets neither neighbour."""
    through = game_at(4.0 + 0j, -5 + 0j, (0, *(2,) * 7))
    assert (through.layers, through.ball.velocity) == ((0, *(2,) * 7), -5 + 0j)
    assert game_at(4.0 + 0j, -5 + 0j, (0,) * 8).ball.velocity == -5 + 0j


def test_a_paddle_is_hit_where_it_has_turned_to():
    """Rings turn before the test, as the source's frame does; no layer is lost."""
    hit = game_at(8.4 + 0j, 5 + 0j)
    assert hit.paddles.phase == PADDLES.turned(0.1).phase
    assert hit.layers == (2,) * 8
    assert hit.ball.velocity.real < 0.0


def test_a_ball_off_the_ground_ends_the_game():
    """The game is over from then on, and the ball does not move any more."""
    over = game_at(12.6 + 0j, 5 + 0j)
    assert over.over
    assert game_frame(over, 0.5, 12.0, 0.1, 5.0).ball == over.ball
    assert not game_at(12.4 + 0j, 5 + 0j).over
