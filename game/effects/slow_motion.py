"""Time runs slowly before the last brick of a level breaks: in the window alone. No tick is changed, only when it comes."""

from game.rules import Game, Phase, layers_left
from physics import time_of_impact

SLOWEST = 0.3
"""Share of its pace that time has then."""
_AHEAD = 0.22
"""Seconds of flight before the last brick in which time runs slowly."""


def pace(game: Game) -> float:
    """How fast time shall run: 1, or less while a ball is about to meet the last brick."""
    if game.phase != Phase.PLAYING or layers_left(game) != 1:
        return 1.0
    last = next(k for k, layers in enumerate(game.arena.layers) if 1 in layers and k != _shield(game))
    ring, layers = game.arena.rings[last], game.arena.layers[last]
    alone = tuple([max(left, 0) for left in layers])
    meets = [time_of_impact(ball, ring, _AHEAD, alone) is not None for ball in game.arena.balls]
    return SLOWEST if any(meets) else 1.0


def _shield(game: Game) -> int | None:
    """Index of the shield's ring, which is no brick."""
    return len(game.arena.rings) - 1 if game.ruleset.arcade else None
