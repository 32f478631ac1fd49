"""pymunk's first touches with resting and turning rings, against cases whose answer is known."""

import cmath
import math
import random

import pytest

from tools.crosscheck.pymunk_model.ring_model import Geometry, RingModel
from tools.crosscheck.pymunk_model.sweep import BallFlight, first_touch

GEOMETRY = Geometry(5.0, 0.5, 0.3, 4)
RADIUS = 0.25
NOISE = 1e-12


@pytest.fixture
def model():
    return RingModel(GEOMETRY, 64)


def touch(model, position, velocity, span, spin=0.0):
    return first_touch(model, BallFlight(position, velocity, RADIUS, spin), span, NOISE)


def test_a_ball_flying_inwards_meets_the_outer_face_when_geometry_says(model):
    """From 7 at speed 2 to 5.5 + 0.25: after 0.625 s, and the window around it is as wide as the noise."""
    window = touch(model, cmath.rect(7.0, 0.1), cmath.rect(-2.0, 0.1), 1.0)
    assert window.middle == pytest.approx(0.625, abs=1e-14)
    assert window.early < window.middle < window.late
    assert window.late - window.early == pytest.approx(2.0 * NOISE / 2.0, rel=1e-2)


def test_a_ball_flying_outwards_meets_the_inner_face_when_geometry_says(model):
    """From 0 at speed 2 to 4.5 - 0.25, after 2.125 s; the window is as narrow as outside."""
    window = touch(model, 0j, cmath.rect(2.0, 0.1), 3.0)
    assert window.middle == pytest.approx(2.125, abs=1e-14)
    assert window.early < window.middle < window.late
    assert window.late - window.early == pytest.approx(2.0 * NOISE / 2.0, rel=1e-2)


def test_a_ball_that_flies_by_meets_nothing(model):
    """Through the middle of a gap, and away from everything."""
    gap = math.pi / 4.0
    for start, velocity in ((cmath.rect(7.0, gap), cmath.rect(-2.0, gap)), (cmath.rect(7.0, 0.1), cmath.rect(2.0, 0.1))):
        assert touch(model, start, velocity, 1.0) == (math.inf, math.inf, math.inf)


def test_a_broken_brick_is_no_obstacle(model):
    """The same flight meets the outer face only while the slot is full."""
    model.set_alive((0, 1, 1, 1))
    assert touch(model, cmath.rect(7.0, 0.1), cmath.rect(-2.0, 0.1), 1.0).early == math.inf


def test_a_graze_has_no_latest_time(model):
    """A path that misses the corner by less than the noise: a larger ball touches, a smaller one does not."""
    corner = cmath.rect(5.5, 0.3)
    along = cmath.rect(1.0, 0.3 + 3.0 * math.pi / 4.0)
    start = corner + cmath.rect(RADIUS + 0.5 * NOISE, 0.3 + math.pi / 4.0) - 0.5 * along
    window = touch(model, start, along, 1.0)
    assert window.early < 0.5
    assert window.late == math.inf


def test_a_ball_that_leaves_a_surface_does_not_touch_it(model):
    """It starts in contact: flying off it is free, flying into it touches at once."""
    position = cmath.rect(5.5 + RADIUS, 0.1)
    assert touch(model, position, cmath.rect(2.0, 0.1), 0.1).early == math.inf
    assert touch(model, position, cmath.rect(-2.0, 0.1), 0.1).early == 0.0


def test_a_ball_that_leaves_an_inner_face_comes_to_it_again():
    """Along a chord: from the face at bearing 0.1, turned 80 degrees off its normal, to the face 20 degrees farther on."""
    closed = RingModel(Geometry(5.0, 0.5, math.pi, 1), 64)
    radius = 4.5 - RADIUS
    start, heading = cmath.rect(radius, 0.1), cmath.rect(1.0, 0.1 + math.pi - math.radians(80.0))
    window = first_touch(closed, BallFlight(start, heading, RADIUS, 0.0), 3.0, NOISE)
    assert window.middle == pytest.approx(2.0 * radius * math.cos(math.radians(80.0)), abs=1e-13)


def angle_of_touch(spin, time):
    """An end at bearing 0.3 + spin t, and a ball that at `time` touches its middle."""
    return cmath.rect(5.0, 0.3 + spin * time) + RADIUS * 1j * cmath.rect(1.0, 0.3 + spin * time)


@pytest.mark.parametrize("spin", [-1.5, -0.2, 1e-3, 0.4, 1.2])
def test_a_turning_end_is_met_when_it_must_be(model, spin):
    """A ball aimed at where the end will be after 0.1 s: that time, in a window as narrow as rounding allows."""
    heading = -8.0j * cmath.rect(1.0, 0.3 + spin * 0.1)
    start = angle_of_touch(spin, 0.1) - heading * 0.1
    window = touch(model, start, heading, 0.2, spin)
    assert window.middle == pytest.approx(0.1, abs=1e-13)
    assert window.early <= 0.1 <= window.late
    assert window.late - window.early <= 10.0 * NOISE / (8.0 - abs(spin) * 5.0)


def nearest(spin, position, time):
    """Plane geometry: the gap between a ball and the four sectors of GEOMETRY, turned."""
    local = position * cmath.rect(1.0, -spin * time)
    pitch = math.pi / 2.0
    gaps = []
    for slot in range(4):
        p = local * cmath.rect(1.0, -slot * pitch)
        if abs(cmath.phase(p)) <= 0.3:
            gaps.append(max(4.5 - abs(p), abs(p) - 5.5))
        for side in (-0.3, 0.3):
            along = p * cmath.rect(1.0, -side)
            gaps.append(abs(along - min(max(along.real, 4.5), 5.5)))
    return min(gaps) - RADIUS


def test_flights_among_turning_sectors_are_told_from_one_another(model):
    """300 flights drawn at random, grazes among them: up to the window nothing touches, within it the gap closes."""
    chance = random.Random(7)
    met = 0
    for _ in range(300):
        start = cmath.rect(chance.choice((chance.uniform(0.0, 4.0), chance.uniform(5.9, 7.0))), chance.uniform(-4.0, 4.0))
        towards = cmath.rect(chance.uniform(4.3, 5.7), cmath.phase(start) + chance.uniform(-0.4, 0.4)) - start
        velocity, spin = towards * (8.0 / abs(towards)), chance.uniform(-1.2, 1.2)
        window = touch(model, start, velocity, 0.4, spin)
        free = min(window.early, 0.4)
        assert min(nearest(spin, start + velocity * t, t) for t in (free * k / 400.0 for k in range(400))) > -NOISE
        if window.late < math.inf:
            met += 1
            assert nearest(spin, start + velocity * window.late, window.late) < 1e-9
            assert window.late - window.early < 1e-6
    assert met > 150


def test_a_ball_that_a_turning_end_follows_is_met_again(model):
    """It leaves the end faster than the end follows, along a path that bends back in the end's frame."""
    spin = 1.0
    start = cmath.rect(5.0, 0.3) + RADIUS * 1j * cmath.rect(1.0, 0.3)
    leaving = (spin * 5.0 + 0.01) * 1j * cmath.rect(1.0, 0.3) + 6.0 * cmath.rect(1.0, 0.3)
    window = touch(model, start, leaving, 0.2, spin)
    assert window.early == pytest.approx(0.01 / 6.0, rel=0.1)
    assert nearest(spin, start + leaving * window.early, window.early) > -NOISE
    before = [window.early * k / 100.0 for k in range(1, 100)]
    assert all(nearest(spin, start + leaving * t, t) > 0.0 for t in before)


def test_a_ball_that_comes_to_an_end_from_beyond_its_corner_is_met():
    """Nearly along the end, over its corner: a larger ball would touch the corner, this one touches the end behind it."""
    turning = RingModel(Geometry(8.276450018258025, 0.5046063336358122, 0.11492789802502813, 3), 8)
    turn = cmath.rect(1.0, -5.858395620018938)
    position, velocity = 7.462821171083563 - 2.128144085411947j, 7.953329274782134 - 0.8628751050375074j
    flight = BallFlight(position * turn, velocity * turn, 0.248823214445567, 0.20608280666327908)
    window = first_touch(turning, flight, 1.0 / 240.0, NOISE)
    assert window.early <= 0.0030116947330265003 <= window.late < window.early + 1e-8
