"""Results that are slow to build, stored in the user's cache folder under a digest of what they were built from."""

import time
from collections.abc import Callable
from pathlib import Path

from game.system.files import write_atomically

_SECONDS = 30 * 86400.0
"""Results that nobody has asked for this long are removed."""


def cached(path: Path, build: Callable[[], bytes], is_whole: Callable[[bytes], bool]) -> bytes:
    """The content of a file; where it is missing or torn, it is built and stored. A folder that cannot be written is no error.

    path: its name begins with the kind of the result, up to a hyphen. is_whole: whether a content can be used.
    """
    try:
        found = path.read_bytes()
        if is_whole(found):
            path.touch()
            return found
    except OSError:
        pass
    built = build()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, built)
        for other in path.parent.glob(f"{path.name.partition('-')[0]}-*{path.suffix}"):
            if time.time() - other.stat().st_mtime > _SECONDS:
                other.unlink(missing_ok=True)
    except OSError:
        pass
    return built
