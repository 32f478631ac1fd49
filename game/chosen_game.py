"""The game that the command line asks for, played without a window."""

from collections import deque
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from game.chosen_physics import SWEPT, ChosenPhysics
from game.effects import LONGEST
from game.headless import autopilot_game, result_line
from game.input.players import Players
from game.levels import Level
from game.picture_file import PlayedGame, picture_folders, save_picture
from game.replays import file as replay
from game.rules import Ruleset, Ticked
from game.student.functions_file import FunctionsFile
from game.system.ending import deferred
from game.system.errors import BadInputError
from game.system.files import free_path
from game.system.output import print_error, print_line

_DEMO_TICKS = 240 * 20


class ChosenGame(NamedTuple):
    """The game that the options ask for.

    ruleset: None where they say nothing. record: the file of its replay; None for none. own: the player's functions.
    players: how many play in the window; without one the autopilot plays for both.
    """

    levels: tuple[Level, ...]
    seed: int
    ruleset: Ruleset | None
    record: Path | None
    physics: ChosenPhysics
    own: FunctionsFile | None = None
    players: Players = Players.ONE

    @property
    def rules(self) -> Ruleset:
        """The ruleset, with two players where they play against each other."""
        ruleset = self.ruleset or Ruleset()
        return ruleset._replace(versus=self.players is Players.VERSUS)


def play_headless(chosen_game: ChosenGame, ticks: int) -> PlayedGame:
    """A game of the autopilot without a window, recorded if asked for; a signal ends it early, what was played is kept."""
    levels, seed, record, physics = chosen_game.levels, chosen_game.seed, chosen_game.record, chosen_game.physics
    ruleset = chosen_game.rules
    recorder = None if record is None else replay.Recorder(levels, seed, ruleset)
    passed, cut_short = deque[Ticked](maxlen=LONGEST), 0

    def told(ticked: Ticked) -> None:
        """Remember the last ticks, and count those that ended before their time."""
        nonlocal cut_short
        passed.append(ticked)
        cut_short += ticked.step.dropped > 0

    with deferred():
        game = autopilot_game(levels, seed, ticks, recorder, told, physics.advance, ruleset)
        if recorder is not None and record is not None:
            replay.save(recorder.recording(), record)
        if cut_short:
            ticks_were = "1 tick was" if cut_short == 1 else f"{cut_short} ticks were"
            print_error(f"polar-breakout: {ticks_were} cut short: a ball is held in a lane too narrow")
    return PlayedGame(game, passed)


def demonstrate(chosen_game: ChosenGame) -> None:
    """A short game of the autopilot and a picture of how it stands."""
    last = play_headless(chosen_game, _DEMO_TICKS)
    print_line(result_line(last.game, "swept" if chosen_game.physics is SWEPT else "source"))
    for folder in picture_folders():
        path = free_path(folder, "polar-breakout.png")
        with suppress(BadInputError):
            save_picture(last, path, (1280, 800))
            print_line(f"picture: {path.absolute()}")
            return
