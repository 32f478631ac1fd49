"""Games of the autopilot, played for many tests once."""

from functools import cache

from game.autopilot import Autopilot
from game.effects import Effects, after
from game.levels import classic
from game.rules import new_game, tick
from game.scene import still


@cache
def game_after(level, ticks, seed=3):
    """The last tick of a game from a level on, counted from 0, and its effects."""
    game, pilot, effects = new_game(classic()[level:], seed), Autopilot(), Effects()
    done = still(game)
    for _ in range(ticks):
        done = tick(done.game, pilot.controls(done.game))
        effects = after(effects, done)
    return done, effects
