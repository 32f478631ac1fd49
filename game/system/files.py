"""Files: read without surprises, written atomically: whole or not at all.

Data is written to a temporary file beside its target, which is then renamed to the target. A process that is killed on the way
leaves the temporary file behind. It holds a lock on it while it lives: so `remove_temporaries` removes what is left over, and
nothing that is in use.
"""

import errno
import os
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from game.system.ending import deferred
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.wording import quoted, quoted_path

try:
    import fcntl
except ImportError:  # Windows, where a file that is open cannot be removed
    fcntl = None  # type: ignore[assignment]

_PREFIX, _SUFFIX = ".polar-breakout-", ".tmp"
_CREATE = os.O_CREAT | os.O_EXCL | os.O_RDWR | getattr(os, "O_BINARY", 0)
_NO_WAITING = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0)
"""To look at a pipe that nobody writes to without waiting for somebody."""


def write_atomically(path: Path, data: bytes) -> None:
    """Put the data where the path says: a reader finds the old file or the new one, never a part. OSError if it cannot be.

    A symbolic link stays, and its target gets the data. A file that exists keeps its permissions; a new one has those that
    the user's umask leaves. What exists and is no regular file is not written to.
    """
    target = Path(os.path.realpath(path))
    with deferred(), _written(target.parent, data, _permissions(target)) as temporary:
        temporary.replace(target)


def write_text(path: Path, text: str) -> None:
    """Put a text where the path says, as `write_atomically` does; BadInputError, in one line, if it cannot be."""
    try:
        write_atomically(path, text.encode())
    except OSError as error:
        raise BadInputError(f"{quoted_path(path)}: cannot be written; {error.strerror or error}") from None


def write_new(folder: Path, name: str, data: bytes) -> Path:
    """Put the data into a new file: its path. Where the name is taken, name-2 and so on; nothing is replaced.

    OSError if it cannot be.
    """
    with deferred(), _written(folder, data, None) as temporary:
        for path in _paths(folder, name):
            with suppress(FileExistsError):
                _give_name(temporary, path)
                return path
    raise AssertionError  # there is always one more number


def free_path(folder: Path, name: str) -> Path:
    """A path in the folder at which there is nothing yet: name.png, name-2.png, ..."""
    return next(path for path in _paths(folder, name) if not os.path.lexists(path))


def read_input(path: Path, what: str, largest: int) -> bytes:
    """A regular file's bytes; BadInputError, in one line, where they cannot be had.

    what: the file is, for the message. largest: number of bytes that is accepted.
    """
    try:
        with open(path, "rb", opener=_opened) as file:
            mode = os.fstat(file.fileno()).st_mode
            if not stat.S_ISREG(mode):
                raise BadInputError(f"{quoted_path(path)}: cannot read {what}; expected a file, not {_kind(mode)}")
            data = file.read(largest + 1)
    except IsADirectoryError:
        raise BadInputError(f"{quoted_path(path)}: cannot read {what}; expected a file, not a folder") from None
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = getattr(error, "strerror", None) or error
        if isinstance(error, PermissionError) and path.is_dir():  # on Windows
            reason = "expected a file, not a folder"
        raise BadInputError(f"{quoted_path(path)}: cannot read {what}; {reason}") from None
    if len(data) > largest:
        most = f"{largest // 2**20} MB" if largest >= 2**20 else f"{largest // 2**10} KB"
        raise BadInputError(f"{quoted_path(path)}: {what} too large; expected at most {most}")
    return data


def check_target(path: Path | None, option: str, suffix: str = "") -> None:
    """Raise BadInputError, before any work starts, for a file that cannot be written. path: None where none is wanted.

    suffix: that the name must have, such as ".png". Leftovers of earlier runs in the folder are removed.
    """
    if path is None:
        return
    named = f"{option} {quoted_path(path)}"
    if suffix and path.suffix.casefold() != suffix:
        raise BadInputError(f"{named}: expected a name that ends in {suffix}, not {quoted(path.suffix) or 'without an ending'}")
    try:
        target = Path(os.path.realpath(path))
        if path.is_symlink() and not target.exists():
            raise BadInputError(f"{named}: a link to nothing; expected a file or a new name")
        if target.is_dir():
            raise BadInputError(f"{named}: a folder; expected a file")
        if not target.parent.is_dir():
            raise BadInputError(f"{named}: there is no folder {quoted_path(path.parent)}")
        if _permissions(target) is not None and not os.access(target, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        remove_temporaries(target.parent)
        with deferred(), _written(target.parent, b"", None):
            pass
    except (OSError, ValueError) as error:
        raise BadInputError(f"{named}: cannot be written; {getattr(error, 'strerror', None) or error}") from None


def check_working_directory() -> None:
    """Raise EnvironmentMissingError where the working directory is gone: new processes start in it."""
    try:
        Path.cwd()
    except OSError as error:
        raise EnvironmentMissingError(f"no working directory ({error.strerror}); change to a folder that exists") from None


def remove_temporaries(folder: Path) -> None:
    """Remove the temporary files that killed processes have left in a folder. What cannot be removed stays."""
    with suppress(OSError):
        for path in folder.glob(f"{_PREFIX}*{_SUFFIX}"):
            with suppress(OSError):
                if not _in_use(path):
                    path.unlink()


@contextmanager
def _written(folder: Path, data: bytes, permissions: int | None) -> Iterator[Path]:
    """A temporary file in a folder with the data on the disk, gone after the block unless it was given another name."""
    file, path = _created(folder)
    try:
        if permissions is not None:
            path.chmod(permissions)
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
        if fcntl is None:
            file.close()  # Windows renames closed files only
        yield path
    finally:
        with suppress(OSError):
            file.close()
        with suppress(OSError):
            path.unlink()


def _created(folder: Path) -> tuple[IO[bytes], Path]:
    """A new temporary file, locked where the system has locks."""
    while True:
        path = folder / f"{_PREFIX}{secrets.token_hex(8)}{_SUFFIX}"
        descriptor = os.open(path, _CREATE, 0o666)
        if fcntl is not None:
            with suppress(OSError):  # not every file system can lock
                fcntl.flock(descriptor, fcntl.LOCK_EX)
        if os.fstat(descriptor).st_nlink or fcntl is None:
            return os.fdopen(descriptor, "wb"), path
        os.close(descriptor)  # swept away between being made and being locked


def _in_use(path: Path) -> bool:
    """Whether a process that lives has a temporary file locked."""
    if fcntl is None:
        return False
    descriptor = os.open(path, os.O_RDWR | os.O_NONBLOCK | os.O_NOFOLLOW)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return True
    finally:
        os.close(descriptor)
    return False


def _opened(path: str, flags: int) -> int:
    """A file that is opened at once, whatever it is."""
    return os.open(path, flags | _NO_WAITING)


def _permissions(target: Path) -> int | None:
    """The permissions of a regular file; None where there is nothing. OSError for what is no regular file."""
    try:
        mode = target.stat().st_mode
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(mode):
        raise OSError(errno.EINVAL, f"{_kind(mode)}, not a regular file")
    return stat.S_IMODE(mode)


def _give_name(temporary: Path, path: Path) -> None:
    """Let a temporary file be found under a name that is free; FileExistsError where it is not."""
    try:
        os.link(temporary, path)
    except FileExistsError:
        raise
    except (OSError, AttributeError):  # no links here, as in a browser: take the name first, then put the file there
        os.close(os.open(path, _CREATE, 0o666))
        try:
            temporary.replace(path)
        except BaseException:
            path.unlink(missing_ok=True)
            raise


def _paths(folder: Path, name: str) -> Iterator[Path]:
    """name.png, name-2.png, name-3.png and so on, in a folder."""
    stem, suffix = Path(name).stem, Path(name).suffix
    yield folder / name
    number = 1
    while True:
        number += 1
        yield folder / f"{stem}-{number}{suffix}"


def _kind(mode: int) -> str:
    """What is at a path that is no regular file."""
    kinds = {stat.S_IFDIR: "a folder", stat.S_IFIFO: "a pipe", stat.S_IFSOCK: "a socket"}
    return kinds.get(stat.S_IFMT(mode), "a device")
