"""A flight touches a sector at no moment: proved piece by piece.

The points within r of a sector are the union of seven regions, in the sector's frame (X, Y of an end as in `exact_geometry`):

    the face     |psi| <= alpha and inner - r <= |P| <= outer + r
    two strips   inner <= X <= outer and |Y| <= r, one beside each end
    four discs   (X - rho)^2 + Y^2 <= r^2, rho = inner and outer, one around each corner

For the point of a sector nearest to P lies on a face, and then P is on the same bearing; or inside an end, and then P is
straight beside it; or is a corner. And every point of a region is within r of its face, end or corner.

So a ball touches nothing of the sector during an interval of time if, for each region, some condition keeps P out of it
throughout. Each condition is a function of time above 0, decided by `signs`; where none holds for a whole interval it is
halved. Where the ball certainly is in a region at the middle of an interval, the flight touches, and the proof has failed.
"""

from collections.abc import Iterator
from enum import Enum
from typing import NamedTuple

from flint import arb

from tools.certify.exact_geometry import Beside, EndVector, ExactBall, ExactRing, FrameState, SectorShape, beside, moment
from tools.certify.signs import FunctionOnInterval, kept_apart

MOST_PIECES = 4000
"""Intervals that one flight beside one sector is cut into before it is given up as undecided. Twelve are usual."""

_FACE = 0


class Separation(Enum):
    """What the search for a proof came to."""

    APART = "no touch"
    TOUCHED = "a touch"
    OPEN = "no proof within the pieces allowed"


class TimeWindow(NamedTuple):
    """A part of a flight. first, last: whether the flight's start, and its end, belong to it and may be a touch."""

    start: arb
    stop: arb
    first: bool
    last: bool


class SeparationSearch(NamedTuple):
    """A finding, and a moment of the touch where there is one."""

    finding: Separation
    time: arb | None = None


class _TimePiece(NamedTuple):
    """An interval of time with the regions that the ball may still enter on it."""

    start: FrameState
    stop: FrameState
    first: bool
    last: bool
    regions: tuple[int, ...]


class _Body(NamedTuple):
    """A ball and a sector. radius: of the ball. tolerance: how deep a flight may start or end in a touch."""

    ball: ExactBall
    ring: ExactRing
    sector: SectorShape
    radius: arb
    tolerance: arb


def apart(
    ball: ExactBall, ring: ExactRing, place: SectorShape, window: TimeWindow, radius: arb, tolerance: arb
) -> SeparationSearch:
    """Whether a ball of some radius, on a ball's flight, stays apart from a sector throughout a window."""
    body = _Body(ball, ring, place, radius, tolerance)
    regions = (_FACE,) if place.whole else (_FACE, 1, 2, 3, 4, 5, 6)
    whole = _TimePiece(moment(ball, ring, window.start), moment(ball, ring, window.stop), window.first, window.last, regions)
    pieces = [whole]
    for _ in range(MOST_PIECES):
        if not pieces:
            return SeparationSearch(Separation.APART)
        piece = pieces.pop()
        left = _regions_left(body, piece)
        if not left:
            continue
        middle = moment(ball, ring, ((piece.start.time + piece.stop.time) / 2).mid())
        if touches(middle, ring, place, radius):
            return SeparationSearch(Separation.TOUCHED, middle.time)
        pieces.append(_TimePiece(middle, piece.stop, False, piece.last, left))
        pieces.append(_TimePiece(piece.start, middle, piece.first, False, left))
    return SeparationSearch(Separation.OPEN)


def touches(at: FrameState, ring: ExactRing, place: SectorShape, radius: arb) -> bool:
    """Whether a ball of some radius overlaps a sector at a moment, for certain."""
    if _radially_in(at, ring, radius) and _in_wedge(at, ring, place):
        return True
    if place.whole:
        return False
    square = radius * radius
    for end in place.ends:
        seen = beside(at, end, ring)
        if ring.inner < seen.x and seen.x < ring.outer and abs(seen.y) < radius:
            return True
        if any([(seen.x - rho) * (seen.x - rho) + seen.y * seen.y < square for rho in (ring.inner, ring.outer)]):
            return True
    return False


def misses(at: FrameState, ring: ExactRing, place: SectorShape, radius: arb) -> bool:
    """Whether a ball of some radius is apart from a sector at a moment, for certain."""
    still = arb(0)
    piece = _TimePiece(at, at, False, False, (_FACE,) if place.whole else (_FACE, 1, 2, 3, 4, 5, 6))
    body = _Body(ExactBall(still, still, still, still, radius, still, still), ring, place, radius, still)
    return not _regions_left(body, piece)


def _radially_in(at: FrameState, ring: ExactRing, radius: arb) -> bool:
    """Whether the ball reaches into the ring's annulus, for certain."""
    hole, edge = ring.inner - radius, ring.outer + radius
    return bool(at.square < edge * edge and (hole < 0 or at.square > hole * hole))


def _in_wedge(at: FrameState, ring: ExactRing, place: SectorShape) -> bool:
    """Whether the centre's bearing lies within the sector's, for certain."""
    if place.whole:
        return True
    ahead, behind = beside(at, place.ends[0], ring).y < 0, beside(at, place.ends[1], ring).y > 0
    return bool(ahead or behind) if place.wide else bool(ahead and behind)


def _regions_left(body: _Body, piece: _TimePiece) -> tuple[int, ...]:
    """The regions that the ball may enter during a piece."""
    width = piece.stop.time - piece.start.time
    if any([_holds(curve, width, piece) for curve in _band(body, piece)]):
        return ()
    if body.sector.whole:
        return piece.regions
    views = [
        _BesideEnd(body, piece, end, beside(piece.start, end, body.ring), beside(piece.stop, end, body.ring))
        for end in body.sector.ends
    ]
    return tuple([region for region in piece.regions if not _kept_out(views, region, width, piece)])


def _kept_out(views: "list[_BesideEnd]", region: int, width: arb, piece: _TimePiece) -> bool:
    """Whether the ball stays out of one region during a piece."""
    if region == _FACE:
        beyond = [_holds(view.beyond(), width, piece) for view in views]
        return all(beyond) if views[0].body.sector.wide else any(beyond)
    end, part = divmod(region - 1, 3)
    view = views[end]
    curves = view.out_of_strip() if part == 0 else view.out_of_disc(view.corners[part - 1])
    return any([_holds(curve, width, piece) for curve in curves])


def _holds(curve: FunctionOnInterval, width: arb, piece: _TimePiece) -> bool:
    """Whether a condition holds throughout a piece."""
    return kept_apart(curve, width, first=piece.first, last=piece.last)


def _band(body: _Body, piece: _TimePiece) -> Iterator[FunctionOnInterval]:
    """Conditions that keep the ball out of every region: beyond the outer face, or within the hole."""
    a, b = piece.start, piece.stop
    rate_a, rate_b = 2 * a.outward, 2 * b.outward
    bend = 2 * (body.ball.vx * body.ball.vx + body.ball.vy * body.ball.vy)
    edge = body.ring.outer + body.radius
    less = edge - body.tolerance
    yield FunctionOnInterval(a.square - edge * edge, rate_a, b.square - edge * edge, rate_b, bend, edge * edge - less * less)
    hole = body.ring.inner - body.radius
    if hole > 0:
        more = hole + body.tolerance
        ease = more * more - hole * hole
        yield FunctionOnInterval(hole * hole - a.square, -rate_a, hole * hole - b.square, -rate_b, -bend, ease)


class _BesideEnd:
    """A ball beside one end during a piece: the conditions that keep it out of the end's regions."""

    def __init__(self, body: _Body, piece: _TimePiece, end: EndVector, start: Beside, stop: Beside) -> None:
        """Take both ends of the piece, and bound the second derivatives in between."""
        self.body, self.end, self.corners = body, end, (body.ring.inner, body.ring.outer)
        self.a, self.b = start, stop
        self.ddx = self.ddy = arb(0)
        ring = body.ring
        if ring.turns:
            spin, square = ring.spin, ring.spin * ring.spin
            farthest = arb.max(piece.start.square, piece.stop.square).sqrt()  # |P|^2 is convex in time
            width = piece.stop.time - piece.start.time
            drift = (square * width * (3 * body.ball.speed + abs(spin) * farthest)).upper()
            slack = arb(0, drift)
            self.ddx = 2 * spin * start.vy - square * start.x + slack
            self.ddy = -2 * spin * start.vx - square * start.y + slack

    def beyond(self) -> FunctionOnInterval:
        """Beyond the end's line, on the side away from its sector."""
        a, b = self.a, self.b
        if self.end.sign > 0:
            return FunctionOnInterval(a.y, a.dy, b.y, b.dy, self.ddy, None)
        return FunctionOnInterval(-a.y, -a.dy, -b.y, -b.dy, -self.ddy, None)

    def out_of_strip(self) -> Iterator[FunctionOnInterval]:
        """Above the strip, below it, inward of it, outward of it."""
        a, b, r = self.a, self.b, self.body.radius
        ring, tolerance = self.body.ring, self.body.tolerance
        yield FunctionOnInterval(a.y - r, a.dy, b.y - r, b.dy, self.ddy, tolerance)
        yield FunctionOnInterval(-a.y - r, -a.dy, -b.y - r, -b.dy, -self.ddy, tolerance)
        yield FunctionOnInterval(ring.inner - a.x, -a.dx, ring.inner - b.x, -b.dx, -self.ddx, None)
        yield FunctionOnInterval(a.x - ring.outer, a.dx, b.x - ring.outer, b.dx, self.ddx, None)

    def out_of_disc(self, rho: arb) -> Iterator[FunctionOnInterval]:
        """Out of the disc around a corner: the square of the distance, |P|^2 - 2 rho X + rho^2, above r^2."""
        a, b, r = self.a, self.b, self.body.radius
        less = r - self.body.tolerance
        square = r * r
        values = [(seen.x - rho) * (seen.x - rho) + seen.y * seen.y - square for seen in (a, b)]
        rates = [2 * ((seen.x - rho) * seen.dx + seen.y * seen.dy) for seen in (a, b)]
        bend = 2 * (self.body.ball.vx * self.body.ball.vx + self.body.ball.vy * self.body.ball.vy) - 2 * rho * self.ddx
        yield FunctionOnInterval(values[0], rates[0], values[1], rates[1], bend, square - less * less)
