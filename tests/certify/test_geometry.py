"""The exact geometry agrees with 50 digits of another, and the proof of no touch with dense samples."""

import math
from fractions import Fraction

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

pytest.importorskip("flint", reason="the proofs need python-flint, the extra [proof]")

from flint import arb

from physics import Ball, Ring
from tests.support.oracles.impact_oracle import gap
from tests.support.strategies import angles, points, reals
from tools.certify.exact_geometry import exact_ball, exact_ring, moment, sector, use_precision
from tools.certify.exclusion import ring_is_far, sectors_near
from tools.certify.flights import StraightFlight
from tools.certify.no_touch import Separation, TimeWindow, apart, misses, touches
from tools.certify.signs import FunctionOnInterval, positive

use_precision()


@st.composite
def wide_rings(draw):
    """Rings of any width, closed ones and half turns among them, turning or not."""
    count = draw(st.integers(1, 6))
    fill = draw(reals(0.02, 0.99) | st.sampled_from([0.5, 1.0]))
    radius = draw(reals(1.0, 8.0))
    spin = draw(st.just(0.0) | reals(-400.0, 400.0))
    return Ring(radius, draw(reals(0.01, 0.9)) * radius, fill * math.pi / count, count, draw(angles()), spin)


@st.composite
def flights(draw):
    """A ball near a ring, up to some radii of flight in a tick."""
    ring = draw(wide_rings())
    ball_radius = draw(reals(0.05, 1.0))
    v = draw(points(1.0)) * draw(st.sampled_from([1.0, 30.0, 1000.0]))
    v = v if abs(v) > 1e-30 else 0j
    p = draw(points(10.0))
    layers = ((1,) * ring.count,)
    return ring, StraightFlight(0, p, v, ball_radius, 0.0, 1.0 / 240.0, None, layers, {})


def exact_gap(flight, ring, time, slot):
    """The gap with 50 digits."""
    return gap(Ball(flight.position, flight.velocity, flight.radius), ring, time, [slot], mpmath)


@given(flights(), reals(0.0, 1.0))
def test_touching_is_a_gap_below_zero(found, share):
    """At any moment, for any sector: the seven regions are the points within the radius of the sector, and no others."""
    ring, flight = found
    ball, exact = exact_ball(flight), exact_ring(ring)
    time = share / 240.0
    at = moment(ball, exact, arb(time))
    for slot in range(ring.count):
        place = sector(ring.count, ring.half_angle, slot)
        there = exact_gap(flight, ring, time, slot)
        closed = ring.half_angle * ring.count >= math.pi  # its half angle is taken as pi / count, not as the float
        if abs(there) < (1e-14 if closed else 1e-40):  # the 50 digits end there
            continue
        assert touches(at, exact, place, ball.radius) == (there < 0)
        assert misses(at, exact, place, ball.radius) == (there > 0)


@settings(max_examples=60)
@given(flights())
def test_apart_agrees_with_samples(found):
    """Where the proof finds no touch, no sample overlaps; where it names a moment of a touch, the gap there is below 0."""
    ring, flight = found
    ball, exact = exact_ball(flight), exact_ring(ring)
    window = TimeWindow(ball.start, arb(flight.stop), first=False, last=False)
    for slot in range(ring.count):
        place = sector(ring.count, ring.half_angle, slot)
        search = apart(ball, exact, place, window, ball.radius, arb(0))
        gaps = [gap(Ball(flight.position, flight.velocity, flight.radius), ring, k / 240e3, [slot]) for k in range(0, 1001, 4)]
        if search.finding == Separation.APART:
            assert min(gaps) > -1e-12
        elif search.finding == Separation.TOUCHED:
            time = float(search.time.mid())
            assert exact_gap(flight, ring, time, slot) < 1e-12
        else:
            assert abs(min(gaps)) < 1e-3
        if min(gaps) < -1e-9:
            assert search.finding == Separation.TOUCHED


@given(flights())
def test_what_is_left_out_is_far(found):
    """A ring or a sector that the cheap test leaves out is touched by no sample of the flight."""
    ring, flight = found
    reach = abs(flight.velocity) * flight.stop + flight.radius
    near = (
        [] if ring_is_far(flight.position, reach, ring) else list(sectors_near(flight.position, reach, ring, 0.0, flight.stop))
    )
    for slot in set(range(ring.count)) - set(near):
        for k in range(0, 1001, 20):
            assert gap(Ball(flight.position, flight.velocity, flight.radius), ring, k / 240e3, [slot]) > 0.0


@given(*[st.fractions(-4, 4, max_denominator=64)] * 3)
def test_the_sign_of_a_parabola_is_exact(a, b, c):
    """c + b s + a s^2 on [0, 1] is found positive exactly where its least value is, double roots aside."""
    inside = [-b / (2 * a)] if a > 0 and 0 < -b / (2 * a) < 1 else []
    least = min(c + b * s + a * s * s for s in [Fraction(0), Fraction(1), *inside])
    number = [arb(x.numerator) / x.denominator for x in (c, b, c + b + a, b + 2 * a, 2 * a)]
    found = positive(FunctionOnInterval(*number, None), arb(1))
    assert found == (least > 0)
