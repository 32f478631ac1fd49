"""Balls that fly through bricks: the physics flies them as if no brick were there, and the rules break what they overlap.

Unbreakable sectors, paddles and the shield are there for the physics as always.
"""

from game.rules.power_up import PowerUp
from game.rules.scoring import with_broken
from game.rules.state import PADDLES, TICK, Event, Game
from physics import Arena, Ball, Hit, Ring, contact, in_band, length, nearest_slot

_ASIDE = 1
"""Slots to either side of the nearest one that are looked at, and more where the bricks are slim."""


def is_piercing(game: Game) -> bool:
    """Whether balls fly through bricks."""
    return game.ruleset.arcade and game.power(PowerUp.PIERCE) is not None


def without_bricks(arena: Arena) -> Arena:
    """The arena whose bricks are gone, for the physics to fly in."""
    layers = arena.layers
    wall = [tuple([min(left, 0) for left in ring]) for ring in layers[PADDLES + 1 : -1]]
    return arena._replace(layers=(layers[PADDLES], *wall, layers[-1]))


def with_bricks(flown: Arena, before: Arena) -> Arena:
    """The arena after such a flight, with all that was there before it. A shield that was hit is taken away by the rules."""
    return flown._replace(layers=before.layers)


def pierced(game: Game, events: list[Event]) -> Game:
    """The game after every brick that a ball overlaps was broken, with all its layers."""
    for index, ball in enumerate(game.arena.balls):
        distance = length(ball.position)
        for k in range(PADDLES + 1, len(game.arena.rings) - 1):
            if in_band(distance, ball.radius, game.arena.rings[k]):
                game = _pierced_ring(game, index, k, events)
    return game


def _pierced_ring(game: Game, index: int, k: int, events: list[Event]) -> Game:
    """The game after a ball broke what it overlaps of one ring."""
    ball, ring = game.arena.balls[index], game.arena.rings[k]
    for slot in _slots_near(ball, ring):
        layers = game.arena.layers[k][slot]
        found = contact(ball, ring, slot) if layers > 0 else None
        if found is not None and found.gap < 0.0:
            hit = Hit(TICK, index, k, slot, found, ball.velocity, ball.velocity, 0)
            game = with_broken(game, hit, layers, events)
            slots = game.arena.layers[k]
            left = (*slots[:slot], 0, *slots[slot + 1 :])
            changed = (*game.arena.layers[:k], left, *game.arena.layers[k + 1 :])
            game = game._replace(arena=game.arena._replace(layers=changed))
    return game


def _slots_near(ball: Ball, ring: Ring) -> list[int]:
    """The slots that a ball in the ring's band may overlap, in order, none twice."""
    nearest = nearest_slot(ring, ball.theta())
    inside = max(length(ball.position), ball.radius)
    pitch = 2.0 * ring.half_angle
    aside = min(int(2.0 * ball.radius / (inside * pitch)) + _ASIDE + 1, ring.count // 2)
    return sorted({(nearest + step) % ring.count for step in range(-aside, aside + 1)})
