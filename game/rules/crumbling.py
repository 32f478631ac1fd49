"""No wait without an end: a brick loses a layer by itself when none was hit for long.

The help of `game.rules.closing` aims, but cannot reach what steel hides or a well turns the ball away from.
"""

from game.rules.state import PADDLES, TICK, Event, EventKind, Game
from physics import PERMANENT, direction, length

CRUMBLING_TICKS = round(9.0 / TICK)
"""Ticks in play without a brick after which one crumbles."""


def crumbled(game: Game, events: list[Event]) -> Game:
    """The game after a layer of the stack nearest to a ball has crumbled, if it is time for that. It gives no points.

    Walls that grow again are left alone as long as there is another brick.
    """
    balls = game.arena.balls
    if game.waited < CRUMBLING_TICKS or not balls:
        return game
    position = balls[0].position
    found = [
        (game.level.rings[k - 1].regrow > 0.0, length(direction(ring.angle(slot)) * ring.radius - position), k, slot)
        for k, ring in enumerate(game.arena.rings[: len(game.level.rings) + 1])
        if k > PADDLES
        for slot, left in enumerate(game.arena.layers[k])
        if left not in {0, PERMANENT}
    ]
    if not found:
        return game
    _, _, k, slot = min(found)
    ring, slots = game.arena.rings[k], game.arena.layers[k]
    layers = (*game.arena.layers[:k], (*slots[:slot], slots[slot] - 1, *slots[slot + 1 :]), *game.arena.layers[k + 1 :])
    events.append(Event(EventKind.BRICK_CRUMBLED, position=direction(ring.angle(slot)) * ring.radius, sector=(k, slot)))
    return game._replace(arena=game.arena._replace(layers=layers), waited=0, idle=0)
