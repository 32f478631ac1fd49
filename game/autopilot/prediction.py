"""Where a ball will come to the paddles' track."""

import math

from game.rules import PADDLES, POINTER_STEPS
from physics import Arena, Ball, FreeFlight, advance, cross, dot, normalize_angle

LOOK = 1.0 / 20.0
"""Seconds per step when looking ahead; the physics is exact for any step."""
_HORIZON = 60
_FAR = 1.0 - 1e-9
"""Far above rounding."""


def without_paddles(arena: Arena, ball: Ball) -> Arena:
    """One ball and the bricks."""
    return Arena((ball,), arena.rings[PADDLES + 1 :], arena.layers[PADDLES + 1 :])


def crossing(arena: Arena, track: float, speed: float) -> tuple[float, Arena, int] | None:
    """Time, arena and bricks hit when the ball's centre comes to the track from inside; None beyond the horizon."""
    hits = 0
    flight: FreeFlight | None = None
    for step in range(_HORIZON):
        ball = arena.balls[0]
        left = _time_to_radius(ball, track) if _may_reach(ball, track) else math.inf
        if left <= LOOK:
            reached = advance(arena, max(left, 0.0), speed, flight)
            if not reached.hits:
                return step * LOOK + left, reached.arena, hits
        done = advance(arena, LOOK, speed, flight)
        hits += len(done.hits)
        arena, flight = done.arena, done.flight
    return None


def _may_reach(ball: Ball, radius: float) -> bool:
    """Whether the centre may cross a radius outward within LOOK; cheaper than when. False only where it is far from it."""
    p, v, _ = ball
    flown = LOOK * (abs(v.real) + abs(v.imag))  # at least as far as it flies
    return flown >= radius or p.real * p.real + p.imag * p.imag > (radius - flown) * (radius - flown) * _FAR


def _time_to_radius(ball: Ball, radius: float) -> float:
    """Seconds of free flight until the centre crosses a radius outward: the later root of |p + v t| = radius."""
    p, v, _ = ball
    square = dot(v, v)
    root = square * radius * radius - cross(p, v) * cross(p, v)
    return (math.sqrt(root) - dot(p, v)) / square if root > 0.0 else 0.0


def pointer_to(angle: float) -> int:
    """An angle in pointer steps."""
    return int(normalize_angle(angle) / math.tau * POINTER_STEPS) % POINTER_STEPS
