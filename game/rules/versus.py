"""Two players against each other: one paddle each, in opposite halves of the ring, and points and lives of their own.

Points go to the player whose paddle was hit last; a drop's to the one who catches it, who also has what it does to paddles and
at the rim. The last ball in play costs a life of the player through whose half it leaves, and gives points to the other; who
has no life left has lost.
"""

import math

from game.rules.ruleset import Ruleset
from game.rules.state import PADDLES, TICK, Game, Side, paddle_rings, player_at
from physics import Ring, signed_difference

LOST_BALL_POINTS = 100
"""Points for the player whose opponent loses a ball that costs a life."""
_MIDDLES = (1.5 * math.pi, 0.5 * math.pi)
"""Radians: the middle of each player's half."""
_MARGIN = 1e-6
"""Radians: how far a paddle stays away from the border of the halves."""
_WIDEST = math.radians(36.0)
"""Radians: half a paddle at most, before power-ups."""
_SHIELD_GAP = 1e-3
"""Radians: half of what is left open between the two halves of the shield, so that their ends do not coincide."""


def sides(ruleset: Ruleset) -> tuple[Side, ...]:
    """Both players at the start; none where there is one."""
    return (Side(0, ruleset.handicap.lives),) * 2 if ruleset.versus else ()


def own_half_angle(half_angle: float, count: int) -> float:
    """Half the angle of each player's paddle, radians: half as much as all paddles of the level together cover."""
    return min(half_angle * count / 2.0, _WIDEST)


def paddle_of(ring: Ring, player: int) -> Ring:
    """A player's paddle, made of the level's, in the middle of the half."""
    return Ring(
        ring.radius, ring.half_width, own_half_angle(ring.half_angle, ring.count), 1, _MIDDLES[player], 0.0, ring.friction
    )


def half_shields(shield: Ring) -> Ring:
    """The shield as two sectors, each player's over their half; the slot's number is the player's."""
    return shield._replace(half_angle=math.pi / 2.0 - _SHIELD_GAP, count=2, phase=_MIDDLES[0])


def room(ring: Ring, player: int) -> tuple[float, float]:
    """Radians that a paddle may turn clockwise, a number below 0, and counter-clockwise, and stay in its half."""
    offset = signed_difference(ring.phase, _MIDDLES[player])
    limit = math.pi / 2.0 - ring.half_angle - _MARGIN
    return min(-limit - offset, 0.0), max(limit - offset, 0.0)


def spin_within(ring: Ring, player: int, spin: float) -> float:
    """A spin cut to what keeps a paddle in its half in the next tick, rad/s."""
    least, most = room(ring, player)
    return min(max(spin, least / TICK), most / TICK)


def fits(ring: Ring, player: int) -> bool:
    """Whether a paddle lies in its half."""
    return abs(signed_difference(ring.phase, _MIDDLES[player])) <= math.pi / 2.0 - ring.half_angle


def player_of(ring: int) -> int:
    """Whose paddle a ring is."""
    return 0 if ring == PADDLES else 1


def served_from(game: Game) -> int:
    """Index of the ring whose paddle the next ball is served from."""
    return paddle_rings(game)[game.server] if game.ruleset.versus else PADDLES


def with_points(game: Game, points: int, player: int | None = None) -> Game:
    """The game after points, which its score has already, were given to a player; to the last who hit a ball, if None."""
    if not game.sides or points == 0:
        return game
    who = game.last_player if player is None else player
    changed = [side._replace(score=side.score + points * (index == who)) for index, side in enumerate(game.sides)]
    return game._replace(sides=tuple(changed))


def with_lives(game: Game, more: int, player: int) -> Game:
    """The game after a player has gained lives, or lost them."""
    changed = [side._replace(lives=side.lives + more * (index == player)) for index, side in enumerate(game.sides)]
    return game._replace(sides=tuple(changed), lives=min([side.lives for side in changed]))


def with_lost_ball(game: Game, position: complex) -> Game:
    """The game after the last ball in play left at a position: its half's player serves the next."""
    loser = player_at(position)
    game = with_lives(game, -1, loser)._replace(score=game.score + LOST_BALL_POINTS, server=loser)
    return with_points(game, LOST_BALL_POINTS, 1 - loser)


def winner(game: Game) -> int | None:
    """The player who is ahead, or has won: who has lives left, then who has more points; None where that is nobody."""
    if not game.sides:
        return None
    first, second = [(side.lives > 0, side.score) for side in game.sides]
    return None if first == second else int(second > first)
