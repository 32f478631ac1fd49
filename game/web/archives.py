"""Files in one piece, as the page loads them: a ZIP archive for Python's own imports, and an archive that JavaScript unpacks.

Both are compressed as a whole: modules resemble each other, and a browser unpacks gzip by itself.
"""

import gzip
import hashlib
import io
import json
import zipfile
import zlib
from pathlib import Path

from game.web.build_cache import cached

try:
    import zopfli.gzip as zopfli
except ModuleNotFoundError:
    zopfli = None

_EPOCH = (1980, 1, 1, 0, 0, 0)
"""The date of every file in a ZIP archive: the same files give the same bytes."""
_LENGTH_BYTES = 4
_ITERATIONS = 5
"""Of zopfli's search: 15 save another 0.1 %, and take half as long again."""


def compressed(data: bytes, cache: Path) -> bytes:
    """The data in gzip's format. Where zopfli is installed (extra `site`), about 4 % smaller than by zlib.

    cache: the folder of results, since zopfli takes some 40 s for all files.
    """
    if zopfli is None:
        return gzip.compress(data, 9, mtime=0)
    path = cache / f"zopfli-{_ITERATIONS}-{hashlib.sha256(data).hexdigest()[:16]}.gz"
    return cached(path, lambda: zopfli.compress(data, numiterations=_ITERATIONS), lambda packed: _unpacked(packed) == data)


def _unpacked(packed: bytes) -> bytes:
    """The data in a gzip file; empty where it is torn."""
    try:
        return gzip.decompress(packed)
    except (OSError, EOFError, zlib.error):
        return b""


def zip_archive(files: dict[str, bytes], method: int = zipfile.ZIP_STORED) -> bytes:
    """A ZIP archive. method: of its compression, one of those of `zipfile`."""
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", method) as packed:
        for name, data in sorted(files.items()):
            packed.writestr(zipfile.ZipInfo(name, _EPOCH), data, method)
    return held.getvalue()


def zip_contents(archive: bytes) -> dict[str, bytes]:
    """The files of a ZIP archive by name. zipfile.BadZipFile for anything else."""
    with zipfile.ZipFile(io.BytesIO(archive)) as packed:
        return {name: packed.read(name) for name in packed.namelist() if not name.endswith("/")}


def page_archive(files: dict[str, bytes]) -> bytes:
    """Files for the page to unpack, one after the other.

    In front: the length of a list in JSON, four bytes with the least significant first; the list, of names and lengths.
    """
    ordered = sorted(files.items())
    index = json.dumps([[name, len(data)] for name, data in ordered]).encode()
    return b"".join([len(index).to_bytes(_LENGTH_BYTES, "little"), index, *[data for _name, data in ordered]])
