"""A wall that grows again as long as what it guards is there: the boss of a chapter."""

from game.rules.state import PADDLES, TICK, Event, EventKind, Game, Phase
from physics import Ball, contact, direction, in_band, length

_ROOM = 0.5
"""Radii of the ball: so far from every ball a brick grows."""


def play_ticks(game: Game) -> int:
    """Ticks of the level with balls in play, those since the last serve with them."""
    return game.statistics.level.ticks + (game.phase_tick if game.phase == Phase.PLAYING else 0)


def regrown(game: Game, events: list[Event]) -> Game:
    """The game after the bricks that are due have grown, or after all of them fell because what they guard is broken."""
    growing = [k for k, ring in enumerate(game.level.rings, PADDLES + 1) if ring.regrow > 0.0]
    if not growing:
        return game
    if not any([left > 0 for k in _others(game, growing) for left in game.arena.layers[k]]):
        return _fallen(game, growing, events)
    ticks = play_ticks(game)
    for k in growing:
        period = max(round(game.level.rings[k - 1].regrow / TICK), 1)
        if ticks > 0 and ticks % period == 0:
            game = _with_next_brick(game, k, events)
    return game


def reversed_rings(game: Game) -> Game:
    """The game after the rings that are due have turned round."""
    ticks = play_ticks(game)
    for k, spec in enumerate(game.level.rings, PADDLES + 1):
        if spec.reverse > 0.0 and ticks > 0 and ticks % max(round(spec.reverse / TICK), 1) == 0:
            rings = game.arena.rings
            rings = (*rings[:k], rings[k].steered(-rings[k].spin), *rings[k + 1 :])
            game = game._replace(arena=game.arena._replace(rings=rings))
    return game


def _others(game: Game, growing: list[int]) -> list[int]:
    """The rings of the wall that do not grow."""
    return [k for k in range(PADDLES + 1, len(game.level.rings) + 1) if k not in growing]


def _fallen(game: Game, growing: list[int], events: list[Event]) -> Game:
    """The game without the bricks that would have grown again."""
    layers = list(game.arena.layers)
    for k in growing:
        layers[k] = tuple([min(left, 0) for left in layers[k]])
    if tuple(layers) == game.arena.layers:
        return game
    events.append(Event(EventKind.CORE_BROKEN))
    return game._replace(arena=game.arena._replace(layers=tuple(layers)))


def _with_next_brick(game: Game, k: int, events: list[Event]) -> Game:
    """The game with one layer on the first missing brick of a ring that no ball is near."""
    ring, slots, full = game.arena.rings[k], game.arena.layers[k], game.level.rings[k - 1].slots()
    for slot, left in enumerate(slots):
        if left == 0 and full[slot] > 0 and not any([_is_near(game, ball, k, slot) for ball in game.arena.balls]):
            grown = (*slots[:slot], 1, *slots[slot + 1 :])
            layers = (*game.arena.layers[:k], grown, *game.arena.layers[k + 1 :])
            position = direction(ring.angle(slot)) * ring.radius
            events.append(Event(EventKind.BRICK_REGROWN, position=position, sector=(k, slot)))
            return game._replace(arena=game.arena._replace(layers=layers))
    return game


def _is_near(game: Game, ball: Ball, k: int, slot: int) -> bool:
    """Whether a ball is in the way of a brick."""
    ring = game.arena.rings[k]
    room = _ROOM * ball.radius
    return in_band(length(ball.position), ball.radius + room, ring) and contact(ball, ring, slot).gap <= room
