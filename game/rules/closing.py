"""No long wait for the next brick: after some seconds without one, a paddle's hit helps to aim at one that is in reach.

The help is bounded: by an angle that begins small and grows with the wait. It is part of the rules, so a replay has it.
"""

import math
from typing import NamedTuple

from game.rules.state import PADDLES, TICK, Game
from physics import Ball, angle_of, direction, length, signed_difference, time_of_impact

CLOSING_TICKS = 840
"""Ticks in play without a brick after which the help begins: 3.5 s."""
_LEAST, _MORE, _MOST = math.radians(15.0), math.radians(15.0), math.radians(60.0)
"""Radians: the help's bound at first, what every second adds to it, and where that ends."""
_CANDIDATES = 12
"""Bricks that are looked at, those that need the least turn first."""
_STEEPEST = math.radians(70.0)
"""Radians from the straight line to the centre that the help does not exceed."""
_LONGEST_FLIGHT = 4.0
"""Seconds."""


class _Brick(NamedTuple):
    """A brick to aim at. turn: that it takes, radians; ring and slot put equal ones in order."""

    size: float
    ring: int
    slot: int
    turn: float


def closing_limit(game: Game) -> float:
    """The most that a paddle's hit is turned towards a brick, radians; 0 while the last brick is not long ago."""
    if game.waited < CLOSING_TICKS:
        return 0.0
    return min(_LEAST + _MORE * (game.waited - CLOSING_TICKS) * TICK, _MOST)


def closing_turn(game: Game, ball: Ball, inward: complex) -> float:
    """Radians, counter-clockwise, that turn a ball towards a brick; 0 where it needs no help or none may be given."""
    limit = closing_limit(game)
    if limit == 0.0 or _meets_a_brick(game, ball):
        return 0.0
    for brick in sorted(_bricks(game, ball, inward, limit))[:_CANDIDATES]:
        heading = direction(angle_of(ball.velocity) + brick.turn) * game.speed
        if _meets_a_brick(game, Ball(ball.position, heading, ball.radius)):
            return brick.turn
    return 0.0


def _bricks(game: Game, ball: Ball, inward: complex, limit: float) -> list[_Brick]:
    """The bricks that a turn within the limit aims at, where they will be when the ball gets there."""
    found = []
    now, normal = angle_of(ball.velocity), angle_of(inward)
    _, rings, layers = game.arena
    for k in range(PADDLES + 1, len(rings) - 1):
        ring = rings[k]
        for slot, left in enumerate(layers[k]):
            if left <= 0:
                continue
            angle = ring.angle(slot)
            away = length(direction(angle) * ring.radius - ball.position) / game.speed
            there = direction(angle + ring.spin * away) * ring.radius - ball.position
            heading = angle_of(there)
            turn = signed_difference(heading, now)
            if abs(turn) <= limit and abs(signed_difference(heading, normal)) <= _STEEPEST:
                found.append(_Brick(abs(turn), k, slot, turn))
    return found


def _meets_a_brick(game: Game, ball: Ball) -> bool:
    """Whether the first thing that a ball meets on its straight flight is a brick that can break."""
    first, breaks = _LONGEST_FLIGHT, False
    _, rings, layers = game.arena
    for k in range(PADDLES, len(rings)):
        impact = time_of_impact(ball, rings[k], _LONGEST_FLIGHT, layers[k])
        if impact is not None and impact.time < first:
            first, breaks = impact.time, layers[k][impact.slot] > 0 and PADDLES < k < len(rings) - 1
    return breaks
