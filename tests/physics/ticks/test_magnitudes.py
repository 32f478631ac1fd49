"""Very large, very small, and very unequal: what the constructors accept, the engine can reckon with."""

import math

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import PERMANENT, Arena, Ball, Feature, Ring, advance, contact, time_of_impact
from tests.support.oracles.impact_oracle import gap
from tests.support.strategies import balls, reals, rings

TICK = 1.0 / 240.0


def scaled(arena, factor):
    """The arena with every length, and every velocity, times a factor."""
    some = tuple(Ball(ball.position * factor, ball.velocity * factor, ball.radius * factor) for ball in arena.balls)
    found = tuple(Ring(ring.radius * factor, ring.half_width * factor, *ring[2:]) for ring in arena.rings)
    return Arena(some, found, arena.layers)


@pytest.mark.parametrize("exponent", [-100, -40, -1, 1, 40, 100])
def test_an_arena_scaled_by_a_power_of_two_plays_the_same_game_to_the_bit(exponent):
    """No length is built in: 2**-100 is near the least, 2**100 near the largest size a constructor accepts."""
    paddles = Ring(9.0, 0.3, 0.35, 3, 1.0, 0.6, 0.5)
    rows = [Ring(radius, 0.4, 0.17, 16, 0.3 * radius) for radius in (2.6, 3.8, 5.0)]
    wall = Ring(11.0, 0.3, math.pi, 1)
    layers = ((PERMANENT,) * 3, (1,) * 16, (1,) * 16, (1,) * 16, (PERMANENT,))
    plain = Arena((Ball(7 + 0j, 4.8 + 6.4j, 0.25),), (paddles, *rows, wall), layers)
    factor = 2.0**exponent
    other, bounces = scaled(plain, factor), 0
    for _ in range(2000):
        step, there = advance(plain, TICK, 8.0), advance(other, TICK, 8.0 * factor)
        assert [(hit.time, hit.slot) for hit in there.hits] == [(hit.time, hit.slot) for hit in step.hits]
        plain, other, bounces = step.arena, there.arena, bounces + len(step.hits)
        assert other == scaled(plain, factor)
    assert bounces >= 8


def test_a_ball_in_an_arena_of_the_largest_size_touches_where_it_must():
    """The issue's case: fourth powers of its numbers overflowed, and no touch was found."""
    found = time_of_impact(Ball(0j, 2e34 + 0j, 1e33), Ring(1e34, 1e33, 0.4, 3), 2.0)
    assert found.time == pytest.approx(0.4, rel=1e-15)
    assert found.contact.feature == Feature.INNER_FACE


@pytest.mark.parametrize("spin", [0.0, 1.3, 1e30])
@pytest.mark.parametrize("size", [1e-34, 1e-20, 1.0, 1e20, 1e34])
def test_the_search_is_right_at_every_size(size, spin):
    """A ball beside a turning end meets it when the gap closes, to 1e-12 of the arena."""
    ring = Ring(10.0 * size, 0.5 * size, 0.3, 1, 0.0, spin)
    p = 10.0 * size * complex(math.cos(0.6), math.sin(0.6))
    ball = Ball(p, -8.0 * size * 1j * p / abs(p), 0.25 * size)
    span = min(1.0, 1.0 / spin) if spin else 1.0
    found = time_of_impact(ball, ring, span)
    assert found is not None
    assert abs(gap(ball, ring, found.time, [0], mpmath)) < 1e-12 * size


@pytest.mark.parametrize("aside", [0.0, 0.3, -0.6])
@pytest.mark.parametrize("share", [1e-2, 1e-3, 1e-4, 1e-5])
def test_a_hole_far_smaller_than_the_arena_is_crossed_in_time(share, aside):
    """A ball from far away flies through a gap into the hole and meets its far face.

    At a ten-thousandth of the arena the gap at impact had been 4.8e-7 of the ball's radius.
    """
    hole = 10.0 * share
    ring = Ring(5.0, 5.0 - hole, 1.2, 1)
    ball = Ball(complex(-12.0, 0.4 * hole * aside), 8 + 0j, 0.4 * hole)
    found = time_of_impact(ball, ring, 3.0)
    assert found.contact.feature == Feature.INNER_FACE
    assert abs(gap(ball, ring, found.time, [0], mpmath)) < 3e-10 * ball.radius


@pytest.mark.parametrize("aside", [0.0, 0.3, -0.9])
@pytest.mark.parametrize("share", [1e-2, 1e-3, 1e-4, 1e-5])
def test_a_ring_far_smaller_than_the_arena_is_met_in_time(share, aside):
    """A ball from far away meets its outer face."""
    size = 10.0 * share
    ring = Ring(size, 0.5 * size, math.pi, 1)
    ball = Ball(complex(-12.0, 1.9 * size * aside), 8 + 0j, 0.4 * size)
    found = time_of_impact(ball, ring, 3.0)
    assert found.contact.feature == Feature.OUTER_FACE
    assert abs(gap(ball, ring, found.time, [0], mpmath)) < 3e-10 * ball.radius


@pytest.mark.parametrize("turn", [0.0, 0.5, 2.0, 3.1, 4.4])
def test_a_ball_at_the_exact_centre_as_large_as_its_hole_touches_where_it_flies_to(turn):
    """The touched point lies ahead of it, on the sector that it flies to; only that one is met, and at once."""
    way = complex(math.cos(turn), math.sin(turn))
    ring = Ring(1.0, 0.5, math.pi / 3.0, 3)
    found = time_of_impact(Ball(0j, 8.0 * way, 0.5), ring, 1.0)
    assert found.time == 0.0
    assert abs(found.contact.normal + way) < 1e-15
    assert found.contact.point == -found.contact.normal * 0.5
    step = advance(Arena((Ball(0j, 8.0 * way, 0.5),), (ring,), ((PERMANENT,) * 3,)), TICK, 8.0)
    assert abs(step.hits[0].after + 8.0 * way) < 1e-12


def test_a_ball_at_the_exact_centre_at_rest_touches_nothing_that_it_approaches():
    """It has no direction; the contact's normal is a convention, and no impact follows from it."""
    assert time_of_impact(Ball(0j, 0j, 0.5), Ring(1.0, 0.5, math.pi / 3.0, 3), 1.0) is None


@given(balls(), rings(), st.integers(-80, 80))
def test_a_scaled_contact_is_the_contact_scaled(ball, ring, exponent):
    """To the bit, for every power of two."""
    assume(exponent == 0 or min(abs(ball.position.real), abs(ball.position.imag)) > 1e-9)
    factor = 2.0**exponent
    larger = Ring(ring.radius * factor, ring.half_width * factor, *ring[2:])
    here = contact(ball, ring, 0)
    there = contact(Ball(ball.position * factor, ball.velocity, ball.radius * factor), larger, 0)
    assert there == (here.normal, here.point * factor, here.gap * factor, here.feature)


@given(reals(1e-34, 1e35), reals(1e-35, 1e35))
def test_no_accepted_number_overflows_or_vanishes(size, speed):
    """A ball that flies straight at the face of a closed ring meets it after the way that is between them."""
    ring = Ring(size, 0.5 * size, math.pi, 1)
    ball = Ball(0j, complex(speed, 0.0), 0.125 * size)
    found = time_of_impact(ball, ring, size / speed)
    expected = (0.5 * size - ball.radius) / speed
    assert found.time == pytest.approx(max(expected, 0.0), rel=1e-12)
