"""The arithmetic of the rules: functions of numbers, which the compiled environments run as they stand."""

import math
import random

from game.rules import BEST_COMBO, POINTER_STEPS, TICK
from physics import Ball, Ring, direction, dot, signed_difference

LIVES = 3
IDLE_CONTACTS = 12
"""Contacts without a brick after which the balls are nudged."""
_IDLE_STEP = 3
"""Further contacts without a brick until the next nudge."""
_POINTS_PER_BRICK = 10
"""Points for a layer, times the combo."""
_POINTS_PER_LIFE = 100
"""Points for every life that is left when a level is cleared."""
_AIM_RANGE = math.radians(55.0)
"""Radians: the most that a serve is aimed off the centre, to either side."""
_AIM_PERIOD = 480
"""Ticks of one full swing of the aim."""
_SERVE_GAP = 1e-6
"""Between the ball to be served and its paddle, in radii of the ball: it must not touch."""
_NUDGE_LEAST = math.radians(5.0)
_NUDGE_MORE = math.radians(15.0)
"""Radians: a nudge turns the velocity by at least the first of them, and by up to the second more."""


def keyed_spin(spin: float, turn: int, top: float, change: float) -> float:
    """The paddles' spin after a tick of keys: towards full speed, by `change` at most. rad/s."""
    wanted = top * turn
    return min(max(wanted, spin - change), spin + change)


def spin_to_pointer(paddles: Ring, pointer: int, top: float) -> float:
    """Spin that brings the nearest paddle to the pointer within one tick, no faster than the top speed. rad/s."""
    wanted = pointer * (math.tau / POINTER_STEPS)
    nearest = signed_difference(wanted, paddles.angle(0))
    for slot in range(1, paddles.count):
        offset = signed_difference(wanted, paddles.angle(slot))
        if abs(offset) < abs(nearest):
            nearest = offset
    return min(max(nearest / TICK, -top), top)


def aim_angle(phase_tick: int) -> float:
    """Angle of the serve off the straight line to the centre, radians: swings to and fro; one full swing takes 2 s."""
    cycle = (phase_tick % _AIM_PERIOD) / _AIM_PERIOD
    return _AIM_RANGE * (4.0 * abs(cycle - 0.5) - 1.0) * -1.0


def served_ball(paddles: Ring, ball_radius: float, speed: float, aim: float) -> Ball:
    """The ball resting on paddle 0, its velocity where the serve is aimed. aim: radians off the line to the centre."""
    angle = paddles.angle(0)
    distance = paddles.inner_radius - ball_radius * (1.0 + _SERVE_GAP)
    velocity = direction(angle + math.pi + aim) * speed
    return Ball(direction(angle) * distance, velocity, ball_radius)


def nudged_ball(ball: Ball, chance: float) -> Ball:
    """The ball turned by 5 to 20 degrees, to either side. chance: in [0, 1)."""
    size = _NUDGE_LEAST + _NUDGE_MORE * abs(2.0 * chance - 1.0)
    turn = direction(size if chance >= 0.5 else -size)
    mirrored = turn.conjugate()
    velocity = complex(dot(mirrored, ball.velocity), dot(complex(turn.imag, turn.real), ball.velocity))
    return Ball(ball.position, velocity, ball.radius)


def points_for_brick(combo: int) -> int:
    """Points for the combo's latest brick."""
    return _POINTS_PER_BRICK * min(combo, BEST_COMBO)


def points_for_lives(lives: int) -> int:
    """Points for a cleared level."""
    return _POINTS_PER_LIFE * lives


def idle_after_nudge() -> int:
    """Contacts that count as made without a brick after a nudge."""
    return IDLE_CONTACTS - _IDLE_STEP


def nudge_chance(seed: int, draws: int) -> float:
    """Random number `draws` of a seed, in [0, 1)."""
    return random.Random((seed << 32) + draws).random()
