"""Power-ups on their way: a broken brick leaves one by chance, it drifts outward, a paddle catches it or it is lost."""

from game.level_format.specs import DropKind
from game.rules.chance import drawn
from game.rules.power_up import Drop, PowerUp
from game.rules.state import TICK, Event, EventKind, Game, paddle_rings, player_at
from game.rules.versus import with_points
from physics import Ball, Ring, angle_of, contact, in_band, length, nearest_slot
from physics.vectors import unit

_DRIFT = 0.2
"""Ground radii per second."""
DROP_RADIUS = 0.035
"""In radii of the ground: how near a drop must come to a paddle to be caught."""
_MOST = 3
"""Drops on their way at the same time; while there are as many, no brick leaves another."""
_OFTEN = 3
"""How often every other power-up comes for one life."""
_CATCH_POINTS = 50
"""Points for catching a drop, whatever it is."""


def with_drop(game: Game, position: complex, events: list[Event]) -> Game:
    """The game after a brick at a position was broken: by chance it leaves a drop, and chance says which."""
    spec = game.level.drops
    likely = spec.chance * game.ruleset.handicap.drop_chance
    if likely == 0.0 or len(game.drops) >= _MOST or position == 0.0:
        return game
    chance, game = drawn(game)
    if chance >= likely:
        return game
    chance, game = drawn(game)
    kind = _kind_of(chance, spec.kinds)
    drop = Drop(kind, position, unit(position) * (_DRIFT * game.level.ground_radius))
    events.append(Event(EventKind.DROP_RELEASED, position=position, power=kind))
    return game._replace(drops=(*game.drops, drop))


def _kind_of(chance: float, names: list[DropKind]) -> PowerUp:
    """The power-up that a random number in [0, 1) chooses from names: each as likely as another, but for the rare life."""
    kinds = [PowerUp[name.upper()] for name in names]
    rest = chance * (_OFTEN * len(kinds) - (_OFTEN - 1) * (PowerUp.LIFE in kinds))
    for kind in kinds:
        rest -= 1 if kind == PowerUp.LIFE else _OFTEN
        if rest < 0.0:
            return kind
    return kinds[-1]


def drifted(game: Game, events: list[Event]) -> tuple[Game, list[Drop]]:
    """The game after its drops have drifted for a tick, and those that a paddle has caught."""
    if not game.drops:
        return game, []
    radius = DROP_RADIUS * game.level.ground_radius
    paddles = [game.arena.rings[k] for k in paddle_rings(game)]
    going: list[Drop] = []
    caught: list[Drop] = []
    for drop in game.drops:
        moved = drop._replace(position=drop.position + drop.velocity * TICK)
        if any([_touches(Ball(moved.position, moved.velocity, radius), ring) for ring in paddles]):
            caught.append(moved)
            events.append(Event(EventKind.DROP_CAUGHT, points=_CATCH_POINTS, position=moved.position, power=drop.kind))
        elif length(moved.position) - radius > game.level.ground_radius:
            events.append(Event(EventKind.DROP_LOST, position=moved.position, power=drop.kind))
        else:
            going.append(moved)
    game = game._replace(drops=tuple(going), score=game.score + _CATCH_POINTS * len(caught))
    for drop in caught:
        game = with_points(game, _CATCH_POINTS, player_at(drop.position))
    return game, caught


def _touches(drop: Ball, paddles: Ring) -> bool:
    """Whether a drop, as a disc, touches a paddle."""
    if not in_band(length(drop.position), drop.radius, paddles):
        return False
    return contact(drop, paddles, nearest_slot(paddles, angle_of(drop.position))).gap <= 0.0
