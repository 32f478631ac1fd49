"""The moment at which a flight touches a sector, in an interval of 2^-139 s, and the exact normal there.

Each feature's gap is a function of time: |P| - outer - r, inner - |P| - r, sign Y - r, |P - corner| - r. Where it falls from
above 0 to below 0, it is 0 in between (it is continuous), and where its feature's own conditions hold throughout, the
distance from the centre to that feature is r there: a touch.
"""

from collections.abc import Iterator
from typing import NamedTuple

from flint import arb

from physics import Feature
from tools.certify.exact_geometry import EndVector, ExactBall, ExactRing, FrameState, SectorShape, beside, moment

HALF_WIDTH = arb(2) ** -140
"""Seconds: half of the interval in which the touch is. A normal turns by at most 1e5 rad/s or so: it is known to 1e-36."""

_NEWTON_STEPS = 8


class ProvedTouch(NamedTuple):
    """A proved touch. time: an enclosure. closing: minus the gap's rate there. nx, ny: the normal. bend: 1 / curve radius."""

    time: arb
    closing: arb
    nx: arb
    ny: arb
    feature: Feature
    curvature: arb


class _FeatureShape(NamedTuple):
    """One feature: which, and of which end and radius if it is an end or a corner."""

    feature: Feature
    end: EndVector | None
    rho: arb | None


class FeatureGap(NamedTuple):
    """A feature at a moment: its gap, the gap's rate, the normal, and how much a move of the centre turns that.

    owned: whether the sector's nearest point is on this feature, for certain.
    """

    gap: arb
    rate: arb
    nx: arb
    ny: arb
    curvature: arb
    owned: bool


def touch(ball: ExactBall, ring: ExactRing, place: SectorShape, near: arb, within: arb) -> ProvedTouch | None:
    """The touch near a time, of the feature whose gap there is certainly within a bound; None if none can be proved."""
    for shape in _shapes(ring, place):
        now = _seen(moment(ball, ring, near), ball, ring, place, shape)
        if abs(now.gap) < within:
            found = _root(ball, ring, place, shape, near)
            if found is not None:
                return found
    return None


def _shapes(ring: ExactRing, place: SectorShape) -> Iterator[_FeatureShape]:
    """The features of a sector."""
    yield _FeatureShape(Feature.OUTER_FACE, None, None)
    yield _FeatureShape(Feature.INNER_FACE, None, None)
    if not place.whole:
        for end in place.ends:
            yield _FeatureShape(Feature.END, end, None)
            yield _FeatureShape(Feature.CORNER, end, ring.inner)
            yield _FeatureShape(Feature.CORNER, end, ring.outer)


def _root(ball: ExactBall, ring: ExactRing, place: SectorShape, shape: _FeatureShape, near: arb) -> ProvedTouch | None:
    """The time near another at which a feature's gap falls through 0, by Newton's steps and one change of sign."""
    time = near
    for _ in range(_NEWTON_STEPS):
        now = _seen(moment(ball, ring, time), ball, ring, place, shape)
        step = (now.gap / now.rate).mid()
        if not step.is_finite():
            return None
        time = (time - step).mid()
        if abs(step) < HALF_WIDTH / 1024:
            break
    before = _seen(moment(ball, ring, time - HALF_WIDTH), ball, ring, place, shape)
    after = _seen(moment(ball, ring, time + HALF_WIDTH), ball, ring, place, shape)
    interval = arb(time, HALF_WIDTH)
    at = moment(ball, ring, interval)
    there = _seen(at, ball, ring, place, shape)
    falls, rises = before.gap > 0 and after.gap < 0, before.gap < 0 and after.gap > 0
    if not ((falls or rises) and there.owned):
        return None
    nx, ny = at.cosine * there.nx - at.sine * there.ny, at.sine * there.nx + at.cosine * there.ny
    return ProvedTouch(interval, -there.rate, nx, ny, shape.feature, there.curvature)


def _seen(at: FrameState, ball: ExactBall, ring: ExactRing, place: SectorShape, shape: _FeatureShape) -> FeatureGap:
    """A feature seen from the ball at a moment."""
    if shape.end is None:
        return _seen_face(at, ball, ring, place, outer=shape.feature == Feature.OUTER_FACE)
    if shape.rho is None:
        return _seen_end(at, ball, ring, shape.end)
    return _seen_corner(at, ball, ring, shape.end, shape.rho)


def _seen_face(at: FrameState, ball: ExactBall, ring: ExactRing, place: SectorShape, *, outer: bool) -> FeatureGap:
    """A face: the ball's bearing lies within the sector's."""
    distance = at.square.sqrt()
    rate, nx, ny = at.outward / distance, at.x / distance, at.y / distance
    owned = True
    if not place.whole:
        ahead, behind = beside(at, place.ends[0], ring).y < 0, beside(at, place.ends[1], ring).y > 0
        owned = bool(ahead or behind) if place.wide else bool(ahead and behind)
    if outer:
        return FeatureGap(distance - ring.outer - ball.radius, rate, nx, ny, 1 / distance, owned)
    return FeatureGap(ring.inner - distance - ball.radius, -rate, -nx, -ny, 1 / distance, owned)


def _seen_end(at: FrameState, ball: ExactBall, ring: ExactRing, end: EndVector) -> FeatureGap:
    """An end: the ball is straight beside it, on the side away from its sector."""
    seen = beside(at, end, ring)
    owned = bool(ring.inner < seen.x and seen.x < ring.outer)
    return FeatureGap(
        end.sign * seen.y - ball.radius, end.sign * seen.dy, -end.sign * end.sine, end.sign * end.cosine, arb(0), owned
    )


def _seen_corner(at: FrameState, ball: ExactBall, ring: ExactRing, end: EndVector, rho: arb) -> FeatureGap:
    """A corner: the ball is beyond the end's length and beyond its line."""
    seen = beside(at, end, ring)
    run = seen.x - rho
    distance = (run * run + seen.y * seen.y).sqrt()
    rate = (run * seen.dx + seen.y * seen.dy) / distance
    beyond = seen.x > ring.outer if rho is ring.outer else seen.x < ring.inner
    owned = bool(beyond and end.sign * seen.y > 0)
    along, across = run / distance, seen.y / distance
    nx, ny = end.cosine * along - end.sine * across, end.sine * along + end.cosine * across
    return FeatureGap(distance - ball.radius, rate, nx, ny, 1 / distance, owned)
