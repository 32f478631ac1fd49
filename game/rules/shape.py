"""The arena of the arcade rules: paddles of another width, and a shield at the rim.

Both change only at a moment when no ball is where new material comes to be.
"""

import math

from game.rules.power_up import PowerUp
from game.rules.state import PADDLES, Game, paddle_rings
from game.rules.versus import fits, half_shields, own_half_angle, paddle_of
from physics import PERMANENT, Arena, Ball, Ring, contact, in_band, length

_WIDE, _NARROW = 1.4, 0.7
"""Factors of the paddles' half angle."""
_WIDEST = 0.8
"""Share of the circle that paddles may cover, unless the level's own cover more: there are always gaps between them."""
_SHIELD_DISTANCE, _SHIELD_HALF_WIDTH = 0.01, 0.012
"""From the paddles' outer radius to the shield, and half its thickness, in radii of the ground."""


def arcade_arena(game: Game) -> Arena:
    """The level's arena, with paddles as the difficulty wants them and the shield as its last ring, without layers."""
    level = game.level
    balls, rings, layers = level.arena()
    outer = rings[PADDLES].outer_radius
    half_width = _SHIELD_HALF_WIDTH * level.ground_radius
    shield = Ring(outer + _SHIELD_DISTANCE * level.ground_radius + half_width, half_width, math.pi, 1)
    if game.ruleset.versus:
        both = [paddle_of(rings[PADDLES], player)._replace(half_angle=wanted_half_angle(game, player)) for player in range(2)]
        fixed, wall = (PERMANENT,), layers[PADDLES + 1 :]
        return Arena(balls, (both[0], *rings[PADDLES + 1 :], both[1], half_shields(shield)), (fixed, *wall, fixed, (0, 0)))
    paddles = rings[PADDLES]._replace(half_angle=wanted_half_angle(game))
    return Arena(balls, (paddles, *rings[PADDLES + 1 :], shield), (*layers, (0,)))


def wanted_half_angle(game: Game, player: int = 0) -> float:
    """Half the angle of a paddle as difficulty and power-ups want it, radians; the paddles leave gaps between them.

    player: whose paddle, where two play against each other.
    """
    spec = game.level.paddles
    own, count = math.radians(spec.half_angle), spec.count
    if game.ruleset.versus:
        own, count = own_half_angle(own, count), 2
    factor = game.ruleset.handicap.paddle_width
    if game.power(PowerUp.WIDE, player) is not None:
        factor *= _WIDE
    if game.power(PowerUp.NARROW, player) is not None:
        factor *= _NARROW
    return min(own * factor, max(own, _WIDEST * math.pi / count))


def shield_layers(game: Game, player: int = 0) -> int:
    """Layers of a player's shield: 1 while there is one. player: as in `ActivePower`."""
    return game.arena.layers[-1][player] if game.ruleset.arcade else 0


def shaped(game: Game) -> Game:
    """The game with paddles and shield as its power-ups want them, as far as no ball is in the way."""
    for player, k in enumerate(paddle_rings(game)):
        paddles, half_angle = game.arena.rings[k], wanted_half_angle(game, player)
        if half_angle != paddles.half_angle:
            resized = paddles._replace(half_angle=half_angle)
            if half_angle < paddles.half_angle or _has_room(game, resized, player):
                game = _with_paddles(game, resized, k)
    before = game.arena.layers[-1]
    layers = tuple([0 if game.power(PowerUp.SHIELD, player) is None else 1 for player in range(len(before))])
    if layers != before:
        shield = game.arena.rings[-1]
        if any([in_band(length(ball.position), ball.radius, shield) for ball in game.arena.balls]):
            layers = tuple([min(now, wanted) for now, wanted in zip(before, layers, strict=True)])
        game = game._replace(arena=game.arena._replace(layers=(*game.arena.layers[:-1], layers)))
    return game


def _has_room(game: Game, paddles: Ring, player: int) -> bool:
    """Whether larger paddles overlap no ball and, where two players have one each, stay in their half."""
    if game.ruleset.versus and not fits(paddles, player):
        return False
    return not any([_overlaps(ball, paddles) for ball in game.arena.balls])


def _with_paddles(game: Game, paddles: Ring, k: int) -> Game:
    """The game with other paddles in a ring. A ball that sticks to one stays on it."""
    reach = paddles.half_angle
    held = tuple([ball._replace(offset=min(max(ball.offset, -reach), reach)) if ball.ring == k else ball for ball in game.held])
    rings = (*game.arena.rings[:k], paddles, *game.arena.rings[k + 1 :])
    return game._replace(held=held, arena=game.arena._replace(rings=rings))


def _overlaps(ball: Ball, ring: Ring) -> bool:
    """Whether a ball touches or overlaps any sector of a ring."""
    if not in_band(length(ball.position), ball.radius, ring):
        return False
    return any([contact(ball, ring, slot).gap <= 0.0 for slot in range(ring.count)])
