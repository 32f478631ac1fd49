"""Which tasks of the course are done, kept in the user's data folder from one session to the next.

A JSON object with a version and the names of the tasks. A file that cannot be read is put aside, so that it is not lost.
"""

import time
from pathlib import Path

import msgspec
import platformdirs

from game.system.files import sweep, write_whole
from game.system.wording import quoted_path

VERSION = 1
_LARGEST = 64 * 1024


class _CourseProgress(msgspec.Struct, frozen=True):
    """The file's contents."""

    version: int
    done: list[str]


def progress_path() -> Path:
    """Where the progress is kept."""
    return platformdirs.user_data_path("polar-breakout", appauthor=False) / "lab-progress.json"


class ProgressFile:
    """One session's hold on the file. Nothing here raises; `problem` says in one line what went wrong last."""

    def __init__(self, path: Path) -> None:
        """path: of the file; it is not looked at yet."""
        self._path = path
        self._newer = False
        self.problem: str | None = None

    def load(self) -> frozenset[str]:
        """The names of the tasks that are done; none where there is no file."""
        sweep(self._path.parent)
        try:
            with self._path.open("rb") as file:
                data = file.read(_LARGEST + 1)
        except FileNotFoundError:
            return frozenset()
        except OSError as error:
            self.problem = f"progress not read: {quoted_path(self._path)}: {error.strerror or error}"
            return frozenset()
        try:
            said = msgspec.json.decode(data, type=_CourseProgress)
        except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
            self._put_aside()
            return frozenset()
        self._newer = said.version > VERSION
        if self._newer:
            self.problem = f"progress of a newer version in {quoted_path(self._path)}: changes will not be saved"
        return frozenset(said.done)

    def keep(self, done: frozenset[str]) -> None:
        """Write the names down, unless a newer program has written the file."""
        if self._newer:
            return
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(self._path, msgspec.json.encode(_CourseProgress(VERSION, sorted(done))) + b"\n")
        except OSError as error:
            self.problem = f"progress not saved: {quoted_path(self._path)}: {error.strerror or error}"

    def _put_aside(self) -> None:
        """Rename a file that cannot be read."""
        aside = self._path.with_name(f"{self._path.name}.bad-{time.strftime('%Y%m%d-%H%M%S')}")
        try:
            self._path.replace(aside)
            self.problem = f"progress not readable: moved to {quoted_path(aside)}"
        except OSError as error:
            self.problem = f"progress not readable: {quoted_path(self._path)}: {error.strerror or error}"
