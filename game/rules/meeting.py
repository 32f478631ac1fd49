"""Ball meets ball: each bounces off the other as off a moving surface, by the source's response."""

from game.rules.state import Event, EventKind, Game
from physics import Ball, collision_response, dot, length
from physics.vectors import unit


def met(game: Game, events: list[Event]) -> Game:
    """The game after every pair of balls that overlap and approach each other has bounced, in the order of the balls.

    Both of a pair leave by the same rule, from the velocities that they came with; afterwards they separate.
    """
    balls = list(game.arena.balls)
    if len(balls) < 2:
        return game
    changed = False
    for i, first in enumerate(balls):
        for j in range(i + 1, len(balls)):
            pair = _bounced(balls[i], balls[j], game.speed)
            if pair is not None:
                balls[i], balls[j] = pair
                changed = True
                events.append(Event(EventKind.BALLS_MET, position=(first.position + balls[j].position) * 0.5))
    return game._replace(arena=game.arena._replace(balls=tuple(balls))) if changed else game


def _bounced(one: Ball, other: Ball, speed: float) -> tuple[Ball, Ball] | None:
    """Two balls after they met; None where they are apart, separate already, or are in the same position."""
    between = one.position - other.position
    if length(between) > one.radius + other.radius or between == 0.0:
        return None
    normal = unit(between)
    if dot(one.velocity - other.velocity, normal) >= 0.0:
        return None
    velocity = collision_response(one.velocity, normal, other.velocity, 0.0, speed)
    other_velocity = collision_response(other.velocity, -normal, one.velocity, 0.0, speed)
    return Ball(one.position, velocity, one.radius), Ball(other.position, other_velocity, other.radius)
