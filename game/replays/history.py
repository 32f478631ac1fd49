"""The games played in the window, kept in the user's data folder: the last fifty."""

import time
from contextlib import suppress
from pathlib import Path

import platformdirs

from game.replays.file import Recorder, encoded, save
from game.rules import TICK, Controls, Game
from game.system.ending import deferred
from game.system.errors import BadInputError
from game.system.files import sweep, write_new
from game.system.wording import quoted_path

MOST = 50
"""Games kept."""
_SHORTEST = 5.0
"""Seconds of a game that is worth keeping."""
_SUFFIX = ".polar"


def folder() -> Path:
    """Where the games are kept."""
    return platformdirs.user_data_path("polar-breakout", appauthor=False) / "replays"


def kept_games() -> list[Path]:
    """The kept games, newest first; what is no file, or a link to nothing, is left out."""
    ages: list[tuple[int, str, Path]] = []
    for path in folder().glob(f"*{_SUFFIX}"):
        with suppress(OSError):
            if path.is_file():
                ages.append((path.stat().st_mtime_ns, path.name, path))
    return [path for _, _, path in sorted(ages, reverse=True)]


class History:
    """Records every game of a session in the window, and writes each when it ends.

    Shorter games than five seconds are not kept. Where writing fails, `problem` says why, and play goes on.
    """

    def __init__(self, record: Path | None = None) -> None:
        """Remove what killed sessions have left. record: a file that gets the last game of the session as well."""
        self._record = record
        self._recorder: Recorder | None = None
        self.problem: str | None = None
        sweep(folder())

    def __call__(self, controls: Controls, after: Game) -> None:
        """Record one tick; the first tick of a game begins a new recording."""
        if after.tick == 1:
            self.close()
            self._recorder = Recorder(after.levels, after.seed, after.ruleset)
        if self._recorder is not None:
            self._recorder.add(controls, after)

    def close(self) -> None:
        """Write the game that has been recorded, if it is worth keeping, and forget the oldest beyond fifty."""
        recorder, self._recorder = self._recorder, None
        if recorder is None:
            return
        recording = recorder.recording()
        with deferred():
            try:
                if self._record is not None:
                    save(recording, self._record)
                if recorder.ticks * TICK >= _SHORTEST:
                    folder().mkdir(parents=True, exist_ok=True)
                    write_new(folder(), f"{time.strftime('%Y-%m-%d %H-%M-%S')}{_SUFFIX}", encoded(recording))
                    for old in kept_games()[MOST:]:
                        old.unlink(missing_ok=True)
            except BadInputError as error:
                self.problem = str(error)
            except OSError as error:
                self.problem = f"{quoted_path(folder())}: {error.strerror or error}"
