"""The search for the first touch: any scene, its mirror image, a search cut in two, and the bound on the steps."""

import cmath
import math
from random import Random

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import Ball, Ring, time_of_impact
from physics.sweep import turning_end
from tests.support.oracles.impact_oracle import EXACT, checked_impact, gap, mirrored_scene
from tests.support.strategies import angles, reals, rings
from tools.fuzz.impacts import check_impacts

R = 0.25


def at(radius, angle):
    """A point in polar coordinates."""
    return cmath.rect(radius, angle)


@st.composite
def scenes(draw):
    """A ring and a ball that is free at first, often near the band."""
    ring = draw(rings())
    ring = ring._replace(spin=draw(reals(-3.0, 3.0) | st.just(0.0)))
    radius = draw(reals(0.05, 1.0))
    distance = draw(reals(0.0, 12.0) | reals(-2.0, 2.0).map(lambda x: abs(ring.radius + x)))
    p = at(distance, draw(angles()))
    v = at(draw(reals(0.0, 20.0).filter(lambda speed: speed == 0.0 or speed > 1e-30)), draw(angles()))
    ball = Ball(p, v, radius)
    alive = tuple(draw(st.lists(st.integers(0, 1), min_size=ring.count, max_size=ring.count)))
    slots = [slot for slot in range(ring.count) if alive[slot]]
    assume(not slots or gap(ball, ring, 0.0, slots) > 1e-6)
    return ball, ring, alive


@given(scenes(), reals(0.0, 2.0))
def test_any_scene_is_right(scene, dt):
    """The gap is closed at the time found, to 1e-12 in 50 digits, and open before."""
    ball, ring, alive = scene
    checked_impact(ball, ring, dt, alive)


@given(scenes(), reals(0.1, 2.0))
def test_a_mirrored_scene_has_the_mirrored_impact_to_the_bit(scene, dt):
    """About the x axis: time and normal are those of the mirror image, exactly. A phase of pi has none: -pi is stored as pi."""
    ball, ring, alive = scene
    assume(ring.phase != math.pi)
    found = time_of_impact(ball, ring, dt, alive)
    mirrored = time_of_impact(*mirrored_scene(ball, ring), dt, (alive[0], *alive[:0:-1]))
    if found is None:
        assert mirrored is None
        return
    assert mirrored.time == found.time
    if mirrored.slot == -found.slot % ring.count:
        assert mirrored.contact.normal == found.contact.normal.conjugate()


@given(scenes(), reals(0.1, 2.0), reals(0.1, 0.9))
def test_two_searches_in_a_row_find_what_one_does(scene, dt, part):
    """Cutting the time in two changes nothing: the ring of the second half is the first's, turned."""
    ball, ring, alive = scene
    whole = time_of_impact(ball, ring, dt, alive)
    cut = dt * part
    first = time_of_impact(ball, ring, cut, alive)
    if first is not None:
        assert whole.slot == first.slot
        assert whole.time == pytest.approx(first.time, abs=1e-12)
        return
    assume(whole is None or whole.time > cut + 1e-9)
    second = time_of_impact(ball.moved(cut), ring.turned(cut), dt - cut, alive)
    assume(whole is not None or second is None)
    if whole is not None:
        assert second.time + cut == pytest.approx(whole.time, abs=1e-7)


def counted_steps(monkeypatch):
    """A list that grows by one for every step of a search."""
    seen = []
    real = turning_end.safe_step
    monkeypatch.setattr(turning_end, "safe_step", lambda *given: seen.append(1) or real(*given))
    return seen


def osculating():
    """Balls that graze a turning corner while their path, seen from the ring, curves as tightly as the corner's disc."""
    for spin in (0.3, 3.0):
        ring = Ring(10.0, 0.5, 0.3, 1, 0.0, spin)
        for corner, side in ((at(10.5, 0.3), 1.0), (at(9.5, 0.3), -1.0)):
            for lean in (0.0, 0.5, 1.0, 1.4, 1.57):
                normal = at(1.0, 0.3) * side * at(1.0, side * lean)
                surface = 1j * spin * corner
                for slip in (0.0, 1e-3, 0.03, 0.3, 1.0):
                    for sign in (1.0, -1.0):
                        v = surface + 1j * normal * sign * slip * abs(surface)
                        for miss in (0.0, 1e-12, 1e-9, 1e-6):
                            for before in (0.0, 0.1):
                                p = corner + normal * (R + miss)
                                by = cmath.rect(1.0, -spin * before / spin)
                                yield Ball(p - v * (before / spin), v, R), ring._replace(phase=(cmath.phase(by)) % math.tau)


def balls_at_a_face(overlap):
    """500 rings, each with a ball above its outer or inner face that flies away from it and overlaps it by so much."""
    chance = Random(1)
    for _ in range(500):
        count, ball_radius, side = chance.choice((3, 40, 400)), chance.choice((R, 0.6)), chance.choice((1, -1))
        ring = Ring(5.0, 0.4, chance.choice((0.6, 1.0)) * math.pi / count, count, 0.0, chance.choice((0.0, 0.7, -3.0)))
        theta, turn = chance.random() * math.tau, chance.uniform(-1.57, 1.57)
        distance = 5.0 + side * (0.4 + ball_radius - overlap)
        yield Ball(at(distance, theta), at(8.0 * side, theta + turn), ball_radius), ring


@pytest.mark.parametrize("overlap", [0.0, 0.1])
def test_asking_a_ball_for_ends_that_it_flies_away_from_finds_nothing_more(monkeypatch, overlap):
    """The search spares the ends behind a face only where it finds the same with them, to the bit."""
    spared = [time_of_impact(ball, ring, 0.5) for ball, ring in balls_at_a_face(overlap)]
    monkeypatch.setitem(time_of_impact.__globals__, "_leaves", lambda *_: False)
    assert [time_of_impact(ball, ring, 0.5) for ball, ring in balls_at_a_face(overlap)] == spared


def test_no_search_comes_near_the_bound_on_its_steps(monkeypatch):
    """Grazes built to be as slow as possible: osculating corners at every angle and slip, and what lies next to them."""
    seen = counted_steps(monkeypatch)
    most = 0
    for ball, ring in osculating():
        if gap(ball, ring, 0.0, [0]) < 0.0:
            continue
        seen.clear()
        dt = 2.0 / abs(ring.spin)
        found = time_of_impact(ball, ring, dt)
        most = max(most, len(seen))
        if found is not None:
            assert abs(gap(ball, ring, found.time, [0], mpmath)) < EXACT
    assert 30 <= most <= 40


def test_a_search_without_steps_left_ends_where_no_touch_precedes(monkeypatch):
    """The bound holds whatever happens: the ball stops short of the end instead of passing it."""
    monkeypatch.setattr(turning_end, "MAX_STEPS", 1)
    ball, ring = Ball(at(10.0, 0.6), at(8.0, 0.6 - math.pi / 2.0), R), Ring(10.0, 0.5, 0.3, 1, 0.0, 1.3)
    found = time_of_impact(ball, ring, 1.0)
    assert gap(ball, ring, found.time, [0]) > 0.0


def test_a_sample_of_the_fuzzer_s_impacts():
    """`python -m tools.fuzz --impacts 100000` does the same at length."""
    touches, faults = check_impacts(7, range(600), mpmath)
    assert touches > 40
    assert faults == []
