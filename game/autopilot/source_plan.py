"""How the autopilot of the source's rules meets a ball: functions of numbers, balls and rings alone.

They are compiled as they stand, too, for many games at once (`tools/autopilot`).
"""

import math
from typing import NamedTuple

from game.autopilot.prediction import LOOK, Ahead, ball_of, crossing
from game.rules import TICK
from physics import Ball, Ring, angle_of, collision_response, direction, length, normalize_angle, signed_difference
from physics.vectors import quarter_turn

_CUT_TIME = 0.35
"""Seconds of steady paddle motion before a hit, so that its friction turns the ball."""
_CUTS = (0.0, 0.9, -0.9, 0.5, -0.5)
"""Paddle motions to choose from, as fractions of the top speed."""
_SERVE_WAIT = 30
_SERVE_SPREAD = 450
_COVER = 0.7
"""Fraction of a paddle's half angle within which a hit counts as safe."""


class Plan(NamedTuple):
    """Where and when the ball meets the paddles' track, and how the paddle shall move then.

    tick: of the game. bearing: radians. spin: rad/s.
    """

    tick: int
    bearing: float
    spin: float


def planned(bricks: Ahead, paddles: Ring, ball: Ball, tick: int, speed: float, top: float) -> Plan | None:
    """How to meet the ball when it next comes to the paddles' track; None if it does not within the horizon.

    tick: of the game, now. speed: of the ball. top: of the paddles, rad/s.
    """
    found = crossing(bricks, ball, paddles.inner_radius - ball.radius, speed)
    if found is None:
        return None
    bearing = angle_of(ball_of(found.there).position)
    meeting = tick + int(found.time / TICK)
    best, most = 0.0, -math.inf
    if found.broken == 0:  # else the ball turns before it comes; there will be a better plan then
        for cut in _CUTS:
            spin = cut * top
            if _reachable(paddles, bearing, spin, top, found.time):
                worth = _worth(found.there, paddles, spin, speed, top)
                if worth > most:
                    best, most = spin, worth
    return Plan(meeting, bearing, best)


def wanted_angle(plan: Plan, tick: int) -> float:
    """Where the plan wants a paddle in a tick, radians: its steady motion ends at the meeting."""
    if plan.spin == 0.0:
        return plan.bearing
    return plan.bearing - plan.spin * min(max(0.0, (plan.tick - tick) * TICK), _CUT_TIME)


def outer(ball: Ball, other: Ball) -> Ball:
    """The one of two balls that is nearer to the rim; the first where neither is."""
    return other if length(other.position) > length(ball.position) else ball


def serve_wait(seed: int, lives: int, number: int, score: int) -> int:
    """Ticks to wait before a serve: differs from seed to seed and serve to serve. number: of the level."""
    # The remainder of a seed, since compiled code has 64 bits.
    return _SERVE_WAIT + (seed % _SERVE_SPREAD * 97 + lives * 41 + number * 23 + score) % _SERVE_SPREAD


def _reachable(paddles: Ring, bearing: float, spin: float, top: float, time: float) -> bool:
    """Whether a paddle can be where its steady motion towards the bearing has to start."""
    lead = min(time, _CUT_TIME)
    start = normalize_angle(bearing - spin * lead)
    away = math.inf
    for slot in range(paddles.count):
        away = min(away, abs(signed_difference(start, paddles.angle(slot))))
    slack = _COVER * paddles.half_angle if spin == 0.0 else 0.0
    return away <= top * (time - lead) + slack


def _worth(there: Ahead, paddles: Ring, spin: float, speed: float, top: float) -> float:
    """How good a return is: bricks it breaks, less what the next catch asks of the paddles beyond their reach."""
    ball = ball_of(there)
    normal = direction(angle_of(ball.position) + math.pi)
    surface = quarter_turn(ball.position) * spin
    velocity = collision_response(ball.velocity, normal, surface, paddles.friction, speed)
    inside = Ball(ball.position + normal * (LOOK * speed * 0.01), velocity, ball.radius)
    returned = crossing(there, inside, paddles.inner_radius - ball.radius, speed)
    if returned is None:
        return 0.0
    turn = abs(signed_difference(angle_of(ball_of(returned.there).position), angle_of(ball.position)))
    pitch = math.tau / paddles.count
    away = abs(turn - pitch * round(turn / pitch))
    miss = max(0.0, away - _COVER * paddles.half_angle - top * returned.time)
    return min(returned.broken, 4) - 10.0 * miss + 0.01 * abs(spin)
