"""One tick of the whole arena: the order of its stages, and nothing else."""

import math
from collections.abc import Sequence
from typing import NamedTuple, Protocol

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


class Hits(Protocol):
    """Where hits are recorded: a list, or the batch's rows."""

    def append(self, hit: Hit, /) -> None:
        """Record a hit."""


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
    """The next impact of a ball in a tick: seconds after its start, infinite for none; the ring, and the impact."""

    time: float
    ring: int
    impact: Impact


_NO_IMPACT = _Next(math.inf, -1, Impact(math.inf, -1, Contact(0j, 0j, math.inf, Feature.END)))


class Course(NamedTuple):
    """Of one ball, within a tick.

    Attributes:
        clock: seconds after the tick's start at which it is where it is now.
        impacts: how many it has had.
        next: the one that follows.
    """

    clock: float
    impacts: int
    next: _Next


AT_START = Course(0.0, 0, _NO_IMPACT)
"""For a list of courses: one for each ball."""


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
    if turning:
        turned = [*rings]
        for k in turning:
            turned[k] = rings[k].turned(dt)
        rings = tuple(turned)
    arena = unchecked(Arena, (moved, rings, layers))
    return unchecked(Step, (arena, (), 0, 0, (arena, seconds - dt, turning)))


def _flown(arena: Arena, freed: int, dt: float, speed: float) -> Step:
    """The tick of an arena whose balls overlap nothing: every impact answered in the order of time.

    freed: how many balls had to be moved for that.
    """
    balls, layers = list(arena.balls), list(arena.layers)
    hits: list[Hit] = []
    dropped = answer_impacts(balls, arena.rings, layers, dt, speed, [AT_START] * len(balls), hits)
    turned = tuple([ring.turned(dt) if ring.spin != 0.0 else ring for ring in arena.rings])
    end = Arena(tuple(balls), turned, tuple(layers))
    if dropped > 0:
        stuck, end = end, all_freed(end)
        freed += _moved_balls(stuck, end)
    return Step(end, tuple(hits), dropped, freed, (end, 0.0, ()))


def answer_impacts(
    balls: list[Ball],
    rings: Sequence[Ring],
    layers: list[tuple[int, ...]],
    dt: float,
    speed: float,
    courses: list[Course],
    hits: Hits,
) -> int:
    """Fly the balls to the tick's end, in place; how many were dropped.

    layers: changed in place too, with every hit. The rings are given at the tick's start, and are not turned. courses: one for
    each ball, written. hits: those on the way are added.
    """
    for i in range(len(balls)):
        courses[i] = Course(0.0, 0, _next_impact(balls[i], 0.0, rings, layers, dt))
    i = _earliest(courses)
    while i >= 0:
        found = courses[i].next
        there = balls[i].moved(found.time - courses[i].clock)
        impacts = courses[i].impacts + 1
        balls[i] = unchecked(Ball, (there.position, _answer(i, found, there, rings, layers, speed, hits), there.radius))
        courses[i] = Course(found.time, impacts, _NO_IMPACT)
        for j in range(len(balls)):
            course = courses[j]
            withdrawn = course.next.ring >= 0 and layers[course.next.ring][course.next.impact.slot] == 0
            if withdrawn or (j == i and impacts < MAX_IMPACTS):
                courses[j] = Course(course.clock, course.impacts, _next_impact(balls[j], course.clock, rings, layers, dt))
        i = _earliest(courses)
    dropped = 0
    for i in range(len(balls)):
        if courses[i].impacts < MAX_IMPACTS:
            balls[i] = balls[i].moved(dt - courses[i].clock)
        else:
            dropped += 1
    return dropped


def _next_impact(ball: Ball, clock: float, rings: Sequence[Ring], layers: Sequence[tuple[int, ...]], dt: float) -> _Next:
    """The first impact of a ball, given where it is at `clock`, before the tick ends."""
    rest = dt - clock
    distance, reach = length(ball.position), length(ball.velocity) * rest + ball.radius
    first = _NO_IMPACT
    for k in range(len(rings)):
        ring = rings[k]
        if not in_band(distance, reach, ring):
            continue
        now = ring.turned(clock) if clock > 0.0 and ring.spin != 0.0 else ring
        impact = first_impact(ball, now, rest, layers[k])
        if impact is not None and clock + impact.time < first.time:
            # Made anew for the compiler, which takes it for one that may be None still.
            first = _Next(clock + impact.time, k, Impact(impact.time, impact.slot, impact.contact))
    return first


def _earliest(courses: Sequence[Course]) -> int:
    """The ball whose next impact is answered first: of equally early ones the lowest; -1 where none has any."""
    found, time = -1, math.inf
    for i in range(len(courses)):
        if courses[i].next.time < time:
            found, time = i, courses[i].next.time
    return found


def _answer(
    i: int, found: _Next, ball: Ball, rings: Sequence[Ring], layers: list[tuple[int, ...]], speed: float, hits: Hits
) -> complex:
    """The velocity of ball number i after an impact: of its hit, or of the two hits of a bounce off two sectors at once.

    ball: at that moment. The hits are added, and take their layers. A ball above a sector is nearer to it than to any other
    of its ring: nothing else of that ring is asked for.
    """
    contact, slot, ring = found.impact.contact, found.impact.slot, rings[found.ring]
    above = contact.feature == Feature.OUTER_FACE or contact.feature == Feature.INNER_FACE  # noqa: PLR1714  # what compiles
    distance = length(ball.position)
    for k in range(len(rings)):
        if not (above and k == found.ring) and in_band(distance, ball.radius * (1.0 + OVERLAP), rings[k]):
            for other in touched_now(ball, rings[k].turned(found.time), layers[k]):
                if other is not None:
                    after = bounce_off_two(ball, contact, ring, other.contact, rings[k], speed)
                    if after is not None:
                        both = complex(
                            after.real, after.imag
                        )  # for the compiler, which takes it for one that may be None still
                        first = _hit(found.time, i, ball, found.ring, slot, contact, both, layers)
                        second = _hit(found.time, i, ball, k, other.slot, other.contact, both, layers)
                        _add_both(first, second, layers, hits)
                        return both
    velocity = bounce(ball, contact, ring, speed)
    _add(_hit(found.time, i, ball, found.ring, slot, contact, velocity, layers), layers, hits)
    return velocity


def _hit(
    time: float, i: int, ball: Ball, k: int, slot: int, contact: Contact, after: complex, layers: Sequence[tuple[int, ...]]
) -> Hit:
    """The record of one bounce off one sector."""
    left = layers[k][slot] - 1 if layers[k][slot] > 0 else layers[k][slot]
    return Hit(time, i, k, slot, contact, ball.velocity, after, left)


def _add_both(first: Hit, second: Hit, layers: list[tuple[int, ...]], hits: Hits) -> None:
    """Add two hits at one moment in the order of ring and slot; one where both are ends of the same sector."""
    if (first.ring, first.slot) == (second.ring, second.slot):
        _add(first, layers, hits)
    elif (first.ring, first.slot) < (second.ring, second.slot):
        _add(first, layers, hits)
        _add(second, layers, hits)
    else:
        _add(second, layers, hits)
        _add(first, layers, hits)


def _add(hit: Hit, layers: list[tuple[int, ...]], hits: Hits) -> None:
    """Record a hit, which takes its layer."""
    add_hit(hits, hit)
    set_layers(layers, hit.ring, hit.slot, hit.layers)


def add_hit(hits: Hits, hit: Hit) -> None:
    """Record a hit."""
    hits.append(hit)


def set_layers(layers: list[tuple[int, ...]], ring: int, slot: int, left: int) -> None:
    """Write what is left in one slot."""
    before = layers[ring]
    layers[ring] = (*before[:slot], left, *before[slot + 1 :])


def _moved_balls(before: Arena, after: Arena) -> int:
    """How many balls of an arena are not the same value after."""
    return sum([new is not old for new, old in zip(after.balls, before.balls, strict=True)])
