"""The same game at any frame rate, from any side, in a mirror, and backwards."""

import cmath
import math
from random import Random

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import PERMANENT, Arena, Ball, Feature, Ring, advance
from tests.support.strategies import angles, reals

TICK = 1.0 / 240.0
R = 0.25
SPEED = 8.0


def at(radius, angle):
    """A point in polar coordinates."""
    return cmath.rect(radius, angle)


def game(seed):
    """Turning paddles, bricks at rest, a wall that keeps the ball; where it starts and goes is up to chance."""
    chance = Random(seed)
    paddles = Ring(9.0, 0.3, 0.35, 3, chance.uniform(0.0, 6.0), chance.choice((0.6, -0.4, 0.2)), 0.5)
    rows = [Ring(radius, 0.4, 0.17, 16, chance.uniform(0.0, 6.0)) for radius in (2.6, 3.8, 5.0)]
    ball = Ball(at(7.0, chance.uniform(0.0, 6.0)), at(SPEED, chance.uniform(0.0, 6.0)), R)
    wall = Ring(11.0, 0.3, math.pi, 1)
    return Arena((ball,), (paddles, *rows, wall), ((PERMANENT,) * 3, (1,) * 16, (1,) * 16, (1,) * 16, (PERMANENT,)))


def first_hits(arena, count, per_second):
    """The first bounces, their times counted from the start; ticks of 1 / per_second s."""
    hits, tick = [], 0
    while len(hits) < count:
        step = advance(arena, 1.0 / per_second, SPEED)
        hits += [hit._replace(time=tick / per_second + hit.time) for hit in step.hits]
        arena, tick = step.arena, tick + 1
        assert (step.dropped, step.freed) == (0, 0)
    return hits[:count]


@pytest.mark.parametrize("seed", range(12))
def test_the_frame_rate_does_not_matter(seed):
    """Ticks of 1/60, 1/240 and 1/1000 s: the first ten bounces on the same sectors, the first five within a nanosecond."""
    coarse, usual, fine = (first_hits(game(seed), 10, rate) for rate in (60, 240, 1000))
    for other in (coarse, fine):
        assert [(hit.ring, hit.slot, hit.contact.feature) for hit in other] == [
            (hit.ring, hit.slot, hit.contact.feature) for hit in usual
        ]
        assert [hit.time for hit in other[:5]] == pytest.approx([hit.time for hit in usual[:5]], rel=0.0, abs=1e-9)


def mirrored(arena):
    """The arena in a mirror along the x axis; slot k becomes slot -k."""
    balls = tuple(ball._replace(position=ball.position.conjugate(), velocity=ball.velocity.conjugate()) for ball in arena.balls)
    rings = tuple(Ring(*ring[:4], -ring.phase, -ring.spin, ring.friction) for ring in arena.rings)
    return Arena(balls, rings, tuple((row[0], *row[:0:-1]) for row in arena.layers))


@pytest.mark.parametrize("seed", range(12))
def test_a_mirrored_game_is_the_mirrored_game_to_the_bit(seed):
    """About the x axis, for thousands of ticks and many bounces: no bit differs."""
    plain, other, bounces = game(seed), mirrored(game(seed)), 0
    for _ in range(3000):
        step, there = advance(plain, TICK, SPEED), advance(other, TICK, SPEED)
        assert [hit.time for hit in there.hits] == [hit.time for hit in step.hits]
        assert [hit.after for hit in there.hits] == [hit.after.conjugate() for hit in step.hits]
        plain, other, bounces = step.arena, there.arena, bounces + len(step.hits)
        assert other == mirrored(plain)
    assert bounces >= 8


@st.composite
def bounces(draw):
    """A ball shortly before it meets one sector of a ring, which may turn; friction as it comes."""
    spin = draw(st.just(0.0) | reals(-0.7, 0.7))
    ring = Ring(
        9.0, draw(reals(0.1, 1.0)), draw(reals(0.05, 1.0)), draw(st.integers(1, 3)), draw(angles()), spin, draw(reals(0.0, 1.0))
    )
    aim = at(
        9.0 + draw(reals(-1.2, 1.2)), ring.phase + draw(st.sampled_from([-1.0, 1.0])) * draw(reals(0.0, 1.2)) * ring.half_angle
    )
    way = at(1.0, draw(angles()))
    ball = Ball(aim - way * draw(reals(0.5, 2.0)), SPEED * way, R)
    return Arena((ball,), (ring,), ((PERMANENT,) * ring.count,))


def one_bounce(arena, dt):
    """The tick, if it is one clear bounce."""
    assume(advance(arena, 0.001, SPEED).freed == 0)
    step = advance(arena, dt, SPEED)
    assume(len(step.hits) == 1)
    (hit,) = step.hits
    surface = arena.rings[0].surface_velocity(hit.contact.point)
    approach = (hit.before - surface) * hit.contact.normal.conjugate()
    assume(approach.real < -0.1)
    return step, hit


@given(bounces(), angles())
def test_a_turned_world_is_the_same_world(arena, turn):
    """By any angle: the same bounce to a billionth."""
    step, hit = one_bounce(arena, 0.4)
    by = at(1.0, turn)
    balls = tuple(ball._replace(position=ball.position * by, velocity=ball.velocity * by) for ball in arena.balls)
    ring = arena.rings[0]
    turned = Arena(balls, (Ring(*ring[:4], ring.phase + turn, *ring[5:]),), arena.layers)
    other = advance(turned, 0.4, SPEED)
    assert len(other.hits) == 1
    assert other.hits[0].time == pytest.approx(hit.time, rel=0.0, abs=1e-9)
    assert abs(other.arena.balls[0].position / by - step.arena.balls[0].position) < 1e-9
    assert abs(other.arena.balls[0].velocity / by - step.arena.balls[0].velocity) < 1e-9


@given(bounces())
def test_without_friction_a_bounce_runs_backwards(arena):
    """Off anything at rest, and off faces however they turn: reversed, the ball comes back to where it started.

    An end that turns changes the ball's speed, and the fixed speed forgets by how much.
    """
    arena = arena._replace(rings=(arena.rings[0]._replace(friction=0.0),))
    step, hit = one_bounce(arena, 0.4)
    assume(arena.rings[0].spin == 0.0 or hit.contact.feature in {Feature.OUTER_FACE, Feature.INNER_FACE})
    end = step.arena
    ball, ring = end.balls[0], end.rings[0]
    back = Arena((ball._replace(velocity=-ball.velocity),), (ring._replace(spin=-ring.spin),), end.layers)
    again = advance(back, 0.4, SPEED)
    assert len(again.hits) == 1
    assert abs(again.arena.balls[0].position - arena.balls[0].position) < 1e-9
    assert abs(again.arena.balls[0].velocity + arena.balls[0].velocity) < 1e-9
