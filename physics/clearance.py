"""For how long does a ball certainly touch nothing, whatever the player does to the paddles meanwhile?

A ball outside a ring's band touches nothing of it before it enters the band. Inside the band it touches nothing before
its way around the centre, its own size and the ring's turning have used up the angle to the next sector on either side.
Only a ring that turns can be steered: it is taken to be as fast at its rim as the ball, or as it is where that is more.
"""

import math
from collections.abc import Sequence

from physics.shapes import Ball, Ring
from physics.time_of_impact import Stretch, next_end, stretches
from physics.tolerances import ANGLE_SLACK, CLEARANCE, LARGEST, TOUCH
from physics.trig import bearing_of
from physics.vectors import cross, dot, length


def clear_time(ball: Ball, rings: Sequence[Ring], layers: Sequence[Sequence[int]], horizon: float) -> float:
    """Seconds, at most `horizon`, for which a ball certainly touches no living sector; 0 where it may touch one now.

    layers: per ring and slot, 0 where nothing is. horizon: >= 0, finite.
    """
    p, v, ball_radius = ball
    distance, pace, outward = length(p), length(v), dot(p, v) >= 0.0
    if not pace * horizon <= LARGEST:
        return 0.0
    margin = 2.0 * TOUCH + CLEARANCE * (distance + ball_radius + pace * horizon)
    larger = tuple.__new__(Ball, (p, v, ball_radius + margin))
    clear = horizon
    for ring, alive in zip(rings, layers, strict=True):
        reach = ring.half_width + larger.radius
        from_inside, from_outside = reach + pace * clear, reach if outward else reach + pace * clear
        if -from_inside <= distance - ring.radius <= from_outside:
            clear = _clear_of_ring(larger, pace, ring, alive, clear)
            if clear == 0.0:
                return 0.0
    return clear


def may_be_steered(old: Ring, new: Ring, balls: Sequence[Ball]) -> bool:
    """Whether clear times of these balls found for the old ring hold for the new one: it is the same, but for its spin.

    It turned, and turns no faster than before, or its rim is no faster than any of the balls.
    """
    if old.spin == 0.0 or new[:5] != old[:5]:
        return False
    rim = abs(new.spin) * (new.radius + new.half_width)
    return abs(new.spin) <= abs(old.spin) or all([rim <= length(ball.velocity) for ball in balls])


def _clear_of_ring(ball: Ball, pace: float, ring: Ring, alive: Sequence[int], horizon: float) -> float:
    """`clear_time` for one ring within reach."""
    turning = max(abs(ring.spin), pace / (ring.radius + ring.half_width)) if ring.spin != 0.0 else 0.0
    for stretch in stretches(ball, ring, horizon):
        clear = _clear_of_sectors(ball, ring, alive, stretch, turning)
        if clear < stretch.stop:
            return clear
    return horizon


def _clear_of_sectors(ball: Ball, ring: Ring, alive: Sequence[int], stretch: Stretch, turning: float) -> float:
    """Seconds from now for which a ball stays clear of the sectors beside it, on a stretch of its flight in the band.

    turning: rad/s at most. Seen from the centre, at distance d, the ball itself covers asin(r / d) to each side, which is
    at most x + (pi / 2 - 1) x^3 for x = r / d, and its centre moves by L / d^2 rad/s, L = p x v. On one stretch d is
    least at one of its ends.
    """
    p, v, ball_radius = ball
    start, stop, _ = stretch
    entry = p + v * start
    nearest = min(length(entry), length(p + v * stop))
    if nearest <= ball_radius:
        return start
    x = ball_radius / nearest
    covered = x + (math.pi / 2.0 - 1.0) * x * x * x + turning * start + ANGLE_SLACK
    sweep = cross(p, v) / (nearest * nearest)
    bearing = bearing_of(entry)
    pitch = math.tau / ring.count
    slot = round((bearing - ring.phase) / pitch)
    middle = ring.phase + slot * pitch
    clear = stop
    for sign in (-1, 1):
        closing = max(sign * sweep, 0.0) + turning
        end = next_end(ring, alive, middle, bearing - middle, slot, sign, None, covered + closing * (clear - start))
        if end is not None:
            apart = (end.angle - bearing) * sign - covered
            if apart <= 0.0:
                return start
            if apart < closing * (clear - start):
                clear = start + apart / closing
    return clear
