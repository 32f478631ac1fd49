"""First touch of a moving ball with a turning ring, exact in time.

The ball flies straight, p + v t. It can touch a ring only while its distance from the centre lies between the inner
radius less its own and the outer radius plus its own: the ring's band, crossed at roots of quadratics. Where it enters
the band above a sector, that moment is the touch of a face. Where it enters over a gap, it stays in that gap until it
touches one of the gap's two ends: every other sector is farther at every radius. So one search costs the same with any
number of sectors: at most two windows of time, at most two ends each.

An end and its corners are one convex set, a segment. At rest, its touch has a closed form. Turning, it is found by
steps that cannot overshoot: in the ring's frame the distance to a convex set obeys

    gap(t + s) >= gap + rate s + (K - J h / 3) s^2 / 2    for 0 <= s <= h,

K being the present relative acceleration along the normal and J a bound on its rate of change, |w|^3 |p| + 3 w^2 |v|.
The first root of the right side is a safe step; near a touch it is Newton's and converges cubically. h is at most a
quarter of a radian of turning. A turn of three half circles brings every sector past every straight path,
so about 38 such steps and a few to converge are the most one search can need: MAX_STEPS = 64.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.narrow_phase import end_contact, sector_contact
from physics.polar import signed_difference
from physics.shapes import Ball, Contact, Ring
from physics.tolerances import MAX_STEPS, TOUCH
from physics.trig import bearing_of, direction
from physics.vectors import cross, dot, length, quarter_turn

_RADIANS_PER_STEP = 0.25


class Impact(NamedTuple):
    """The first touch of a ball with a ring."""

    time: float  # seconds from now
    slot: int
    contact: Contact


class _End(NamedTuple):
    """One straight end of a sector, facing the gap the ball is in."""

    slot: int
    angle: float  # where it is now, radians
    sign: float  # +1 the counter-clockwise end of its sector, -1 the clockwise one


def time_of_impact(ball: Ball, ring: Ring, dt: float, alive: Sequence[int] | None = None) -> Impact | None:
    """The first touch of the ball with a living sector within dt seconds, or None.

    ball and ring are given at time 0; dt: seconds, finite and >= 0, else ValueError. alive: one entry per slot, falsy where
    the slot is empty; None for a ring with all its sectors.
    A ball that touches or overlaps a sector at time 0 has its impact at 0 if it approaches it, and none with that
    sector while it separates from it. A graze that brings the ball no nearer than TOUCH may be either.
    """
    if not 0.0 <= dt < math.inf:
        raise ValueError(f"dt must be finite and at least 0, not {dt}")
    for start, stop in _band_windows(ball, ring, dt):
        impact = _first_touch(ball, ring, start, stop, alive)
        if impact is not None:
            return impact
    return None


def _band_windows(ball: Ball, ring: Ring, dt: float) -> tuple[tuple[float, float], ...]:  # noqa: PLR0911  # one return a case
    """The stretches of [0, dt] in which the ball reaches into the ring's band: none, one, or two around the hole."""
    p, v, ball_radius = ball
    outer = ring.radius + ring.half_width + ball_radius
    inner = ring.radius - ring.half_width - ball_radius
    distance = length(p)
    square = dot(v, v)
    if square == 0.0:
        return ((0.0, dt),) if inner <= distance <= outer else ()
    outward = dot(p, v)
    beyond = (distance - outer) * (distance + outer)
    root = outward * outward - square * beyond
    if root < 0.0 or (beyond > 0.0 and outward >= 0.0):
        return ()
    start = beyond / (math.sqrt(root) - outward) if beyond > 0.0 else 0.0
    if start > dt:
        return ()
    stop = min(_later_root(square, outward, beyond, root), dt)
    if inner <= 0.0:
        return ((start, stop),)
    beyond = (distance - inner) * (distance + inner)
    root = outward * outward - square * beyond
    if beyond < 0.0:
        start = _later_root(square, outward, beyond, root)
        return ((start, stop),) if start <= dt else ()
    if outward >= 0.0 or root <= 0.0:
        return ((start, stop),)
    hole = beyond / (math.sqrt(root) - outward)
    if hole >= dt:
        return ((start, stop),)
    again = _later_root(square, outward, beyond, root)
    return ((start, hole), (again, stop)) if again <= dt else ((start, hole),)


def _later_root(square: float, outward: float, beyond: float, root: float) -> float:
    """The later root of square t^2 + 2 outward t + beyond = 0, without cancellation; root: its quarter discriminant."""
    if outward > 0.0:
        return -beyond / (outward + math.sqrt(root))
    return (math.sqrt(root) - outward) / square


def _first_touch(ball: Ball, ring: Ring, start: float, stop: float, alive: Sequence[int] | None) -> Impact | None:
    """The first touch while the ball is in the band, from `start` to `stop`."""
    ball = ball.moved(start)
    span = stop - start
    pitch = math.tau / ring.count
    phase = signed_difference(ring.phase, 0.0) + ring.spin * start
    bearing = bearing_of(ball.position)
    nearest = round((bearing - phase) / pitch)
    middle = phase + nearest * pitch
    offset = bearing - middle
    slot = nearest % ring.count
    skipped: int | None = None
    if abs(offset) <= ring.half_angle and (alive is None or alive[slot] != 0):
        face = sector_contact(ball.position, ball.radius, ring, middle, offset)
        if _approach(ball, ring, face) < 0.0:
            return Impact(start, slot, face)
        skipped = slot  # the ball separates from it
    reach = _reach(ball, ring, span)
    first: Impact | None = None
    for sign in (-1, 1):
        end = _next_end(ring, alive, middle, offset, nearest, sign, skipped, reach)
        if end is None:
            continue
        touch = _touch_of_resting_end if ring.spin == 0.0 else _touch_of_turning_end
        time = touch(ball, ring, end, span)
        if time is not None and (first is None or (start + time, end.slot) < (first.time, first.slot)):
            first = Impact(start + time, end.slot, _contact_with_end(ball, ring, end, time))
    return first


def _approach(ball: Ball, ring: Ring, contact: Contact) -> float:
    """Rate of the gap: < 0 while the ball approaches the turning surface."""
    return dot(contact.normal, ball.velocity - ring.surface_velocity(contact.point))


def _reach(ball: Ball, ring: Ring, span: float) -> float:
    """Angle beyond which no end can be touched within `span` seconds; infinite for a ball that may cover the centre.

    A disc of radius s at distance d > s from the centre is seen under asin(s / d) <= s pi / (2 d) to each side.
    """
    travel = length(ball.velocity) * span + ball.radius + TOUCH
    distance = length(ball.position)
    if distance <= travel:
        return math.inf
    return travel * math.pi / (2.0 * distance) + abs(ring.spin) * span


def _next_end(
    ring: Ring,
    alive: Sequence[int] | None,
    middle: float,
    offset: float,
    nearest: int,
    sign: int,
    skipped: int | None,
    reach: float,
) -> _End | None:
    """The end that bounds the ball's gap on one side, -1 clockwise or +1 counter-clockwise, if within reach.

    middle, offset: of slot `nearest`, and the ball's from it. skipped: a slot whose sector is left out.
    """
    pitch = math.tau / ring.count
    first = 1 if offset * sign > 0.0 else 0
    for step in range(first, first + ring.count):
        turn = sign * (step * pitch - ring.half_angle)
        if (turn - offset) * sign > reach:
            return None
        slot = (nearest + sign * step) % ring.count
        if slot != skipped and (alive is None or alive[slot] != 0):
            return _End(slot, middle + turn, -1.0 if sign > 0 else 1.0)
    return None


def _contact_with_end(ball: Ball, ring: Ring, end: _End, time: float) -> Contact:
    """Contact of the ball with one end, `time` seconds from now."""
    p = ball.position + ball.velocity * time
    along = direction(end.angle + ring.spin * time)
    return end_contact(p, ball.radius, along, end.sign, ring.radius - ring.half_width, ring.radius + ring.half_width)


def _touch_of_resting_end(ball: Ball, ring: Ring, end: _End, span: float) -> float | None:
    """Time of the first touch with an end at rest: of its line, a linear equation; of its corners, a quadratic each."""
    contact = _contact_with_end(ball, ring, end, 0.0)
    if dot(contact.normal, ball.velocity) >= 0.0:
        return None  # the distance to a convex set, seen from a straight path, grows for good once it grows
    if contact.gap <= TOUCH:
        return 0.0
    p, v, ball_radius = ball
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    along = direction(end.angle)
    height, climb = end.sign * cross(along, p), end.sign * cross(along, v)
    first = math.inf
    if climb < 0.0 and height >= ball_radius:
        time = (height - ball_radius) / -climb
        if inner <= dot(along, p + v * time) <= outer:
            first = time
    for corner in (along * inner, along * outer):
        time = _time_to_point(p - corner, v, ball_radius)
        first = min(first, time)
    return first if first <= span else None


def _time_to_point(p: complex, v: complex, ball_radius: float) -> float:
    """When a ball, its centre at p from a point, first touches that point; infinite if it never does."""
    distance = length(p)
    beyond = (distance - ball_radius) * (distance + ball_radius)
    outward = dot(p, v)
    root = outward * outward - dot(v, v) * beyond
    if outward >= 0.0 or root <= 0.0:
        return math.inf
    return max(beyond, 0.0) / (math.sqrt(root) - outward)


def _touch_of_turning_end(ball: Ball, ring: Ring, end: _End, span: float) -> float | None:
    """Time of the first touch with a turning end, by steps that cannot overshoot (the module's docstring)."""
    v, spin = ball.velocity, ring.spin
    turn_rate = abs(spin)
    farthest = ring.radius + ring.half_width + ball.radius
    jerk = turn_rate * turn_rate * (turn_rate * farthest + 3.0 * length(v))
    longest = _RADIANS_PER_STEP / turn_rate
    coriolis = quarter_turn(v) * (-2.0 * spin)
    time = 0.0
    for _ in range(MAX_STEPS):
        contact = _contact_with_end(ball, ring, end, time)
        rate = _approach(ball, ring, contact)
        gap = max(contact.gap, 0.0)
        if gap <= TOUCH and rate < 0.0:
            return time
        horizon = min(span - time, longest)
        centripetal = (ball.position + v * time) * (spin * spin)
        bend = dot(contact.normal, coriolis - centripetal) - jerk * horizon / 3.0
        step = _first_root(gap, rate, bend)
        if step >= horizon:
            time += horizon
            if time >= span:
                return None
        elif time + step <= time:
            return time  # touching, and about to be pressed
        else:
            time += step
    return time


def _first_root(gap: float, rate: float, bend: float) -> float:
    """The first s > 0 with gap + rate s + bend s^2 / 2 = 0 after which it is negative; infinite if there is none."""
    square = rate * rate - 2.0 * bend * gap
    if square < 0.0:
        return math.inf
    if rate < 0.0:
        return 2.0 * gap / (math.sqrt(square) - rate)
    return (rate + math.sqrt(square)) / -bend if bend < 0.0 else math.inf
