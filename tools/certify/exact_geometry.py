"""The exact geometry: a ball at one moment, seen from a ring and from the ends of its sectors.

The model. At time s of a tick, sector k of a ring is the set of points rho e^(i psi) with |rho - R| <= h and
|psi - (phase + spin s + 2 pi k / n)| <= alpha; pi is the number pi, and every float stands for exactly the number it is. The
one exception: a half angle equal to the float pi / n is taken as pi / n, a closed ring. The ball's centre is
P(s) = p + v (s - start). A ball touches a sector where its centre is within its radius of it.

Everything is seen in the ring's own frame, in which slot 0's middle lies on the x axis and sectors rest. With e the unit
vector along an end, X = e . P and Y = e x P, in that frame

    X' = e . v + spin Y        X'' =  2 spin (e x v) - spin^2 X
    Y' = e x v - spin X        Y'' = -2 spin (e . v) - spin^2 Y

where v is the ball's velocity as the world sees it, in the ring's coordinates.
"""

import math
from functools import lru_cache
from typing import NamedTuple

from flint import arb, ctx

from physics import Ring
from tools.certify.flights import StraightFlight

PRECISION = 192
"""Bits of every midpoint. The widths that are promised, 1e-30, need 140 of them."""


class ExactBall(NamedTuple):
    """A ball in flight, as exact numbers. speed: an upper bound of |v|."""

    px: arb
    py: arb
    vx: arb
    vy: arb
    radius: arb
    start: arb
    speed: arb


class ExactRing(NamedTuple):
    """A ring, as exact numbers. sine, cosine: of the phase."""

    inner: arb
    outer: arb
    phase: arb
    spin: arb
    turns: bool
    sine: arb
    cosine: arb


class FrameState(NamedTuple):
    """A ball at one moment, in a ring's frame. square: |P|^2. outward: P . v. sine, cosine: of the ring's turn."""

    time: arb
    x: arb
    y: arb
    vx: arb
    vy: arb
    square: arb
    outward: arb
    sine: arb
    cosine: arb


class EndVector(NamedTuple):
    """One straight end of a sector in its ring's frame: a unit vector; sign +1 for the counter-clockwise end, -1 the other."""

    cosine: arb
    sine: arb
    sign: int


class SectorShape(NamedTuple):
    """One sector in its ring's frame. wide: half angle above a quarter turn. whole: it closes its ring alone."""

    ends: tuple[EndVector, EndVector]
    wide: bool
    whole: bool


class Beside(NamedTuple):
    """A ball beside an end: X, Y of its centre, their rates, and X, Y of its velocity."""

    x: arb
    y: arb
    dx: arb
    dy: arb
    vx: arb
    vy: arb


def use_precision() -> None:
    """Set the precision of this process."""
    ctx.prec = PRECISION


def exact_ball(flight: StraightFlight) -> ExactBall:
    """The ball of a flight."""
    vx, vy = arb(flight.velocity.real), arb(flight.velocity.imag)
    speed = (vx * vx + vy * vy).sqrt().upper()
    p = flight.position
    return ExactBall(arb(p.real), arb(p.imag), vx, vy, arb(flight.radius), arb(flight.start), speed)


def exact_ring(ring: Ring) -> ExactRing:
    """A ring's exact numbers."""
    radius, half_width, phase = arb(ring.radius), arb(ring.half_width), arb(ring.phase)
    sine, cosine = phase.sin_cos()
    return ExactRing(radius - half_width, radius + half_width, phase, arb(ring.spin), ring.spin != 0.0, sine, cosine)


@lru_cache(maxsize=4096)
def sector(count: int, half_angle: float, slot: int) -> SectorShape:
    """A slot's sector."""
    closed = half_angle >= math.pi / count
    half = arb.pi() / count if closed else arb(half_angle)
    middle = 2 * arb.pi() * slot / count
    ends = []
    for sign in (1, -1):
        sine, cosine = (middle + sign * half).sin_cos()
        ends.append(EndVector(cosine, sine, sign))
    return SectorShape((ends[0], ends[1]), half_angle > math.pi / 2.0, closed and count == 1)


def moment(ball: ExactBall, ring: ExactRing, time: arb) -> FrameState:
    """The ball at a time, which may be an interval, seen by a ring."""
    flown = time - ball.start
    px, py = ball.px + ball.vx * flown, ball.py + ball.vy * flown
    sine, cosine = (ring.phase + ring.spin * time).sin_cos() if ring.turns else (ring.sine, ring.cosine)
    return FrameState(
        time,
        cosine * px + sine * py,
        cosine * py - sine * px,
        cosine * ball.vx + sine * ball.vy,
        cosine * ball.vy - sine * ball.vx,
        px * px + py * py,
        px * ball.vx + py * ball.vy,
        sine,
        cosine,
    )


def beside(at: FrameState, end: EndVector, ring: ExactRing) -> Beside:
    """The ball seen from an end."""
    c, s = end.cosine, end.sine
    x, y = c * at.x + s * at.y, c * at.y - s * at.x
    vx, vy = c * at.vx + s * at.vy, c * at.vy - s * at.vx
    if not ring.turns:
        return Beside(x, y, vx, vy, vx, vy)
    return Beside(x, y, vx + ring.spin * y, vy - ring.spin * x, vx, vy)
