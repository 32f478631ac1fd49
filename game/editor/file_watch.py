"""Whether a file was changed by another program since it was last read or written here."""

from pathlib import Path
from typing import NamedTuple

from game.levels import MAX_FILE_SIZE
from game.system.errors import BadInputError
from game.system.files import read_input
from game.system.wording import quoted_path


class FileStamp(NamedTuple):
    """What tells one version of a file from the next without reading it: its time of change in ns, its size, its number."""

    changed: int
    size: int
    number: int


class WatchedFile:
    """A level file that may change under the editor."""

    def __init__(self, path: Path) -> None:
        """Watch a path, whether or not there is a file yet."""
        self.path = path
        self._stamp = _stamp(path)
        self._text: str | None = None

    def read(self) -> str:
        """The file's text; BadInputError, in one line, where it cannot be had."""
        self._stamp = _stamp(self.path)
        text = _decoded(read_input(self.path, "level", MAX_FILE_SIZE), self.path)
        self._text = text
        return text

    def written(self, text: str) -> None:
        """The file was written here: its new content is no news."""
        self._stamp, self._text = _stamp(self.path), text

    def news(self) -> str | None:
        """The text that another program has put there since the last look; None where it is the one that is known.

        Raises BadInputError, once for each change, where the file cannot be read any more.
        """
        stamp = _stamp(self.path)
        if stamp == self._stamp:
            return None
        before, self._text = self._text, None  # what comes after a file that cannot be read is news, even if it is the same
        text = self.read()
        return None if text == before else text


def _stamp(path: Path) -> FileStamp | None:
    """The stamp of a file; None where there is none."""
    try:
        found = path.stat()
    except OSError:
        return None
    return FileStamp(found.st_mtime_ns, found.st_size, found.st_ino)


def _decoded(data: bytes, path: Path) -> str:
    """The text of a file; BadInputError where it is not UTF-8."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadInputError(f"{quoted_path(path)}: not UTF-8 at byte {error.start}") from None
