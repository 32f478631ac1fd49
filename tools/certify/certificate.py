"""What is proved of one flight, or why it is not.

Of an impact that the physics reports at time t with normal n, with the tolerances below:

1.  There is a t* with |t* - t| <= tau at which the gap to the reported sector falls through 0.
2.  On [start, t - tau] the gap to every living sector is above 0. So the first touch of the flight is within tau of t.
3.  The exact normal at t* is enclosed in a disc of radius 1e-30, and n is within `bound` of it. The reported point is within
    2 (E + (|v| + |w| R) |t* - t|) of the exact one.

Of a flight that no impact ends: the gap to every living sector is above 0 from its start to the tick's end.

In both, one thing is allowed: a touch that the flight starts from, or that the tick ends in, may be an overlap of at most
delta, if the function that keeps the two apart only rises from there to above 0, or only falls to there from above 0.
A bounce leaves a ball so; and a touch in the last 1e-16 s of a tick is the next tick's.

Of a tick: where it ends is where the next one starts, ball by ball and ring by ring, but for rounding.

    delta = 1e-13 + E       the gap at which the physics ends a search, and what rounding may add
    E = 32 u L              u = 2^-53; L is the sum of the start's distance, the flight's length, the ring's outer radius and
                            the ball's radius
    tau = 2 delta / c       c is the proved closing rate at t*: a gap within delta is a time within delta / c
    bound = 1e-14 + k (E + (|v| + |w| R) |t* - t|) + |w| |t* - t|
                            k is 1 / r at a corner, 1 / |P| at a face, 0 at an end: a position that is off by e turns the
                            normal by k e

These numbers say what is asked of the physics. Whether an answer meets them is decided by enclosures alone.
"""

import math
from collections.abc import Iterator, Sequence
from enum import Enum
from typing import NamedTuple

from flint import arb

from physics import Hit, Ring
from tools.certify.exact_geometry import ExactBall, ExactRing, exact_ball, exact_ring, moment, sector
from tools.certify.exclusion import ring_is_far, sectors_near
from tools.certify.flights import ClaimedTick, StraightFlight, flights_of, starts
from tools.certify.no_touch import Separation, TimeWindow, apart, misses, touches
from tools.certify.touch import ProvedTouch, touch

SEARCH_ENDS = 1e-13
"""World units: a gap at which the physics, by its own word, may end the search for an impact."""

ROUNDINGS = 32
"""Units of 2^-53 of the lengths that enter, allowed for rounding."""

NORMAL = 1e-14
"""What a normal may be off by, apart from what the position is off by."""

NORMAL_WIDTH = 1e-30
"""What the enclosure of the exact normal must be narrower than."""

LOOSEST = 1e-7
"""Seconds. A larger tau means a graze: where the ball nearly slides past, a time of touch is not determined."""

_UNIT = 2.0**-53


class Decision(Enum):
    """What became of a claim."""

    CERTIFIED = "certified"
    REFUTED = "refuted"
    UNDECIDED = "undecided"


class Reason(Enum):
    """Why a claim is refuted or undecided."""

    NONE = ""
    NO_SECTOR = "there is no sector in the reported slot"
    NO_TOUCH = "the ball does not touch the reported sector at the reported time"
    OVERLAP = "the ball overlaps the reported sector at the reported time"
    LEAVING = "the ball leaves the reported sector at the reported time"
    EARLIER = "the ball overlaps a sector before"
    NORMAL = "the normal is another"
    PATH = "the flights do not lead to where the ball is said to be"
    GRAZE = "graze: the time of touch, or the feature touched, is not determined"
    EARLIER_GRAZE = "graze: a sector is touched before, no deeper than the tolerance"
    SQUEEZED = "squeezed: the flight starts in an overlap"
    POINT = "the point of contact is another"
    WIDE = "the enclosure of the exact normal is too wide"
    SEARCH = "no proof within the pieces allowed"


class Certificate(NamedTuple):
    """The verdict on one flight.

    tick, ball: which flight. hit: the claim, None for a flight without an impact. rest: what is measured of a certified impact,
    as floats rounded up: time_bound tau in s, time_off |t* - t| in s, normal_bound, normal_off. short: the flight is not longer
    than tau, so that point 2 says nothing of it.
    """

    verdict: Decision
    reason: Reason
    tick: int
    ball: int
    hit: Hit | None
    time_bound: float = 0.0
    time_off: float = 0.0
    normal_bound: float = 0.0
    normal_off: float = 0.0
    short: bool = False


class _Scales(NamedTuple):
    """The tolerances of one flight beside one ring. rounding: E. tolerance: delta."""

    rounding: float
    tolerance: float


class _Ruling(NamedTuple):
    """A verdict; of a proved touch with late, |t* - t|, and bound, tau, in seconds."""

    verdict: Decision
    reason: Reason
    touch: ProvedTouch | None = None
    late: float = 0.0
    bound: float = 0.0


def certificates(tick: ClaimedTick) -> Iterator[Certificate]:
    """A certificate for every flight of a tick."""
    rings = [exact_ring(ring) for ring in tick.arena.rings]
    squeezed: set[int] = set()
    if tick.step.freed:
        squeezed = {index for index in range(len(tick.arena.balls)) if _starts_inside(_start_of(tick, index), tick, rings)}
    for flight in flights_of(tick):
        if flight.ball in squeezed:
            yield Certificate(Decision.UNDECIDED, Reason.SQUEEZED, tick.number, flight.ball, flight.hit)
        else:
            yield _certificate(flight, tick, rings)


def _start_of(tick: ClaimedTick, index: int) -> StraightFlight:
    """A flight of a ball as long as the tick."""
    p, v, radius = starts(tick)[index]
    return StraightFlight(index, p, v, radius, 0.0, tick.dt, None, tick.arena.layers, {})


def _starts_inside(flight: StraightFlight, tick: ClaimedTick, rings: Sequence[ExactRing]) -> bool:
    """Whether a flight certainly starts in an overlap deeper than the tolerance."""
    ball = exact_ball(flight)
    for number, ring, slot in _sectors_in_reach(flight, tick.arena.rings):
        less = ball.radius - arb(_scales(flight, ring).tolerance)
        if touches(moment(ball, rings[number], ball.start), rings[number], sector(ring.count, ring.half_angle, slot), less):
            return True
    return False


def _certificate(flight: StraightFlight, tick: ClaimedTick, rings: Sequence[ExactRing]) -> Certificate:
    """The certificate of one flight."""
    ball, hit = exact_ball(flight), flight.hit

    def verdict(proof: _Ruling) -> Certificate:
        return Certificate(proof.verdict, proof.reason, tick.number, flight.ball, hit)

    if hit is not None and hit.before != flight.velocity:
        return verdict(_Ruling(Decision.REFUTED, Reason.PATH))
    if hit is None:
        if not _goes_on(flight, tick):
            return verdict(_Ruling(Decision.REFUTED, Reason.PATH))
        return verdict(_nothing_touched(flight, ball, tick, rings, arb(flight.stop)))
    ring = tick.arena.rings[hit.ring]
    proof = _touched(flight, hit, ball, ring, rings[hit.ring])
    if proof.touch is None:
        deeper = proof.verdict == Decision.UNDECIDED and _nothing_touched(flight, ball, tick, rings, arb(hit.time))
        return verdict(deeper if deeper and deeper.verdict == Decision.REFUTED else proof)
    before = _nothing_touched(flight, ball, tick, rings, arb(hit.time) - arb(proof.bound))
    if before.verdict != Decision.CERTIFIED:
        return verdict(before)
    known, off, bound = _contact(hit, proof, ball, rings[hit.ring], _scales(flight, ring))
    return verdict(known)._replace(
        time_bound=proof.bound,
        time_off=proof.late,
        normal_bound=bound,
        normal_off=off,
        short=flight.stop - flight.start <= proof.bound,
    )


def _goes_on(flight: StraightFlight, tick: ClaimedTick) -> bool:
    """Whether ball and rings are, at the tick's end, where the flight and the spins lead, but for rounding.

    A tick at whose end a squeezed ball was put elsewhere is not asked.
    """
    if tick.step.freed and tick.step.dropped:
        return True
    there = tick.step.arena.balls[flight.ball]
    off = flight.end() - there.position
    allowed = ROUNDINGS * _UNIT * (abs(there.position) + abs(flight.position) + abs(flight.velocity) * tick.dt)
    rings = zip(tick.arena.rings, tick.step.arena.rings, strict=True)
    return abs(off) <= allowed and there.velocity == flight.velocity and all([_turned(old, new, tick.dt) for old, new in rings])


def _turned(old: Ring, new: Ring, dt: float) -> bool:
    """Whether a ring has turned by its spin, but for rounding."""
    if old.spin == 0.0:
        return old == new
    turn = arb(new.phase) - arb(old.phase) - arb(old.spin) * arb(dt)
    whole = 2 * arb.pi() * round(float(turn.mid()) / math.tau)
    return abs(turn - whole) <= ROUNDINGS * _UNIT * (math.tau + abs(old.spin) * dt) and new._replace(phase=old.phase) == old


def _touched(flight: StraightFlight, hit: Hit, ball: ExactBall, ring: Ring, exact: ExactRing) -> _Ruling:
    """Point 1: the reported sector is touched near the reported time."""
    tolerance, time = arb(_scales(flight, ring).tolerance), arb(hit.time)
    wrong = _refutation(flight, hit, ball, ring, exact, tolerance)
    if wrong != Reason.NONE:
        return _Ruling(Decision.REFUTED, wrong)
    found = touch(ball, exact, sector(ring.count, ring.half_angle, hit.slot), time, 2 * tolerance)
    if found is None:
        return _Ruling(Decision.UNDECIDED, Reason.GRAZE)
    if found.closing < 0:
        return _Ruling(Decision.REFUTED, Reason.LEAVING)
    late, bound = _above(abs(found.time - time)), float((2 * tolerance / found.closing).lower())
    if not late <= bound <= LOOSEST:
        return _Ruling(Decision.UNDECIDED, Reason.GRAZE)
    return _Ruling(Decision.CERTIFIED, Reason.NONE, found, late, bound)


def _refutation(flight: StraightFlight, hit: Hit, ball: ExactBall, ring: Ring, exact: ExactRing, tolerance: arb) -> Reason:
    """Why the reported sector is certainly not just touched at the reported time; `NONE` where it may be."""
    if not flight.layers[hit.ring][hit.slot] or (hit.ring, hit.slot) in flight.gone:
        return Reason.NO_SECTOR
    place = sector(ring.count, ring.half_angle, hit.slot)
    at = moment(ball, exact, arb(hit.time))
    if misses(at, exact, place, ball.radius + tolerance):
        return Reason.NO_TOUCH
    return Reason.OVERLAP if touches(at, exact, place, ball.radius - tolerance) else Reason.NONE


def _nothing_touched(
    flight: StraightFlight, ball: ExactBall, tick: ClaimedTick, rings: Sequence[ExactRing], stop: arb
) -> _Ruling:
    """Point 2: no living sector is touched from the flight's start until a time."""
    doubt: _Ruling | None = None
    if not ball.start < stop:
        return _Ruling(Decision.CERTIFIED, Reason.NONE)
    for number, ring, slot in _sectors_in_reach(flight, tick.arena.rings):
        gone = flight.gone.get((number, slot))
        until, last = stop, flight.hit is None
        if gone is not None and arb(gone) < stop:
            until, last = arb(gone), True
        if not ball.start < until:
            continue
        place, tolerance = sector(ring.count, ring.half_angle, slot), arb(_scales(flight, ring).tolerance)
        window = TimeWindow(ball.start, until, first=True, last=last)
        if apart(ball, rings[number], place, window, ball.radius, tolerance).finding == Separation.APART:
            continue
        less = ball.radius - tolerance
        deeper = apart(ball, rings[number], place, window, less, arb(0)).finding
        if deeper == Separation.TOUCHED:
            inside = touches(moment(ball, rings[number], ball.start), rings[number], place, less)
            if not inside:
                return _Ruling(Decision.REFUTED, Reason.EARLIER)
            doubt = _Ruling(Decision.UNDECIDED, Reason.SQUEEZED)
        else:
            doubt = doubt or _Ruling(Decision.UNDECIDED, Reason.EARLIER_GRAZE if deeper == Separation.APART else Reason.SEARCH)
    return doubt or _Ruling(Decision.CERTIFIED, Reason.NONE)


def _contact(hit: Hit, proof: _Ruling, ball: ExactBall, ring: ExactRing, scales: _Scales) -> tuple[_Ruling, float, float]:
    """Point 3: the verdict on the reported normal and point, how far the normal is off, and its bound."""
    found = proof.touch
    assert found is not None
    reported = hit.contact.normal
    square = _square_of_distance(found.nx, found.ny, reported)
    pace, late = abs(ring.spin), arb(proof.late)
    moved = arb(scales.rounding) + (ball.speed + pace * ring.outer) * late
    bound = NORMAL + found.curvature * moved + pace * late
    flown = found.time - ball.start
    px, py = ball.px + ball.vx * flown - ball.radius * found.nx, ball.py + ball.vy * flown - ball.radius * found.ny
    if not 2 * (found.nx.rad() + found.ny.rad()) < NORMAL_WIDTH:
        known = _Ruling(Decision.UNDECIDED, Reason.WIDE)
    elif not square <= bound * bound:
        known = _Ruling(Decision.REFUTED if square > bound * bound else Decision.UNDECIDED, Reason.NORMAL)
    elif _square_of_distance(px, py, hit.contact.point) > 4 * moved * moved:
        known = _Ruling(Decision.REFUTED, Reason.POINT)
    else:
        known = _Ruling(Decision.CERTIFIED, Reason.NONE)
    return known, _above(square.upper().sqrt()), _above(bound)


def _square_of_distance(x: arb, y: arb, point: complex) -> arb:
    """The square of the distance from (x, y) to a point in floats."""
    dx, dy = x - point.real, y - point.imag
    return dx * dx + dy * dy


def _sectors_in_reach(flight: StraightFlight, rings: Sequence[Ring]) -> Iterator[tuple[int, Ring, int]]:
    """(number of the ring, ring, slot) of every sector that the flight can come near and that is there when it starts."""
    reach = abs(flight.velocity) * (flight.stop - flight.start) + flight.radius
    for number, ring in enumerate(rings):
        if not ring_is_far(flight.position, reach, ring):
            for slot in sectors_near(flight.position, reach, ring, flight.start, flight.stop):
                if flight.layers[number][slot]:
                    yield number, ring, slot


def _scales(flight: StraightFlight, ring: Ring) -> _Scales:
    """The tolerances of a flight beside a ring."""
    travel = abs(flight.velocity) * (flight.stop - flight.start)
    lengths = abs(flight.position) + travel + ring.radius + ring.half_width + flight.radius
    rounding = ROUNDINGS * _UNIT * lengths
    return _Scales(rounding, SEARCH_ENDS + rounding)


def _above(x: arb) -> float:
    """A float not below x."""
    return float(x.upper()) * (1.0 + 2.0**-50)
