"""When does a moving ball first touch a turning end? By steps that cannot overshoot.

An end with its two corners is a segment. In the end's own frame, with x along it and y across it, a touch is the first root
of one of three functions:

    the height y - r,   the run x - c beyond a corner c,   the corner's (|q - c|^2 - r^2) / 2

Beside the segment nothing is touched while the height is above 0. Beyond a corner nothing is touched while the height is, nor
while both the run and the corner's function are. Each of the three obeys

    f(s) >= f + f' s + f'' s^2 / 2 - J s^3 / 6,   J = |w|^3 |p| + 3 w^2 |v|,   and c J for the corner's function,

so the first root of the right side is a step that no touch precedes. Near a touch, also near a graze, such steps converge
faster than Newton's. One step turns the ring by at most a radian, and three half turns bring an end past every straight path.
"""

import math

from physics.narrow_phase import closest_point_on_line
from physics.polar import signed_difference, to_cartesian
from physics.shapes import Ball, Ring
from physics.sweep.gap import End, angle_of_end
from physics.tolerances import MAX_STEPS, TOUCH
from physics.trig import direction
from physics.vectors import cross, dot, length

_RADIANS_PER_STEP = 1.0


def touch_of_turning_end(ball: Ball, ring: Ring, end: End, span: float) -> float | None:
    """Seconds until the first touch with a turning end, within `span` seconds, or None.

    A search that used up MAX_STEPS would end where it stands, which no touch precedes.
    """
    p, v, ball_radius = ball
    spin = ring.spin
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    end_angle = angle_of_end(ring, end)
    along = to_cartesian(1.0, end_angle)
    nearest = closest_point_on_line(along * inner, along * outer, p)
    gap = length(p - nearest) - ball_radius
    turn_rate, speed, farthest = abs(spin), length(v), outer + ball_radius
    if gap <= TOUCH * farthest and dot(p - nearest, v - ring.surface_velocity(nearest)) < 0.0:
        return 0.0
    if gap > (speed + turn_rate * farthest) * span:
        return None
    angle = signed_difference(end_angle, 0.0)  # from -pi: the mirrored end turns through the negated angles, to the bit
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
        along = direction(angle + spin * time)
    return time


def safe_step(
    p: complex, v: complex, r: float, spin: float, along: complex, inner: float, outer: float, jerk: float, horizon: float
) -> float:
    """Seconds, at most `horizon`, for which a ball touches no point of an end that now points along `along`.

    0 where it touches and approaches.
    """
    touch = TOUCH * (outer + r)
    x, y, vx, vy = dot(along, p), cross(along, p), dot(along, v), cross(along, v)
    if y < 0.0:
        y, vy, spin = -y, -vy, -spin  # the same, seen in a mirror
    height = y - r
    dx, dy = vx + spin * y, vy - spin * x
    ddx, ddy = spin * (2.0 * vy - spin * x), -spin * (2.0 * vx + spin * y)
    if inner <= x <= outer:
        return 0.0 if height <= touch and dy < 0.0 else _time_above_zero(height, dy, ddy, jerk, horizon)
    corner = inner if x < inner else outer
    run = x - corner
    gap = math.sqrt(run * run + y * y) - r
    rate = run * dx + y * dy
    if gap <= touch and rate < 0.0:
        return 0.0
    bend = dx * dx + dy * dy + run * ddx + y * ddy
    apart = _time_above_zero(gap * (0.5 * gap + r), rate, bend, corner * jerk, horizon)
    if run < 0.0:
        run, dx, ddx = -run, -dx, -ddx
    beyond = min(apart, _time_above_zero(run, dx, ddx, jerk, horizon))
    if height <= -touch or beyond >= horizon:
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
