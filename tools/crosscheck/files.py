"""Output files: refused before any work if they cannot be written, whole or not there after it."""

import contextlib
import os
import tempfile
from pathlib import Path

from game.system.errors import BadInputError


def check_writable(path: Path | None, option: str) -> None:
    """Raise BadInputError, naming the option, unless a file can be written there."""
    if path is None:
        return
    if path.is_dir():
        raise BadInputError(f"{option} {path}: is a folder, expected a file")
    folder = path.parent
    if not folder.is_dir():
        raise BadInputError(f"{option} {path}: the folder {folder} does not exist")
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
        if path.exists() and not os.access(path, os.W_OK):
            raise PermissionError(13, "Permission denied")
    except OSError as error:
        raise BadInputError(f"{option} {path}: cannot be written; {error.strerror}") from None


def write_whole(path: Path, text: str) -> None:
    """Write a text file, whole or not at all; BadInputError where it cannot be written."""
    try:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=".", suffix=".tmp")
        try:
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(text)
            Path(name).chmod(0o644)
            Path(name).replace(path)
        except BaseException:
            with contextlib.suppress(OSError):
                Path(name).unlink()
            raise
    except OSError as error:
        raise BadInputError(f"{path}: cannot be written; {error.strerror}") from None
