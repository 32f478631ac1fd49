"""Where a ball will come to the paddles' track."""

import math

from game.rules import PADDLES, POINTER_STEPS
from physics import Arena, Ball, FreeFlight, advance, cross, dot, normalize_angle

LOOK = 1.0 / 20.0
"""Seconds per step when looking ahead; the physics is exact for any step."""
_HORIZON = 60
_SURELY = 1.0 - 1e-9
"""Slightly less than a whole step: the margin is far larger than rounding errors."""


def without_paddles(arena: Arena, ball: Ball) -> Arena:
    """One ball and the bricks."""
    return Arena((ball,), arena.rings[PADDLES + 1 :], arena.layers[PADDLES + 1 :])


def crossing(arena: Arena, track: float, speed: float) -> tuple[float, Arena, int] | None:
    """Time, arena and bricks hit when the ball's centre comes to the track from inside; None beyond the horizon."""
    hits = step = 0
    flight: FreeFlight | None = None
    while step < _HORIZON:
        left = _time_to_radius(arena.balls[0], track)
        if left <= LOOK:
            reached = advance(arena, max(left, 0.0), speed, flight)
            if not reached.hits:
                return step * LOOK + left, reached.arena, hits
        elif flight is not None:
            _, seconds, turning = flight
            free = min(int(min(seconds, left) / LOOK * _SURELY), _HORIZON - step)
            if free > 0:
                arena, step = _flown_freely(arena, turning, free), step + free
                flight = arena, seconds - free * LOOK, turning
                continue
        done = advance(arena, LOOK, speed, flight)
        hits += len(done.hits)
        arena, flight, step = done.arena, done.flight, step + 1
    return None


def _flown_freely(arena: Arena, turning: tuple[int, ...], steps: int) -> Arena:
    """The arena after some steps in which nothing is touched: the bits of `advance` in each.

    turning: indices of the rings that turn. Calling `advance` for each of these steps would make a prediction a seventh slower.
    """
    balls, rings, layers = arena
    position, velocity, radius = balls[0]
    flown = velocity * LOOK
    for _ in range(steps):
        position += flown
    turned = [*rings]
    for k in turning:
        for _ in range(steps):
            turned[k] = turned[k].turned(LOOK)
    return Arena((Ball(position, velocity, radius),), tuple(turned), layers)


def _time_to_radius(ball: Ball, radius: float) -> float:
    """Seconds of free flight until the centre crosses a radius outward: the later root of |p + v t| = radius."""
    p, v, _ = ball
    square = dot(v, v)
    root = square * radius * radius - cross(p, v) * cross(p, v)
    return (math.sqrt(root) - dot(p, v)) / square if root > 0.0 else 0.0


def pointer_to(angle: float) -> int:
    """An angle in pointer steps."""
    return int(normalize_angle(angle) / math.tau * POINTER_STEPS) % POINTER_STEPS
