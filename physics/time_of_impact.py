"""First touch of a moving ball with a turning ring, exact in time.

The ball flies straight, p + v t. It can touch a ring only while its distance from the centre lies between the inner
radius less its own and the outer radius plus its own: the ring's band, entered and left at roots of quadratics. On one
stretch it flies inward, on another outward. Where a stretch begins above a sector, that moment is the touch of a face:
of an outer one flying inward, of an inner one flying outward. Where it begins over a gap, the ball stays in that gap
until it touches one of the gap's two ends: every other sector is farther at every radius. So one search costs the same
with any number of sectors: at most two stretches, at most two ends each.

An end with its two corners is a segment. The ball touches it where its centre enters the rectangle of all points within
its radius beside the segment, or the disc of that radius around a corner. At rest, each has a closed form. Turning, the
touch is found by steps that cannot overshoot. With x along the end and y across it, in the end's own frame, each of

    the height y - r,   the run x - c beyond a corner,   the corner's (|q - c|^2 - r^2) / 2

obeys f(s) >= f + f' s + f'' s^2 / 2 - J s^3 / 6, where J = |w|^3 |p| + 3 w^2 |v|, and c J for the corner's function.
Beside the segment, nothing is touched while the height is above 0; beyond a corner, nothing while the height is, nor
while both the run and the corner's function are. The first root of the right side is a safe step, and near a touch, also
near a graze, such steps converge faster than Newton's. One step turns the ring by at most a radian, and three half turns
bring an end past every straight path.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.narrow_phase import closest_point_on_line, end_contact, sector_contact
from physics.polar import signed_difference
from physics.shapes import Ball, Contact, Feature, Ring
from physics.tolerances import MAX_STEPS, TOUCH
from physics.trig import bearing_of, direction
from physics.vectors import cross, dot, length

_RADIANS_PER_STEP = 1.0


class Impact(NamedTuple):
    """The first touch of a ball with a ring."""

    time: float  # seconds from now
    slot: int
    contact: Contact


class Stretch(NamedTuple):
    """A part of the flight, in seconds from now, on which the ball reaches into the band."""

    start: float
    stop: float
    heading: int  # -1 inward, +1 outward, 0 at rest


class End(NamedTuple):
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
    for stretch in stretches(ball, ring, dt):
        impact = _first_touch(ball, ring, stretch, alive)
        if impact is not None:
            return impact
    return None


def stretches(ball: Ball, ring: Ring, dt: float) -> list[Stretch]:
    """The stretches of [0, dt] on which the ball reaches into the ring's band: at most one inward, then one outward."""
    p, v, ball_radius = ball
    outer = ring.radius + ring.half_width + ball_radius
    inner = ring.radius - ring.half_width - ball_radius
    distance = length(p)
    square = dot(v, v)
    if square == 0.0:
        return [Stretch(0.0, dt, 0)] if inner <= distance <= outer else []
    outward = dot(p, v)
    above = (distance - outer) * (distance + outer)
    root = outward * outward - square * above
    if root < 0.0 or (above > 0.0 and outward >= 0.0):
        return []
    begin = above / (math.sqrt(root) - outward) if above > 0.0 else 0.0
    if begin > dt:
        return []
    end = min(_later_root(square, outward, above, root), dt)
    turn_in = turn_out = -outward / square  # the ball is nearest to the centre; or it enters the hole and leaves it
    if inner > 0.0:
        above = (distance - inner) * (distance + inner)
        root = outward * outward - square * above
        if root > 0.0 and (above <= 0.0 or outward < 0.0):
            turn_in = above / (math.sqrt(root) - outward) if above > 0.0 else 0.0
            turn_out = _later_root(square, outward, above, root)
    stretches = []
    if begin < turn_in:
        stretches.append(Stretch(begin, min(turn_in, end), -1))
    begin = max(begin, turn_out)
    if begin <= dt:
        stretches.append(Stretch(begin, max(begin, end), 1))
    return stretches


def _later_root(square: float, outward: float, above: float, root: float) -> float:
    """The later root of square t^2 + 2 outward t + above = 0, without cancellation; root: its quarter discriminant."""
    if outward > 0.0:
        return -above / (outward + math.sqrt(root))
    return (math.sqrt(root) - outward) / square


def _first_touch(ball: Ball, ring: Ring, stretch: Stretch, alive: Sequence[int] | None) -> Impact | None:
    """The first touch on one stretch of the flight."""
    start, stop, heading = stretch
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
    if 2.0 * ring.half_angle >= pitch:  # closed: no gap opens where rounding puts the joint of two sectors
        offset = min(max(offset, -ring.half_angle), ring.half_angle)
    if abs(offset) <= ring.half_angle and (alive is None or alive[slot] != 0):
        over = sector_contact(ball.position, ball.radius, ring, middle, offset)
        if _meets(ball, ring, over, heading):
            return Impact(start, slot, over)
        skipped = slot  # the ball separates from it
    reach = _reach(ball, ring, span)
    first: Impact | None = None
    for sign in (-1, 1):
        end = next_end(ring, alive, middle, offset, nearest, sign, skipped, reach)
        if end is None:
            continue
        touch = _touch_of_resting_end if ring.spin == 0.0 else _touch_of_turning_end
        time = touch(ball, ring, end, span)
        if time is not None and (first is None or (start + time, end.slot) < (first.time, first.slot)):
            first = Impact(start + time, end.slot, _contact_with_end(ball, ring, end, time))
    return first


def _meets(ball: Ball, ring: Ring, contact: Contact, heading: int) -> bool:
    """Whether a ball above a sector meets it: a face by its heading, an end, from inside, by the rate of the gap."""
    if contact.feature == Feature.OUTER_FACE:
        return heading < 0
    if contact.feature == Feature.INNER_FACE:
        return heading > 0
    return dot(contact.normal, ball.velocity - ring.surface_velocity(contact.point)) < 0.0


def _reach(ball: Ball, ring: Ring, span: float) -> float:
    """Angle beyond which no end can be touched within `span` seconds; infinite for a ball that may cover the centre.

    A disc of radius s at distance d > s from the centre is seen under asin(s / d) <= s pi / (2 d) to each side.
    """
    travel = length(ball.velocity) * span + ball.radius + TOUCH
    distance = length(ball.position)
    if distance <= travel:
        return math.inf
    return travel * math.pi / (2.0 * distance) + abs(ring.spin) * span


def next_end(
    ring: Ring,
    alive: Sequence[int] | None,
    middle: float,
    offset: float,
    nearest: int,
    sign: int,
    skipped: int | None,
    reach: float,
) -> End | None:
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
            return End(slot, middle + turn, -1.0 if sign > 0 else 1.0)
    return None


def _contact_with_end(ball: Ball, ring: Ring, end: End, time: float) -> Contact:
    """Contact of the ball with one end, `time` seconds from now."""
    p = ball.position + ball.velocity * time
    along = direction(end.angle + ring.spin * time)
    return end_contact(p, ball.radius, along, end.sign, ring.radius - ring.half_width, ring.radius + ring.half_width)


def _touch_of_resting_end(ball: Ball, ring: Ring, end: End, span: float) -> float | None:
    """Time of the first touch with an end at rest: of its line, a linear equation; of its corners, a quadratic each."""
    contact = _contact_with_end(ball, ring, end, 0.0)
    if dot(contact.normal, ball.velocity) >= 0.0:
        return None  # the distance to a convex set, seen from a straight path, grows for good once it grows
    if contact.gap <= TOUCH:
        return 0.0
    p, v, ball_radius = ball
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    along = direction(end.angle)
    height, climb = cross(along, p), cross(along, v)
    if height < 0.0:
        height, climb = -height, -climb
    first = math.inf
    if climb < 0.0 and height >= ball_radius:
        time = (height - ball_radius) / -climb
        if inner <= dot(along, p + v * time) <= outer:
            first = time
    for corner in (along * inner, along * outer):
        first = min(first, _time_to_point(p - corner, v, ball_radius))
    return first if first <= span else None


def _time_to_point(p: complex, v: complex, ball_radius: float) -> float:
    """When a ball, its centre at p from a point, first touches that point; infinite if it never does."""
    distance = length(p)
    above = (distance - ball_radius) * (distance + ball_radius)
    outward = dot(p, v)
    root = outward * outward - dot(v, v) * above
    if outward >= 0.0 or root <= 0.0:
        return math.inf
    return max(above, 0.0) / (math.sqrt(root) - outward)


def _touch_of_turning_end(ball: Ball, ring: Ring, end: End, span: float) -> float | None:
    """Time of the first touch with a turning end, by steps that cannot overshoot (the module's docstring).

    A search that used up MAX_STEPS would end where it stands, which no touch precedes.
    """
    p, v, ball_radius = ball
    spin = ring.spin
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    along = direction(end.angle)
    nearest = closest_point_on_line(along * inner, along * outer, p)
    gap = length(p - nearest) - ball_radius
    turn_rate, speed, farthest = abs(spin), length(v), outer + ball_radius
    if gap > (speed + turn_rate * farthest) * span:
        return None
    if gap <= TOUCH and dot(p - nearest, v - ring.surface_velocity(nearest)) < 0.0:
        return 0.0
    jerk = turn_rate * turn_rate * (turn_rate * farthest + 3.0 * speed)
    longest = _RADIANS_PER_STEP / turn_rate
    time = 0.0
    for _ in range(MAX_STEPS):
        horizon = min(span - time, longest)
        step = safe_step(p + v * time, v, ball_radius, spin, along, inner, outer, jerk, horizon)
        if step < horizon and time + step <= time:
            return time
        time += step
        if time >= span:
            return None
        along = direction(end.angle + spin * time)
    return time


def safe_step(
    p: complex, v: complex, r: float, spin: float, along: complex, inner: float, outer: float, jerk: float, horizon: float
) -> float:
    """Seconds, at most `horizon`, for which a ball touches no point of an end that now points along `along`.

    0 where it touches and approaches.
    """
    x, y, vx, vy = dot(along, p), cross(along, p), dot(along, v), cross(along, v)
    if y < 0.0:
        y, vy, spin = -y, -vy, -spin  # the same, seen in a mirror
    height = y - r
    dx, dy = vx + spin * y, vy - spin * x
    ddx, ddy = spin * (2.0 * vy - spin * x), -spin * (2.0 * vx + spin * y)
    if inner <= x <= outer:
        return 0.0 if height <= TOUCH and dy < 0.0 else _time_above_zero(height, dy, ddy, jerk, horizon)
    corner = inner if x < inner else outer
    run = x - corner
    gap = math.sqrt(run * run + y * y) - r
    rate = run * dx + y * dy
    if gap <= TOUCH and rate < 0.0:
        return 0.0
    bend = dx * dx + dy * dy + run * ddx + y * ddy
    apart = _time_above_zero(gap * (0.5 * gap + r), rate, bend, corner * jerk, horizon)
    if run < 0.0:
        run, dx, ddx = -run, -dx, -ddx
    beyond = min(apart, _time_above_zero(run, dx, ddx, jerk, horizon))
    if height <= -TOUCH or beyond >= horizon:
        return beyond
    return max(beyond, _time_above_zero(height, dy, ddy, jerk, horizon))


def _time_above_zero(value: float, rate: float, bend: float, jerk: float, horizon: float) -> float:
    """Seconds, at most `horizon`, for which value + rate s + bend s^2 / 2 - jerk s^3 / 6 stays above 0.

    For h seconds that cubic lies above the parabola with the bend less jerk h / 3. The parabola's root for the whole
    horizon is a first answer; then shorter h, from twice that root up, say how much more is free.
    """
    value = max(value, 0.0)
    free = _first_root(value, rate, bend - jerk * horizon / 3.0)
    if free >= horizon:
        return horizon
    if rate >= 0.0 and bend > 0.0:
        free = max(free, min(bend / jerk, horizon))
    while 0.0 < free < horizon / 2.0:
        trial = 2.0 * free
        root = _first_root(value, rate, bend - jerk * trial / 3.0)
        if root < trial:
            return root
        free = trial
    return free


def _first_root(value: float, rate: float, bend: float) -> float:
    """The first s > 0 with value + rate s + bend s^2 / 2 = 0 after which it is negative; infinite if there is none."""
    square = rate * rate - 2.0 * bend * value
    if square < 0.0:
        return math.inf
    if rate < 0.0:
        return 2.0 * value / (math.sqrt(square) - rate)
    return (rate + math.sqrt(square)) / -bend if bend < 0.0 else math.inf
