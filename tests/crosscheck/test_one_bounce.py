"""pymunk's bounces, against cases whose answer is known."""

import cmath
import math

import pytest

from tools.crosscheck.pymunk_model.one_bounce import Solver, Surface, TouchingBall
from tools.crosscheck.pymunk_model.ring_model import Geometry, ModelShape, Part, RingModel

GEOMETRY = Geometry(5.0, 0.5, 0.3, 4)
RADIUS = 0.25
OUTWARD = cmath.rect(1.0, 0.1)


@pytest.fixture
def model():
    return RingModel(GEOMETRY, 64)


def outer_face(model, spin=0.0):
    return Surface(ModelShape(model.outer_circle, Part.OUTER_CIRCLE, 0), GEOMETRY, 0.0, spin)


def inner_face(model, spin=0.0):
    return Surface(ModelShape(model.inner_circle, Part.INNER_CIRCLE, 0), GEOMETRY, 0.0, spin)


def outside(velocity):
    return TouchingBall(OUTWARD * (5.5 + RADIUS), velocity, OUTWARD, RADIUS)


def inside(velocity):
    return TouchingBall(OUTWARD * (4.5 - RADIUS), velocity, -OUTWARD, RADIUS)


@pytest.mark.parametrize("slant", [0.0, 0.5, 1.2])
def test_a_resting_face_is_a_mirror(model, slant):
    """Straight in is straight out; a slanted velocity keeps what lies along the face."""
    after = Solver().bounced(outside(-2.0 * OUTWARD * cmath.rect(1.0, slant)), outer_face(model), 0.0)
    assert abs(after - 2.0 * OUTWARD * cmath.rect(1.0, -slant)) < 4e-13  # 2 |v| times the normal's noise, 7e-15 23 = 1.6e-13
    after = Solver().bounced(inside(2.0 * OUTWARD * cmath.rect(1.0, slant)), inner_face(model), 0.0)
    assert abs(after + 2.0 * OUTWARD * cmath.rect(1.0, -slant)) < 4e-13


def test_a_moving_end_adds_twice_its_velocity(model):
    """An end that comes with w q towards a ball at rest: the ball leaves with 2 w q."""
    outward = cmath.rect(1.0, 0.3 + math.pi / 2.0)
    end = next(segment for segment in model.ends(0) if complex(*segment.a).imag > 0.0)
    surface = Surface(ModelShape(end, Part.END, 0), GEOMETRY, 0.0, 2.0)
    ball = TouchingBall(cmath.rect(5.0, 0.3) + RADIUS * outward, 0j, outward, RADIUS)
    after = Solver().bounced(ball, surface, 0.0)
    # 20 turned by the normal's noise, 7e-15 (5.5 + 0.25) / 0.25 = 1.6e-13, and 2 w times the position's, 7e-15 5.5 = 4e-14
    assert abs(after - 2.0 * 2.0 * 5.0 * outward) < 20.0 * 1.6e-13 + 4.0 * 4e-14


def test_friction_slows_the_slide_by_coulombs_law(model):
    """Coefficient c: the speed along the face falls by 2 c times the speed into it, until it would stick."""
    slide = 1j * OUTWARD
    for ball, surface, away in (
        (outside(slide - OUTWARD), outer_face(model), OUTWARD),
        (inside(slide + OUTWARD), inner_face(model), -OUTWARD),
    ):
        assert abs(Solver().bounced(ball, surface, 0.25) - (away + 0.5 * slide)) < 4e-13
        assert abs(Solver().bounced(ball, surface, 0.75) - away) < 4e-13


@pytest.mark.parametrize("spin", [0.5, -2.0])
def test_a_turning_face_takes_the_ball_along(model, spin):
    """With enough grip the ball leaves with the surface's velocity along the face: w R, outside and inside alike."""
    along = 1j * OUTWARD * spin
    after = Solver().bounced(outside(-2.0 * OUTWARD), outer_face(model, spin), 5.0)
    assert abs(after - (2.0 * OUTWARD + along * 5.5)) < 1e-12
    after = Solver().bounced(inside(2.0 * OUTWARD), inner_face(model, spin), 5.0)
    assert abs(after - (-2.0 * OUTWARD + along * 4.5)) < 1e-12


def test_one_bounce_leaves_nothing_to_the_next(model):
    """The same bounce from a fresh solver and from one that has answered others: the same bits."""
    used = Solver()
    for velocity in (-3.0 + 1.0j, 2.0 - 5.0j, -1.0 - 1.0j):
        used.bounced(outside(velocity), outer_face(model, 1.0), 0.5)
        used.bounced(inside(-velocity), inner_face(model, -1.0), 0.5)
    ball = outside(-2.0 + 0.3j)
    assert used.bounced(ball, outer_face(model, 0.7), 0.3) == Solver().bounced(ball, outer_face(model, 0.7), 0.3)


def test_a_ball_that_leaves_is_not_answered(model):
    """Its velocity stays as it is."""
    assert Solver().bounced(outside(2.0 * OUTWARD), outer_face(model), 0.0) == 2.0 * OUTWARD
    assert Solver().bounced(inside(-2.0 * OUTWARD), inner_face(model), 0.0) == -2.0 * OUTWARD
