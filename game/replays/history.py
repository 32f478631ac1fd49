"""The games played in the window, kept in the user's data folder: the last fifty."""

import time
from pathlib import Path

import platformdirs

from game.headless import free_path
from game.replays.file import Recorder, save
from game.rules import TICK, Controls, Game
from game.system.errors import BadInputError

MOST = 50
_SHORTEST = 5.0
_SUFFIX = ".polar"


def folder() -> Path:
    """Where the games are kept."""
    return platformdirs.user_data_path("polar-breakout", appauthor=False) / "replays"


def kept() -> list[Path]:
    """The kept games, newest first."""
    return sorted(folder().glob(f"*{_SUFFIX}"), key=lambda path: (path.stat().st_mtime_ns, path.name), reverse=True)


class Keeper:
    """Records every game of a session in the window, and writes each when it ends.

    Shorter games than five seconds are not kept. Where writing fails, `problem` says why, and play goes on.
    """

    def __init__(self, record: Path | None = None) -> None:
        """record: a file that gets the last game of the session as well."""
        self._record = record
        self._recorder: Recorder | None = None
        self.problem: str | None = None

    def __call__(self, controls: Controls, after: Game) -> None:
        """Record one tick; the first tick of a game begins a new recording."""
        if after.tick == 1:
            self.close()
            self._recorder = Recorder(after.levels, after.seed)
        if self._recorder is not None:
            self._recorder.add(controls, after)

    def close(self) -> None:
        """Write the game that has been recorded, if it is worth keeping, and forget the oldest beyond fifty."""
        recorder, self._recorder = self._recorder, None
        if recorder is None:
            return
        recording = recorder.recording()
        try:
            if self._record is not None:
                save(recording, self._record)
            if recorder.ticks * TICK >= _SHORTEST:
                folder().mkdir(parents=True, exist_ok=True)
                save(recording, free_path(folder(), f"{time.strftime('%Y-%m-%d %H-%M-%S')}{_SUFFIX}"))
                for old in kept()[MOST:]:
                    old.unlink()
        except (BadInputError, OSError) as error:
            self.problem = str(error)
