"""Short games, played and recorded."""

from game.levels import classic
from game.replays.file import Recorder
from game.rules import new_game, tick

TICKS = 1500


def recorded(player, ticks=TICKS):
    """A short recorded game, and the game at its end."""
    levels = classic()[3:]
    game, recorder = new_game(levels, 11), Recorder(levels, 11)
    for _ in range(ticks):
        controls = player.controls(game)
        game = tick(game, controls).game
        recorder.add(controls, game)
    return recorder.recording(), game
