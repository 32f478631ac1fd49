"""A versioned JSON file of the user's data folder: read whatever is there, changed under a lock, written whole.

No file keeps the game from starting. One that cannot be read is moved aside, one of a newer version is left alone. Where
nothing can be written, the changes hold for the session. `problem` says in one line what went wrong last.
"""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Generic, TypeVar

import msgspec

from game.system.ending import deferred
from game.system.file_lock import locked
from game.system.files import free_path, remove_temporaries, write_atomically
from game.system.wording import quoted_path

_LARGEST = 4 * 1024 * 1024
"""Bytes of a file that is read."""

T = TypeVar("T", bound=msgspec.Struct)


class _Version(msgspec.Struct):
    """The one field that is looked at before all others."""

    version: int = 1


class StoredFile(Generic[T]):
    """One session's hold on one file. Nothing here raises."""

    def __init__(self, path: Path | None, kind: type[T], version: int) -> None:
        """path: of the file, None to keep everything in memory alone. kind: what it holds; its defaults stand for no file.

        version: that this game writes, and the newest that it reads.
        """
        self._path, self._kind, self._version = path, kind, version
        self._held: T = kind()
        self._unwritten: list[Callable[[T], T]] = []
        self._newer = False
        self.problem: str | None = None
        if path is not None:
            remove_temporaries(path.parent)
            self._held = self._read(path)

    @property
    def value(self) -> T:
        """What it holds, as far as this session knows."""
        return self._held

    def update(self, change: Callable[[T], T]) -> T:
        """Change it and write it: the change is made to what the file holds now, so that no other process' is lost.

        What could not be written is tried again with the next change.
        """
        before = self._held
        if self._path is None or self._newer:
            self._held = change(before)
            return self._held
        self._unwritten.append(change)
        with deferred():
            try:
                self._write(self._path)
            except OSError as error:
                self._held = change(before)
                self.problem = f"not saved: {quoted_path(self._path)}: {error.strerror or error}"
        return self._held

    def _write(self, path: Path) -> None:
        """Make all changes that are not in the file yet to what it holds now. OSError if that cannot be."""
        path.parent.mkdir(parents=True, exist_ok=True)
        with locked(path):
            held = self._read(path)
            for change in self._unwritten:
                held = change(held)
            if not self._newer:
                write_atomically(path, _encoded(held))
            self._held = held
            self._unwritten.clear()

    def _read(self, path: Path) -> T:
        """What the file says; what is held where it says nothing that makes sense."""
        try:
            if not path.exists():
                return self._held
            if not path.is_file():
                self.problem = f"not read: {quoted_path(path)}: not a file"
                return self._held
            with path.open("rb") as file:
                data = file.read(_LARGEST + 1)
        except OSError as error:
            self.problem = f"not read: {quoted_path(path)}: {error.strerror or error}"
            return self._held
        try:
            if len(data) > _LARGEST:
                raise msgspec.ValidationError
            self._newer = msgspec.json.decode(data, type=_Version).version > self._version
            if self._newer:
                self.problem = f"{quoted_path(path)}: of a newer version; nothing is saved there"
                return self._held
            return msgspec.json.decode(data, type=self._kind)
        except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
            self._put_aside(path)
            return self._held

    def _put_aside(self, path: Path) -> None:
        """Rename a file that cannot be read, so that it is not lost when the next one is written."""
        try:
            aside = free_path(path.parent, f"{path.name}.bad-{time.strftime('%Y%m%d-%H%M%S')}")
            path.replace(aside)
            self.problem = f"not readable: moved to {quoted_path(aside)}"
        except OSError as error:
            self.problem = f"not readable: {quoted_path(path)}: {error.strerror or error}"


def _encoded(value: msgspec.Struct) -> bytes:
    """The file's bytes, for people to read as well."""
    return msgspec.json.format(msgspec.json.encode(value)) + b"\n"
