"""Balls put outside the material that they overlap."""

import cmath
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from physics import PERMANENT, Ball, Ring
from physics.escape import freed
from physics.tolerances import OVERLAP
from tests.support.oracles.impact_oracle import gap
from tests.support.strategies import angles, reals, rings

R = 0.25


def at(radius, angle):
    """A point in polar coordinates."""
    return cmath.rect(radius, angle)


def put_outside(ball, *given, layers=None):
    """The freed ball, after it was found to overlap nothing and to keep its velocity and size."""
    layers = layers or [(PERMANENT,) * ring.count for ring in given]
    found = freed(ball, given, layers)
    assert found[1:] == ball[1:]
    assert clearance(found, given, layers) >= -1.1 * OVERLAP * ball.radius
    return found


def clearance(ball, all_rings, layers):
    """The least gap between a ball and anything."""
    gaps = [
        gap(ball, ring, 0.0, [slot for slot in range(ring.count) if alive[slot]])
        for ring, alive in zip(all_rings, layers, strict=True)
    ]
    return min(gaps)


PADDLE = Ring(10.0, 0.5, 0.3, 1)


@pytest.mark.parametrize(
    ("p", "there"),
    [
        (10.4 + 0j, 10.75 + 0j),
        (10.7 + 0j, 10.75 + 0j),
        (9.6 + 0j, 9.25 + 0j),
        (9.3 + 0j, 9.25 + 0j),
        (at(10.0, 0.29), None),
        (at(10.0, 0.31), None),
        (at(10.0, -0.29), None),
        (at(10.6, 0.31), None),
    ],
)
def test_a_ball_inside_is_pushed_out_by_the_least_depth(p, there):
    """Through the nearest side, an end included, once and not farther."""
    ball = Ball(p, 3 + 1j, R)
    found = put_outside(ball, PADDLE)
    depth = -gap(ball, PADDLE, 0.0, [0])
    if there is None:
        assert gap(found, PADDLE, 0.0, [0]) == pytest.approx(0.0, abs=1e-12)
        assert abs(found.position - p) <= max(depth, R + abs(math.sin(0.01) * 10.0)) + 1e-12
    else:
        assert found.position == pytest.approx(there, abs=1e-12)


def test_a_ball_that_overlaps_nothing_is_given_back_itself():
    """Also one that touches, or overlaps by what a bounce may leave."""
    for p in (5 + 0j, 10.75 + 0j, 10.75 - 0.5 * OVERLAP * R, at(10.0, 2.0), 0j):
        ball = Ball(p, 1 + 0j, R)
        assert freed(ball, [PADDLE], [(PERMANENT,)]) is ball


def test_an_empty_slot_holds_no_ball():
    """Only living sectors push."""
    ring = Ring(10.0, 0.5, 0.3, 4)
    ball = Ball(at(10.0, math.pi / 2.0), 1j, R)
    assert freed(ball, [ring], [(1, 0, 1, 1)]) is ball
    assert put_outside(ball, ring, layers=[(0, 1, 0, 0)]) != ball


def test_a_ball_in_too_narrow_a_gap_goes_outward_on_its_bearing():
    """No push frees it: it is put at the nearest free place outward, where it touches both ends' corners."""
    ring = Ring(10.0, 0.5, math.pi - 0.02, 1, math.pi)
    ball = Ball(10.0 + 0j, 1 + 0j, R)
    found = put_outside(ball, ring)
    assert found.position.imag == 0.0
    half_gap = 10.5 * math.sin(0.02)
    assert found.position.real == pytest.approx(10.5 * math.cos(0.02) + math.sqrt(R * R - half_gap * half_gap), abs=1e-12)


def test_outward_may_lead_through_the_next_ring():
    """The gap is too narrow, and behind it lies a wall: the first free place is beyond both."""
    gap_ring, wall = Ring(10.0, 0.5, math.pi - 0.02, 1, math.pi), Ring(10.8, 0.2, math.pi, 1)
    found = put_outside(Ball(10.0 + 0j, 1 + 0j, R), gap_ring, wall)
    assert found.position == pytest.approx(11.25 + 0j, abs=1e-12)


def test_a_ball_between_two_straight_ends_goes_out_between_them_where_they_are_wide_enough():
    """A wedge whose sides are 2 r apart inside the band: the ball rests beside both straight ends."""
    half = math.asin(R / 10.0)
    ring = Ring(10.0, 1.0, math.pi - half, 1, math.pi)
    found = put_outside(Ball(9.5 + 0j, 1 + 0j, R), ring)
    assert found.position == pytest.approx(10.0 + 0j, abs=1e-9)


def test_a_ball_as_large_as_the_hole_goes_outward_past_the_inner_corners():
    """Where the far ends lie behind the ball, the inner corners hold it; it had been put a great distance away."""
    ring = Ring(1.0, 0.7, 0.3, 3)
    for bearing in (math.pi / 3.0, math.pi, -math.pi / 3.0, 1.0, 3.0):
        for distance in (0.0, 1e-9, 0.05, 0.2):
            found = put_outside(Ball(at(distance, bearing), 1 + 0j, 0.45), ring)
            assert abs(found.position) < 1.7 + 0.46


def test_a_ball_at_the_very_centre_of_a_hole_too_small_goes_where_it_flies():
    """The exact centre has no angle of its own; that of the velocity is taken."""
    found = put_outside(Ball(0j, 1j, 0.8), Ring(1.0, 0.5, math.pi, 1))
    assert found.position == pytest.approx(2.3j)


def test_a_ball_that_no_place_on_its_way_frees_is_put_outside_of_everything(monkeypatch):
    """The search outward is bounded too."""
    module = __import__("sys").modules["physics.escape"]
    monkeypatch.setattr(module, "MAX_STEPS", 1)
    gap_ring, wall = Ring(10.0, 0.5, math.pi - 0.02, 1, math.pi), Ring(10.8, 0.2, math.pi, 1)
    assert put_outside(Ball(10.0 + 0j, 1 + 0j, R), gap_ring, wall).position == pytest.approx(11.25 + 0j)


@st.composite
def crowded(draw):
    """One to three rings, which may overlap each other, and a ball anywhere."""
    found = draw(st.lists(rings(), min_size=1, max_size=3))
    ball = Ball(at(draw(reals(0.0, 12.0)), draw(angles())), 1 + 1j, draw(reals(0.05, 1.0)))
    layers = [tuple(draw(st.lists(st.integers(0, 1), min_size=ring.count, max_size=ring.count))) for ring in found]
    return ball, found, layers


@given(crowded())
def test_any_ball_is_freed(scene):
    """Whatever it overlaps; and it is left alone if it overlaps nothing."""
    ball, found, layers = scene
    outside = put_outside(ball, *found, layers=layers)
    if clearance(ball, found, layers) > 0.0:
        assert outside is ball
    if clearance(ball, found, layers) < -1.1 * OVERLAP * ball.radius:
        assert outside is not ball
    assert abs(outside.position) <= max([ring.outer_radius for ring in found] + [abs(ball.position)]) + ball.radius + 1e-9
