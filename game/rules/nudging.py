"""Balls caught in a loop that meets no brick are turned a little, by chance."""

import math

from game.rules.chance import drawn
from game.rules.state import Event, EventKind, Game
from physics import Ball, direction, dot

IDLE_CONTACTS = 12
"""Contacts without a brick after which the balls are nudged."""
IDLE_AFTER_NUDGE = IDLE_CONTACTS - 3
"""Contacts that then count as made: three more without a brick, and the balls are nudged again."""
_NUDGE_LEAST = math.radians(5.0)
_NUDGE_MORE = math.radians(15.0)
"""Radians: a nudge turns the velocity by at least the first of them, and by up to the second more."""


def nudged(game: Game, events: list[Event]) -> Game:
    """The game whose balls are turned by a small random angle, if they have met no brick for too many contacts."""
    if game.idle < IDLE_CONTACTS or not game.arena.balls:
        return game
    chance, game = drawn(game)
    balls = tuple([nudged_ball(ball, chance) for ball in game.arena.balls])
    events.append(Event(EventKind.NUDGED, position=balls[0].position))
    return game._replace(arena=game.arena._replace(balls=balls), idle=IDLE_AFTER_NUDGE)


def nudged_ball(ball: Ball, chance: float) -> Ball:
    """The ball turned by a small angle, to either side. chance: in [0, 1)."""
    size = _NUDGE_LEAST + _NUDGE_MORE * abs(2.0 * chance - 1.0)
    turn = direction(size if chance >= 0.5 else -size)
    mirrored = turn.conjugate()
    velocity = complex(dot(mirrored, ball.velocity), dot(complex(turn.imag, turn.real), ball.velocity))
    return Ball(ball.position, velocity, ball.radius)
