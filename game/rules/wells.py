"""Gravity wells: they turn the flight of balls near them, and leave their speed as it is.

A ball leaves every well again. With p its position from the well's middle and v its velocity, the second derivative of |p|^2
/ 2 is v^2 + p . a, where a is the pull across the flight. The pull falls evenly from `strength` at the middle to 0 at
`reach`, so |p . a| is at most strength reach / 4. The level format keeps that below v^2: the square of the distance is convex
in time.
"""

import math

from game.rules.speed import at_speed
from game.rules.state import TICK, Game
from physics import Ball, direction, length


def pulled(game: Game) -> Game:
    """The game after one tick of its wells' pull."""
    if not game.level.wells:
        return game
    balls = tuple([_pulled(game, ball) for ball in game.arena.balls])
    if all([new is old for new, old in zip(balls, game.arena.balls, strict=True)]):
        return game
    return game._replace(arena=game.arena._replace(balls=balls))


def _pulled(game: Game, ball: Ball) -> Ball:
    """A ball after one tick of pull; the ball itself where it is out of reach."""
    change = 0j
    for well in game.level.wells:
        to_middle = direction(math.radians(well.angle)) * well.distance - ball.position
        away = length(to_middle)
        if 0.0 < away < well.reach:
            pull: float = well.strength * (1.0 - away / well.reach)
            change += to_middle * (pull * TICK / away)
    if change == 0.0:
        return ball
    return Ball(ball.position, at_speed(ball.velocity + change, game.speed), ball.radius)
