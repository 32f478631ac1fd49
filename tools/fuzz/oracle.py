"""The geometry of balls and sectors once more, from the C library's trigonometry and plain sampling.

It shares no code with `physics`: it knows only the numbers in a `Ball` and a `Ring`. It visits every living sector,
asks for one distance at a time, and walks along a flight by steps that a bound on the gap's rate of change allows.
"""

import math
from bisect import bisect
from collections.abc import Callable
from functools import lru_cache

from physics import Ball, Ring

FINEST = 3e-3
"""Fraction of the ball's radius: the walk's shortest step, in the distance that ball and ring may cover.

A corner clipped to a depth of 1.2e-6 radii is under the ball for longer than such a step.
"""

LONGEST_WALK = 20_000
"""Steps at the finest: a flight along a wall is cut into no more."""


def ring_gap(p: complex, ball_radius: float, ring: Ring, time: float, alive: tuple[int, ...] | None = None) -> float:
    """Distance between a ball at p and the nearest living sector of a ring, `time` seconds on; < 0 by the overlap."""
    distance = math.hypot(p.real, p.imag)
    bearing = math.atan2(p.imag, p.real) - ring.phase - ring.spin * time
    away = _angle_beside(bearing, ring.count, alive)
    return distance_to_sector(distance, away - ring.half_angle, ring) - ball_radius if away < math.inf else math.inf


def slot_gap(p: complex, ball_radius: float, ring: Ring, time: float, slot: int) -> float:
    """`ring_gap` for one sector."""
    return ring_gap(p, ball_radius, ring, time, tuple([int(k == slot) for k in range(ring.count)]))


def first_overlap(
    ball: Ball,
    ring: Ring,
    start: float,
    stop: float,
    alive: tuple[int, ...] | None,
    tolerance: float,
    finest: float = FINEST,
) -> float | None:
    """The first moment seen at which a ball that flies straight from `start` to `stop` overlaps by more than `tolerance`.

    ball: where it is at `start`; ring: where it is at time 0. In s seconds the gap shrinks by at most
    (|v| + |spin| |p|) s: the walk takes steps that this bound cannot overshoot, but none below `finest` radii.
    """
    size = math.hypot(ball.velocity.real, ball.velocity.imag)
    distance = math.hypot(ball.position.real, ball.position.imag)
    far = distance + size * (stop - start)
    if abs(distance - ring.radius) > ring.half_width + ball.radius + size * (stop - start):
        return None
    closed = ring.half_angle >= math.pi / ring.count and (alive is None or all(alive))
    spin = 0.0 if closed else abs(ring.spin)
    return walk(
        lambda time: ring_gap(ball.position + ball.velocity * (time - start), ball.radius, ring, time, alive),
        (start, stop),
        size + spin * min(far, ring.radius + ring.half_width + ball.radius),
        tolerance,
        finest * ball.radius,
    )


def walk(
    gap: Callable[[float], float], window: tuple[float, float], pace: float, tolerance: float, finest: float
) -> float | None:
    """The first moment seen of a window at which a gap that changes by at most `pace` a second is below -tolerance."""
    time, stop = window
    shortest = max(finest / pace, (stop - time) / LONGEST_WALK) if pace > 0.0 else 0.0
    while True:
        now = gap(time)
        if now < -tolerance:
            return time
        if time >= stop:
            return None
        time = min(time + max(now / pace, shortest), stop) if pace > 0.0 else stop


def _angle_beside(bearing: float, count: int, alive: tuple[int, ...] | None) -> float:
    """Angle between a bearing, seen from slot 0's middle, and the middle of the nearest living slot; infinite for none."""
    middles = _middles(count, alive)
    if not middles:
        return math.inf
    bearing = math.fmod(bearing, 2.0 * math.pi)
    bearing += 2.0 * math.pi if bearing < 0.0 else 0.0
    after = bisect(middles, bearing)
    before = middles[after - 1]
    behind = middles[after if after < len(middles) else 0]
    return min(abs(math.remainder(bearing - before, 2.0 * math.pi)), abs(math.remainder(behind - bearing, 2.0 * math.pi)))


@lru_cache(maxsize=4096)
def _middles(count: int, alive: tuple[int, ...] | None) -> list[float]:
    """Middle angles of the living slots, from slot 0's on."""
    return [slot * (2.0 * math.pi / count) for slot in range(count) if alive is None or alive[slot]]


def distance_to_sector(distance: float, beside: float, ring: Ring) -> float:
    """Distance to a sector of a point at a distance from the centre and an angle beside the sector, < 0 within it."""
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    if beside <= 0.0:
        radial = max(inner - distance, distance - outer)
        if radial >= 0.0 or ring.half_angle >= math.pi or beside <= -math.pi / 2.0:
            return radial
        return max(radial, distance * math.sin(beside))
    along = distance * math.cos(beside)
    return math.hypot(along - min(max(along, inner), outer), distance * math.sin(beside))
