"""pymunk's first touches and its bounces, against cases whose answer is known."""

import cmath
import math

import pytest

from tools.crosscheck.pymunk_model.one_bounce import Surface, bounced
from tools.crosscheck.pymunk_model.ring_model import Geometry, Part, RingModel
from tools.crosscheck.pymunk_model.sweep import first_touch

GEOMETRY = Geometry(5.0, 0.5, 0.3, 4)
RADIUS = 0.25
NOISE = 1e-12


@pytest.fixture
def model():
    return RingModel(GEOMETRY, 64)


def test_a_ball_flying_inwards_meets_the_outer_face_when_geometry_says(model):
    """From 7 at speed 2 to 5.5 + 0.25: after 0.625 s, and the window around it is as wide as the noise."""
    window = first_touch(model, cmath.rect(7.0, 0.1), cmath.rect(-2.0, 0.1), RADIUS, 1.0, NOISE)
    assert window.middle == pytest.approx(0.625, abs=1e-14)
    assert window.early < window.middle < window.late
    assert window.late - window.early == pytest.approx(2.0 * NOISE / 2.0, rel=1e-2)


def test_a_ball_flying_outwards_meets_the_inner_face_within_the_window_of_the_facets(model):
    """From 0 at speed 2 to 4.5 - 0.25, after 2.125 s; the chords lie inside, so that they are met earlier."""
    window = first_touch(model, 0j, cmath.rect(2.0, 0.1), RADIUS, 3.0, NOISE)
    assert window.early < window.middle <= 2.125 <= window.late
    assert window.late - window.early == pytest.approx(2.0 * model.inner_sagitta / 2.0, rel=1e-2)


def test_a_ball_that_flies_by_meets_nothing(model):
    """Through the middle of a gap, and away from everything."""
    gap = math.pi / 4.0
    for start, velocity in ((cmath.rect(7.0, gap), cmath.rect(-2.0, gap)), (cmath.rect(7.0, 0.1), cmath.rect(2.0, 0.1))):
        assert first_touch(model, start, velocity, RADIUS, 1.0, NOISE) == (math.inf, math.inf, math.inf)


def test_a_broken_brick_is_no_obstacle(model):
    """The same flight meets the outer face only while the slot is full."""
    model.set_alive((0, 1, 1, 1))
    assert first_touch(model, cmath.rect(7.0, 0.1), cmath.rect(-2.0, 0.1), RADIUS, 1.0, NOISE).early == math.inf


def test_a_graze_has_no_latest_time(model):
    """A path that misses the corner by less than the noise: a larger ball touches, a smaller one does not."""
    corner = cmath.rect(5.5, 0.3)
    along = cmath.rect(1.0, 0.3 + 3.0 * math.pi / 4.0)
    start = corner + cmath.rect(RADIUS + 0.5 * NOISE, 0.3 + math.pi / 4.0) - 0.5 * along
    window = first_touch(model, start, along, RADIUS, 1.0, NOISE)
    assert window.early < 0.5
    assert window.late == math.inf


def test_a_ball_that_leaves_a_surface_does_not_touch_it(model):
    """It starts in contact: flying off it is free, flying into it touches at once."""
    place = cmath.rect(5.5 + RADIUS, 0.1)
    assert first_touch(model, place, cmath.rect(2.0, 0.1), RADIUS, 0.1, NOISE).early == math.inf
    assert first_touch(model, place, cmath.rect(-2.0, 0.1), RADIUS, 0.1, NOISE).early == 0.0


def outer_surface(model, spin=0.0):
    return Surface(model.outer_circle, GEOMETRY, 0.0, spin)


def test_a_resting_face_is_a_mirror(model):
    """Straight in is straight out; a slanted velocity keeps what lies along the face."""
    place = cmath.rect(5.5 + RADIUS, 0.1)
    for slant in (0.0, 0.5, 1.2):
        after = bounced(place, cmath.rect(-2.0, 0.1 + slant), RADIUS, outer_surface(model), 0.0)
        assert abs(after - cmath.rect(2.0, 0.1 - slant)) < 4e-13  # 2 |v| times the normal's noise, 7e-15 23 = 1.6e-13


def test_a_moving_end_adds_twice_its_velocity(model):
    """An end that comes with w q towards a ball at rest: the ball leaves with 2 w q."""
    end = next(piece for piece in model.slots[0] if piece.part == Part.END and complex(*piece.shape.a).imag > 0.0)
    outward = cmath.rect(1.0, 0.3 + math.pi / 2.0)
    place = cmath.rect(5.0, 0.3) + RADIUS * outward
    after = bounced(place, 0j, RADIUS, Surface(end, GEOMETRY, 0.0, 2.0), 0.0)
    # 20 turned by the normal's noise, 7e-15 (5.5 + 0.25) / 0.25 = 1.6e-13, and 2 w times the place's, 7e-15 5.5 = 4e-14
    assert abs(after - 2.0 * 2.0 * 5.0 * outward) < 20.0 * 1.6e-13 + 4.0 * 4e-14


def test_friction_slows_the_slide_by_coulombs_law(model):
    """Coefficient c: the speed along the face falls by 2 c times the speed into it, until it would stick."""
    place, radial = cmath.rect(5.5 + RADIUS, 0.0), 1.0
    after = bounced(place, complex(-radial, 1.0), RADIUS, outer_surface(model), 0.25)
    assert abs(after - complex(1.0, 0.5)) < 4e-13
    assert abs(bounced(place, complex(-radial, 1.0), RADIUS, outer_surface(model), 0.75) - 1.0) < 4e-13
