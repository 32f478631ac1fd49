"""Processes killed in the middle of saving: is every file whole, and is nothing left behind after the next start?

A child is forked for every kill. It writes settings, progress and replays over and over, until SIGKILL ends it at a random
moment.
Windows cannot fork.
"""

import contextlib
import os
import signal
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import NamedTuple

from game.levels import classic
from game.replays.file import Recorder, encoded, load, save
from game.rules import Controls, new_game, tick
from game.settings import file as settings_file
from game.settings.file import SettingsFile
from game.settings.values import Settings
from game.storage.progress import VERSION, Best, Progress
from game.storage.stored_file import StoredFile
from game.system.errors import BadInputError
from game.system.files import remove_temporaries, write_new

_LONGEST = 0.02
"""Seconds that a child saves, at most."""
_TICKS = 600


class Kill(NamedTuple):
    """What one kill left.

    torn: files that are not whole. left: temporary files before the next start. behind: temporary files after it.
    """

    torn: int
    left: int
    behind: int


def kills(count: int, seed: int, folder: Path) -> Iterator[Kill]:
    """Kill so many children, one after the other, and look at the folder after each."""
    chance, recording = Random(seed), _recording()
    settings, record, history = folder / "settings.json", folder / "game.polar", folder / "replays"
    history.mkdir()
    for _ in range(count):
        child = os.fork()
        if child == 0:
            _save_for_ever(settings, record, history, recording)
        time.sleep(chance.random() * _LONGEST)
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        left = _temporary(folder)
        torn = _torn(settings, record, history) + bool(_progress(folder).problem)
        SettingsFile(settings).load()  # the next start
        remove_temporaries(history)
        yield Kill(torn, left, _temporary(folder))
        for kept in history.iterdir():
            kept.unlink()


def _recording() -> Recorder:
    """Some seconds of a game."""
    levels = classic()
    game, recorder = new_game(levels, 1), Recorder(levels, 1)
    for number in range(_TICKS):
        controls = Controls(serve=number == 10)
        game = tick(game, controls).game
        recorder.add(controls, game)
    return recorder


def _save_for_ever(settings: Path, record: Path, history: Path, recorder: Recorder) -> None:
    """The life of a child."""
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        signal.signal(getattr(signal, name), signal.SIG_DFL)
    recording, progress = recorder.recording(), _progress(settings.parent)
    while True:
        for volume in (0, 50, 100):
            progress.update(_with_best(volume))
            SettingsFile(settings).keep(Settings(volume=volume))
            save(recording, record)
            write_new(history, "2026-01-01 00-00-00.polar", encoded(recording))


def _progress(folder: Path) -> StoredFile[Progress]:
    """The progress kept in a folder."""
    return StoredFile(folder / "progress.json", Progress, VERSION)


def _with_best(score: int) -> Callable[[Progress], Progress]:
    """What adds a best to the progress."""
    return lambda held: held.after(Best(f"level {score}", "easy", score))


def _torn(settings: Path, record: Path, history: Path) -> int:
    """How many files are there in part."""
    torn = 0
    if settings.exists():
        hold = SettingsFile(settings)
        found = hold.load()
        torn += hold.problem is not None or settings.read_bytes() != settings_file.encoded(found)
    for replay in (record, *history.glob("*.polar")):
        with contextlib.suppress(FileNotFoundError):
            if replay.exists():
                torn += _is_torn(replay)
    return torn


def _is_torn(replay: Path) -> bool:
    """Whether a replay cannot be read."""
    try:
        load(replay)
    except BadInputError:
        return True
    return False


def _temporary(folder: Path) -> int:
    """How many files in a folder have no proper name."""
    files = [path for path in folder.rglob(".*") if path.is_file()]
    return len([path for path in files if path.suffix != ".lock"])  # a lock's file stays
