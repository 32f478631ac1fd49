"""Where a ball will come to the paddles' track.

`crossing` is compiled as it stands for many games at once; the five functions of an `Ahead` that it calls are then replaced by
those of `tools/autopilot/plans.py`, which do the same on arrays.
"""

import math
from typing import NamedTuple

from game.rules import PADDLES, POINTER_STEPS
from physics import Arena, Ball, FreeFlight, advance, cross, dot, normalize_angle
from physics.escape import all_freed

LOOK = 1.0 / 20.0
"""Seconds per step when looking ahead; the physics is exact for any step."""
_HORIZON = 60
_SURELY = 1.0 - 1e-9
"""Slightly less than a whole step: the margin is far larger than rounding errors."""


class Ahead(NamedTuple):
    """One ball and the bricks, at a moment that was looked ahead to.

    arena: without paddles. flight: what `advance` is handed next; it decides nothing. hits: of the last step.
    """

    arena: Arena
    flight: FreeFlight | None
    hits: int


class Crossing(NamedTuple):
    """How a ball comes to the paddles' track.

    time: seconds until then. there: the ball and the bricks at that moment. broken: hits before, after each of which it is
    another flight.
    """

    time: float
    there: Ahead
    broken: int


def without_paddles(arena: Arena) -> Ahead:
    """The bricks of an arena, for `crossing`."""
    return Ahead(Arena((), arena.rings[PADDLES + 1 :], arena.layers[PADDLES + 1 :]), None, 0)


def crossing(bricks: Ahead, ball: Ball, track: float, speed: float) -> Crossing | None:
    """How the ball's centre comes to the track from inside; None beyond the horizon of 3 s.

    bricks: as they are now; the ball of this `Ahead` is left aside. track: world units from the centre.
    """
    now = with_ball(bricks, ball)
    broken = step = 0
    while step < _HORIZON:
        left = _time_to_radius(ball_of(now), track)
        if left <= LOOK:
            reached = flown(now, max(left, 0.0), speed)
            if reached.hits == 0:
                return Crossing(step * LOOK + left, reached, broken)
        else:
            free = min(int(min(free_seconds(now), left) / LOOK * _SURELY), _HORIZON - step)
            if free > 0:
                now, step = flown_freely(now, free), step + free
                continue
        now = flown(now, LOOK, speed)
        broken, step = broken + now.hits, step + 1
    return None


def with_ball(bricks: Ahead, ball: Ball) -> Ahead:
    """The ball among the bricks."""
    arena = Arena((ball,), bricks.arena.rings, bricks.arena.layers)
    # That nothing overlaps is all that is known; without that, `advance` would compute a free flight for the first step alone.
    return Ahead(arena, (arena, 0.0, ()) if all_freed(arena) is arena else None, 0)


def ball_of(ahead: Ahead) -> Ball:
    """The ball that is looked at."""
    return ahead.arena.balls[0]


def flown(ahead: Ahead, seconds: float, speed: float) -> Ahead:
    """So much later. speed: of the ball after a bounce."""
    done = advance(ahead.arena, seconds, speed, ahead.flight)
    return Ahead(done.arena, done.flight, len(done.hits))


def free_seconds(ahead: Ahead) -> float:
    """For how long nothing is touched, as far as that is known."""
    return 0.0 if ahead.flight is None else ahead.flight[1]


def flown_freely(ahead: Ahead, steps: int) -> Ahead:
    """Some steps of LOOK later, in which nothing is touched: the bits of `advance` in each.

    Calling `advance` for each of these steps would make a prediction a seventh slower.
    """
    (balls, rings, layers), flight, _ = ahead
    assert flight is not None, "nothing is known of the steps"
    _, seconds, turning = flight
    position, velocity, radius = balls[0]
    flown_once = velocity * LOOK
    for _ in range(steps):
        position += flown_once
    turned = [*rings]
    for k in turning:
        for _ in range(steps):
            turned[k] = turned[k].turned(LOOK)
    arena = Arena((Ball(position, velocity, radius),), tuple(turned), layers)
    return Ahead(arena, (arena, seconds - steps * LOOK, turning), 0)


def _time_to_radius(ball: Ball, radius: float) -> float:
    """Seconds of free flight until the centre crosses a radius outward: the later root of |p + v t| = radius."""
    p, v, _ = ball
    square = dot(v, v)
    root = square * radius * radius - cross(p, v) * cross(p, v)
    return (math.sqrt(root) - dot(p, v)) / square if root > 0.0 else 0.0


def pointer_to(angle: float) -> int:
    """An angle in pointer steps."""
    return int(normalize_angle(angle) / math.tau * POINTER_STEPS) % POINTER_STEPS
