"""One process at a time: a lock on a file beside the one that is to be read, changed and written again."""

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]
    import msvcrt

_PATIENCE = 2.0
"""Seconds that another process is waited for: one that holds a lock for longer hangs, and would hang this one too."""
_PAUSE = 0.01
"""Seconds between two attempts."""


@contextmanager
def locked(path: Path) -> Iterator[bool]:
    """Hold the lock of a file for as long as the block runs; whether it could be had.

    The lock is a file `.NAME.lock` beside it; OSError where that cannot be made. It stays: once it were removed, two processes
    could hold two locks of one name.
    """
    descriptor = os.open(path.with_name(f".{path.name}.lock"), os.O_CREAT | os.O_RDWR, 0o666)
    try:
        yield _taken(descriptor)
    finally:
        if fcntl is None:
            with suppress(OSError):
                os.lseek(descriptor, 0, os.SEEK_SET)
                msvcrt.locking(descriptor, msvcrt.LK_UNLCK, 1)  # type: ignore[attr-defined,unused-ignore]
        os.close(descriptor)


def _taken(descriptor: int) -> bool:
    """Whether the lock could be had in time."""
    until = time.monotonic() + _PATIENCE
    while True:
        try:
            if fcntl is None:
                msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
            else:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            if time.monotonic() >= until:
                return False
            time.sleep(_PAUSE)
        else:
            return True
