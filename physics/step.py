"""One tick of the whole arena."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.clearance import clear_time, may_be_steered
from physics.escape import freed
from physics.response import collision_response, leaving_at
from physics.shapes import Ball, Contact, Feature, Ring
from physics.time_of_impact import Impact, time_of_impact
from physics.tolerances import LEAST_GRAZE, LEAST_SEPARATION, MAX_IMPACTS
from physics.vectors import dot, length

PERMANENT = -1
"""Layers of a sector that no hit removes."""

_LOOK_AHEAD = 256
"""Ticks for which it is asked how long nothing is touched."""
_new = tuple.__new__  # a NamedTuple without its Python constructor


class Arena(NamedTuple):
    """Everything that moves or can be hit."""

    balls: tuple[Ball, ...]
    rings: tuple[Ring, ...]
    layers: tuple[tuple[int, ...], ...]  # per ring and slot: bricks stacked there, 0 empty, PERMANENT unbreakable


class Hit(NamedTuple):
    """One bounce."""

    time: float  # seconds after the tick's start
    ball: int
    ring: int
    slot: int
    contact: Contact
    before: complex  # the ball's velocity
    after: complex
    layers: int  # left in the slot after the hit; PERMANENT where it cannot break


class Step(NamedTuple):
    """What one tick did."""

    arena: Arena
    hits: tuple[Hit, ...]  # in the order of time, ball, ring, slot
    dropped: int  # balls that used up MAX_IMPACTS and rested for what was left of the tick
    freed: int  # balls that overlapped material and were put outside it
    clear: float = 0.0  # seconds after it for which no ball touches anything, however a turning ring is steered; 0: unknown
    turning: tuple[int, ...] = ()  # rings that turn, where clear is known


class _Next(NamedTuple):
    """The next impact of one ball."""

    time: float
    ball: int
    ring: int
    impact: Impact


def advance(arena: Arena, dt: float, speed: float, last: Step | None = None) -> Step:
    """The arena dt seconds later, and the hits on the way, in the order of time.

    dt: seconds, finite and >= 0, else ValueError; 0 changes nothing. speed: every ball's fixed speed after a bounce.
    Each ball flies from impact to impact. A hit takes one layer from its slot at once, so that a ball that comes
    later in the same tick meets what is left. Equal times are answered in the order of ball, ring, slot.
    last: what this function said of the tick before. Where the arena is still that tick's, but for the spin of a turning
    ring, a ball in free flight is not looked after anew; it changes no bit of the result.
    """
    if last is not None and arena is not last[0] and not _goes_on(last[0], arena):
        last = None
    if last is not None and 0.0 < dt <= last[4]:
        balls, rings, layers = arena
        moved: tuple[Ball, ...] = ()
        for p, v, ball_radius in balls:
            moved += (_new(Ball, (p + v * dt, v, ball_radius)),)
        turned = [*rings]
        for k in last[5]:
            turned[k] = rings[k].turned(dt)
        return _new(Step, (_new(Arena, (moved, tuple(turned), layers)), (), 0, 0, last[4] - dt, last[5]))
    if not 0.0 <= dt < math.inf:
        raise ValueError(f"dt must be finite and at least 0, not {dt}")
    if dt == 0.0:
        return Step(arena, (), 0, 0)
    running_out = last is not None and last.clear > 0.0
    clear = 0.0 if running_out else _clear(arena, dt if last is None else _LOOK_AHEAD * dt)
    if clear < dt:
        return _flown(_all_freed(arena) if last is None else Step(arena, (), 0, 0), dt, speed)
    turning = tuple([k for k, ring in enumerate(arena.rings) if ring.spin])
    return advance(arena, dt, speed, Step(arena, (), 0, 0, clear, turning))


def _goes_on(before: Arena, now: Arena) -> bool:
    """Whether an arena is the very one before, but for what a player steers."""
    balls, rings, layers = now
    if balls is not before.balls or layers is not before.layers:
        return False
    return all([new is old or may_be_steered(old, new, balls) for old, new in zip(before.rings, rings, strict=True)])


def _clear(arena: Arena, horizon: float) -> float:
    """Seconds, at most `horizon`, for which no ball touches anything."""
    for ball in arena.balls:
        horizon = clear_time(ball, arena.rings, arena.layers, horizon)
    return horizon


def _all_freed(arena: Arena) -> Step:
    """The arena, each ball moved out of the material it overlaps, and how many had to be."""
    balls = tuple([freed(ball, arena.rings, arena.layers) for ball in arena.balls])
    count = sum([new is not old for new, old in zip(balls, arena.balls, strict=True)])
    return Step(arena._replace(balls=balls) if count else arena, (), 0, count)


def _next_impact(
    index: int, ball: Ball, clock: float, rings: tuple[Ring, ...], layers: Sequence[tuple[int, ...]], dt: float
) -> _Next | None:
    """The first impact of a ball, given where it is at `clock`, before the tick ends."""
    rest = dt - clock
    p, v, ball_radius = ball
    distance = length(p)
    reach = length(v) * rest + ball_radius
    first: _Next | None = None
    for k, ring in enumerate(rings):
        radius, half_width = ring[0], ring[1]
        if abs(distance - radius) > half_width + reach:
            continue
        now = ring.turned(clock) if clock > 0.0 and ring.spin != 0.0 else ring
        impact = time_of_impact(ball, now, rest, layers[k])
        if impact is not None and (first is None or clock + impact.time < first.time):
            first = _Next(clock + impact.time, index, k, impact)
    return first


def _flown(start: Step, dt: float, speed: float) -> Step:
    """The tick after `start`, whose balls overlap nothing: every impact answered in the order of time."""
    arena = start.arena
    balls, rings, layers = list(arena.balls), arena.rings, list(arena.layers)
    clocks, impacts = [0.0] * len(balls), [0] * len(balls)
    hits: list[Hit] = []
    upcoming = [_next_impact(i, ball, 0.0, rings, layers, dt) for i, ball in enumerate(balls)]
    while pending := [found for found in upcoming if found is not None]:
        time, i, k, impact = min(pending, key=_time_and_ball)
        ball = balls[i].moved(time - clocks[i])
        hit = _hit(time, i, k, impact, ball, rings[k], layers[k], speed)
        hits.append(hit)
        balls[i], clocks[i] = _new(Ball, (ball.position, hit.after, ball.radius)), time
        impacts[i] += 1
        slot = hit.slot
        layers[k] = (*layers[k][:slot], hit.layers, *layers[k][slot + 1 :])
        for j, found in enumerate(upcoming):
            target_gone = found is not None and found.ring == k and found.impact.slot == slot and hit.layers == 0
            if j == i or target_gone:
                free = impacts[j] < MAX_IMPACTS
                upcoming[j] = _next_impact(j, balls[j], clocks[j], rings, layers, dt) if free else None
    dropped = [count >= MAX_IMPACTS for count in impacts]
    moved = [ball if out else ball.moved(dt - clock) for ball, clock, out in zip(balls, clocks, dropped, strict=True)]
    turned = tuple([ring.turned(dt) if ring.spin else ring for ring in rings])
    end = Step(Arena(tuple(moved), turned, tuple(layers)), tuple(hits), sum(dropped), start.freed)
    if not any(dropped):
        return end
    after = _all_freed(end.arena)
    return end._replace(arena=after.arena, freed=start.freed + after.freed)


def _hit(time: float, index: int, k: int, impact: Impact, ball: Ball, ring: Ring, layers: tuple[int, ...], speed: float) -> Hit:
    """The bounce that an impact makes of the ball at the moment of touch."""
    contact, slot = impact.contact, impact.slot
    after = _bounce(ball.velocity, contact, ring, speed)
    return Hit(time, index, k, slot, contact, ball.velocity, after, _one_less(layers[slot]))


def _time_and_ball(found: _Next) -> tuple[float, int]:
    """The order in which impacts are answered."""
    return found.time, found.ball


def _one_less(layers: int) -> int:
    """Layers left in a slot after a hit."""
    return layers - 1 if layers > 0 else layers


def _bounce(v: complex, contact: Contact, ring: Ring, speed: float) -> complex:
    """Velocity after a contact: the response, and never so slowly off the surface that the two meet again at once."""
    normal, surface_velocity = contact.normal, ring.surface_velocity(contact.point)
    after = collision_response(v, normal, surface_velocity, ring.friction, speed)
    follows = contact.feature == Feature.INNER_FACE or (ring.spin != 0.0 and contact.feature != Feature.OUTER_FACE)
    least = dot(surface_velocity, normal) + (LEAST_SEPARATION if follows else LEAST_GRAZE) * speed
    return leaving_at(after, normal, least, speed) if dot(after, normal) < least else after
