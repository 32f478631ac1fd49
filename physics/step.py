"""One tick of the whole arena: the order of its stages, and nothing else."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.bounce import bounce, bounce_off_two
from physics.broad_phase import in_band
from physics.escape import all_freed
from physics.free_flight import FreeFlight, free_flight, still_known
from physics.shapes import Arena, Ball, Contact, Feature, Ring, unchecked
from physics.time_of_impact import Impact, first_impact, touched_now
from physics.tolerances import MAX_IMPACTS, OVERLAP
from physics.vectors import length

LOOK_AHEAD = 256
"""Ticks: how far ahead the free flight is computed."""


class Hit(NamedTuple):
    """One bounce off one sector.

    Two hits of one ball with the same time, `before` and `after` are one bounce off two sectors at once.

    Attributes:
        time: seconds after the tick's start.
        ball: index of the ball in the arena.
        ring: index of the ring in the arena.
        slot: index of the sector in its ring.
        contact: at that moment.
        before: the ball's velocity before the bounce, world units per second.
        after: its velocity after the bounce.
        layers: left in the slot after the hit; PERMANENT where it cannot break.
    """

    time: float
    ball: int
    ring: int
    slot: int
    contact: Contact
    before: complex
    after: complex
    layers: int


class Step(NamedTuple):
    """What one tick did.

    Attributes:
        arena: after the tick.
        hits: in the order of time, ball, ring, slot.
        dropped: how many balls used up MAX_IMPACTS and rested for what was left of the tick.
        freed: how many balls overlapped material and were put outside it.
        flight: to be handed to the next `advance`; it decides nothing, and spares it work.
    """

    arena: Arena
    hits: tuple[Hit, ...]
    dropped: int
    freed: int
    flight: FreeFlight | None = None


class _Next(NamedTuple):
    """The next impact of one ball: its time since the tick's start, the ball, the ring, and the impact."""

    time: float
    ball: int
    ring: int
    impact: Impact


def advance(arena: Arena, dt: float, speed: float, flight: FreeFlight | None = None) -> Step:
    """The arena dt seconds later, and the hits on the way, in the order of time.

    dt: seconds, finite and >= 0, else ValueError; 0 changes nothing. speed: every ball's fixed speed after a bounce, world
    units per second, > 0. Each ball flies from impact to impact. A hit takes one layer from its slot at once, so that a ball
    that comes later in the same tick meets what is left. Equal times are answered in the order of ball, ring, slot.
    flight: `Step.flight` of the tick before, opaque; None on the first call. Where the arena is still that tick's, but for the
    spin of a turning ring, the search is skipped for as long as the flight lasts; it changes no bit of the result.
    Balls that overlap material are first moved out of it. A ball bounces at most MAX_IMPACTS (32) times in a tick.
    """
    seconds = 0.0
    if flight is not None:
        known, seconds, turning = flight
        if known is not arena:
            flight = still_known(flight, arena)
    if flight is None or not dt <= seconds or dt <= 0.0:
        if not 0.0 <= dt < math.inf:
            raise ValueError(f"dt must be finite and at least 0, not {dt}")
        if dt == 0.0:
            return Step(arena, (), 0, 0, flight)
        free = arena if flight is not None else all_freed(arena)  # in an arena with a known flight nothing overlaps
        near = flight is not None and seconds > 0.0  # the flight ends in this tick
        _, seconds, turning = (free, 0.0, ()) if near else free_flight(free, dt if flight is None else LOOK_AHEAD * dt)
        if seconds < dt or free is not arena:
            return _flown(free, _moved_balls(arena, free), dt, speed)
    # Free flight, in the fewest operations: most ticks of a game are these lines and nothing else.
    balls, rings, layers = arena
    moved: tuple[Ball, ...] = ()
    for p, v, ball_radius in balls:
        moved += (unchecked(Ball, (p + v * dt, v, ball_radius)),)
    turned = [*rings]
    for k in turning:
        turned[k] = rings[k].turned(dt)
    arena = unchecked(Arena, (moved, tuple(turned), layers))
    return unchecked(Step, (arena, (), 0, 0, (arena, seconds - dt, turning)))


def _flown(arena: Arena, freed: int, dt: float, speed: float) -> Step:
    """The tick of an arena whose balls overlap nothing: every impact answered in the order of time.

    freed: how many balls had to be moved for that.
    """
    balls, layers = list(arena.balls), list(arena.layers)
    hits, dropped = answer_impacts(balls, arena.rings, layers, dt, speed)
    turned = tuple([ring.turned(dt) if ring.spin != 0.0 else ring for ring in arena.rings])
    end = Arena(tuple(balls), turned, tuple(layers))
    if dropped > 0:
        stuck, end = end, all_freed(end)
        freed += _moved_balls(stuck, end)
    return Step(end, tuple(hits), dropped, freed, (end, 0.0, ()))


def answer_impacts(
    balls: list[Ball], rings: Sequence[Ring], layers: list[tuple[int, ...]], dt: float, speed: float
) -> tuple[list[Hit], int]:
    """Fly the balls to the tick's end, in place: the hits on the way, and how many balls were dropped.

    layers: changed in place too, with every hit. The rings are given at the tick's start, and are not turned.
    """
    clocks, impacts = [0.0] * len(balls), [0] * len(balls)
    hits: list[Hit] = []
    pending: list[_Next] = []
    stale = list(range(len(balls)))  # whose next impact is not known
    while True:
        for j in stale:
            following = _next_impact(j, balls[j], clocks[j], rings, layers, dt)
            if following is not None:
                pending.append(following)
        if len(pending) == 0:
            break
        found = _earliest(pending)
        i = found.ball
        there = balls[i].moved(found.time - clocks[i])
        answered = _hits(found, there, rings, layers, speed)
        balls[i], clocks[i] = unchecked(Ball, (there.position, answered[0].after, there.radius)), found.time
        impacts[i] += 1
        for hit in answered:
            hits.append(hit)
            set_layers(layers, hit.ring, hit.slot, hit.layers)
        stale = [j for j in _withdrawn(pending, i, layers) if impacts[j] < MAX_IMPACTS]
    dropped = 0
    for i in range(len(balls)):
        if impacts[i] < MAX_IMPACTS:
            balls[i] = balls[i].moved(dt - clocks[i])
        else:
            dropped += 1
    return hits, dropped


def _next_impact(
    index: int, ball: Ball, clock: float, rings: Sequence[Ring], layers: Sequence[tuple[int, ...]], dt: float
) -> _Next | None:
    """The first impact of a ball, given where it is at `clock`, before the tick ends."""
    rest = dt - clock
    distance, reach = length(ball.position), length(ball.velocity) * rest + ball.radius
    first: _Next | None = None
    for k, ring in enumerate(rings):
        if not in_band(distance, reach, ring):
            continue
        now = ring.turned(clock) if clock > 0.0 and ring.spin != 0.0 else ring
        impact = first_impact(ball, now, rest, layers[k])
        if impact is not None and (first is None or clock + impact.time < first.time):
            first = _Next(clock + impact.time, index, k, impact)
    return first


def _hits(found: _Next, ball: Ball, rings: Sequence[Ring], layers: Sequence[tuple[int, ...]], speed: float) -> list[Hit]:
    """The hit of an impact, or the two hits of a bounce off two sectors at once. ball: at that moment."""
    contact, slot, ring = found.impact.contact, found.impact.slot, rings[found.ring]
    for k, other in _touched_besides(found, ball, rings, layers):
        after = bounce_off_two(ball, contact, ring, other.contact, rings[k], speed)
        if after is not None:
            after = complex(after.real, after.imag)  # for the compiler, which takes it for one that may be None still
            first = _hit(found, ball, found.ring, slot, contact, after, layers)
            return _in_order(first, _hit(found, ball, k, other.slot, other.contact, after, layers))
    return [_hit(found, ball, found.ring, slot, contact, bounce(ball, contact, ring, speed), layers)]


def _touched_besides(
    found: _Next, ball: Ball, rings: Sequence[Ring], layers: Sequence[tuple[int, ...]]
) -> list[tuple[int, Impact]]:
    """What else the ball touches and approaches at the moment of an impact: ring and impact, in the order of the rings.

    A ball above a sector is nearer to it than to any other of its ring.
    """
    feature = found.impact.contact.feature
    above = feature == Feature.OUTER_FACE or feature == Feature.INNER_FACE  # noqa: PLR1714  # what compiles
    distance = length(ball.position)
    touched: list[tuple[int, Impact]] = []
    for k, ring in enumerate(rings):
        if not (above and k == found.ring) and in_band(distance, ball.radius * (1.0 + OVERLAP), ring):
            for impact in touched_now(ball, ring.turned(found.time), layers[k]):
                if impact is not None:
                    touched.append((k, impact))  # noqa: PERF401  # what compiles
    return touched


def _hit(
    found: _Next, ball: Ball, k: int, slot: int, contact: Contact, after: complex, layers: Sequence[tuple[int, ...]]
) -> Hit:
    """The record of one bounce off one sector."""
    left = layers[k][slot] - 1 if layers[k][slot] > 0 else layers[k][slot]
    return Hit(found.time, found.ball, k, slot, contact, ball.velocity, after, left)


def _in_order(first: Hit, second: Hit) -> list[Hit]:
    """Two hits at one moment in the order of ring and slot; one where both are ends of the same sector."""
    if (first.ring, first.slot) == (second.ring, second.slot):
        return [first]
    return [first, second] if (first.ring, first.slot) < (second.ring, second.slot) else [second, first]


def _earliest(pending: Sequence[_Next]) -> _Next:
    """The impact that is answered first: of equally early ones that of the lowest ball."""
    found = pending[0]
    for other in pending:
        if (other.time, other.ball) < (found.time, found.ball):
            found = other
    return found


def _withdrawn(pending: list[_Next], ball: int, layers: Sequence[tuple[int, ...]]) -> list[int]:
    """The balls whose pending impact is none any more after a hit of `ball`; their impacts are taken out."""
    balls = []
    for n in range(len(pending) - 1, -1, -1):
        if pending[n].ball == ball or not _is_there(pending[n], layers):
            balls.append(pending.pop(n).ball)  # noqa: PERF401  # two things are done
    return balls


def _is_there(found: _Next, layers: Sequence[tuple[int, ...]]) -> bool:
    """Whether the sector of an impact has not been broken meanwhile."""
    return layers[found.ring][found.impact.slot] != 0


def set_layers(layers: list[tuple[int, ...]], ring: int, slot: int, left: int) -> None:
    """Write what is left in one slot."""
    before = layers[ring]
    layers[ring] = (*before[:slot], left, *before[slot + 1 :])


def _moved_balls(before: Arena, after: Arena) -> int:
    """How many balls of an arena are not the same value after."""
    return sum([new is not old for new, old in zip(after.balls, before.balls, strict=True)])
