"""The rules: what a tick of the game does with the player's controls and the physics' hits.

Pure: a game and the controls of one tick in, the next game and its events out. Nothing here knows a window. There are two
rulesets: the source's, and the arcade's with power-ups and all else that makes a game (`Ruleset`).
"""

from game.rules.power_up import HARMFUL, LASTING, ActivePower, Drop, PowerUp
from game.rules.ruleset import LIVES, SOURCE_RULES, Difficulty, Handicap, Ruleset
from game.rules.scoring import EXTRA_LIFE_POINTS, par, rank_of
from game.rules.serving import aim
from game.rules.shape import shield_layers
from game.rules.state import (
    BEST_COMBO,
    PADDLES,
    POINTER_STEPS,
    TICK,
    Advance,
    Controls,
    Event,
    EventKind,
    Game,
    HeldBall,
    LevelResult,
    Phase,
    Rank,
    Side,
    Statistics,
    Tally,
    Ticked,
    held_balls,
    layers_left,
    paddle_ring,
    paddle_rings,
    player_at,
)
from game.rules.ticking import continued, new_game, tick
from game.rules.versus import winner

__all__ = [
    "BEST_COMBO",
    "EXTRA_LIFE_POINTS",
    "HARMFUL",
    "LASTING",
    "LIVES",
    "PADDLES",
    "POINTER_STEPS",
    "SOURCE_RULES",
    "TICK",
    "ActivePower",
    "Advance",
    "Controls",
    "Difficulty",
    "Drop",
    "Event",
    "EventKind",
    "Game",
    "Handicap",
    "HeldBall",
    "LevelResult",
    "Phase",
    "PowerUp",
    "Rank",
    "Ruleset",
    "Side",
    "Statistics",
    "Tally",
    "Ticked",
    "aim",
    "continued",
    "held_balls",
    "layers_left",
    "new_game",
    "paddle_ring",
    "paddle_rings",
    "par",
    "player_at",
    "rank_of",
    "shield_layers",
    "tick",
    "winner",
]
