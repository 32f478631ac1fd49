"""A best run that the desktop has stored: the files, and the game tick by tick."""

from game.autopilot import Autopilot
from game.kept.progress import Best, record_name
from game.kept.store import Kept
from game.rules import Phase, Ruleset, new_game, tick


def stored_run(folder, levels, ticks=1300, *, name=None):
    """Store a game that the autopilot has begun as the best run of the first level; the games after its first serve.

    name: under which the best is stored, instead of the level's.
    """
    kept, pilot, game = Kept(folder), Autopilot(), new_game(levels, 5, Ruleset())
    played = []
    for _ in range(ticks):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        kept.games(controls, game)
        if played or game.phase == Phase.PLAYING:
            played.append(game)
    kept.level_done(Best(name or record_name(levels[0]), "normal", 5))
    kept.game_done()
    return played
