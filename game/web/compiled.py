"""Python modules compiled for the page: by the runtime's own CPython, under Node.js, since no other has the same bytecode.

A browser that gets them need not compile some 400 modules before the first picture.
"""

import hashlib
import shutil
import subprocess
import tempfile
import zipfile
from importlib.resources import files
from pathlib import Path

from game.system.errors import EnvironmentMissingError
from game.web.archives import zip_archive, zip_contents
from game.web.build_cache import cached

_SCRIPT = "compile.mjs"
_PATIENCE = 300.0
"""Seconds that Node.js may take."""


def compiled(sources: dict[str, bytes], runtime: dict[str, bytes], cache: Path) -> dict[str, bytes]:
    """Every .py as its .pyc, without docstrings, assertions and columns in tracebacks; other files as they are.

    runtime: its files by name. cache: the folder of results, since compiling takes seconds.
    EnvironmentMissingError where Node.js is missing or cannot run the runtime.
    """
    script = files("game").joinpath("web", _SCRIPT).read_bytes()
    archive = zip_archive(sources)
    digest = hashlib.sha256(b"".join([hashlib.sha256(data).digest() for data in (script, *runtime.values(), archive)]))
    path = cache / f"compiled-{digest.hexdigest()[:16]}.zip"
    return zip_contents(cached(path, lambda: _by_node(script, archive, runtime), _is_zip))


def _is_zip(data: bytes) -> bool:
    """Whether a ZIP archive is whole."""
    try:
        return bool(zip_contents(data))
    except zipfile.BadZipFile:
        return False


def _by_node(script: bytes, archive: bytes, runtime: dict[str, bytes]) -> bytes:
    """Let Node.js compile an archive of sources; the archive of the results."""
    node = shutil.which("node")
    if node is None:
        raise EnvironmentMissingError("node is needed to compile the page's Python; install Node.js")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, data in {**runtime, _SCRIPT: script, "sources.zip": archive}.items():
            (folder / file).write_bytes(data)
        command = [node, _SCRIPT, ".", "sources.zip", "out.zip"]
        try:
            done = subprocess.run(command, cwd=folder, capture_output=True, timeout=_PATIENCE, check=False)  # noqa: S603  # ours
        except (OSError, subprocess.TimeoutExpired):
            done = None
        if done is None or done.returncode:
            raise EnvironmentMissingError("node cannot compile the page's Python; Node.js 20 or newer is needed")
        return (folder / "out.zip").read_bytes()
