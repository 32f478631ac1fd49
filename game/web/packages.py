"""The third-party files that the page needs: fetched once by the package clients, checked against recorded hashes, then cached.

None of them is part of this project. The runtime, CPython compiled to WebAssembly, comes from npm; the wheels of msgspec and
pymunk for it come from the package index.
"""

import hashlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import platformdirs

from game.system.errors import EnvironmentMissingError
from game.system.files import write_atomically
from game.system.wording import quoted_path

_PATIENCE = 300.0
"""Seconds that a package client may take."""


class Package(NamedTuple):
    """A file of a package registry.

    name, version: of the package. file: its name. sha256: of the file, in hex. licence: its SPDX identifier.
    source: where its source text is.
    client: npm or pip, which fetches it. options: for that client.
    """

    name: str
    version: str
    file: str
    sha256: str
    licence: str
    source: str
    client: str
    options: tuple[str, ...] = ()


RUNTIME = Package(
    "pyodide",
    "314.0.7",
    "pyodide-314.0.7.tgz",
    "66b7949e5a0cba2250b586d7e368bf12fb482800748d182c4618254b685ffaa0",
    "MPL-2.0",
    "https://github.com/pyodide/pyodide/tree/314.0.7",
    "npm",
)
RUNTIME_FILES = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json")
"""What of the runtime's package is served."""
EDITOR = Package(
    "codemirror",
    "5.65.20",
    "codemirror-5.65.20.tgz",
    "0ef6484ea4f71c28c6b3dd146349e79786762fc4b42e5b33befea6201c7fa6c8",
    "MIT",
    "https://github.com/codemirror/codemirror5/tree/5.65.20",
    "npm",
)
EDITOR_FILES = ("lib/codemirror.js", "lib/codemirror.css", "mode/python/python.js", "LICENSE")
"""What of the editor's package is served, its licence among the notices."""
MSGSPEC = Package(
    "msgspec",
    "0.22.0",
    "msgspec-0.22.0-cp314-cp314-pyemscripten_2026_0_wasm32.whl",
    "a66b1766311e42371e509c996c3933b161c7ae0eabdf361af5316dec197e1022",
    "BSD-3-Clause",
    "https://github.com/jcrist/msgspec",
    "pip",
    ("--platform", "pyemscripten_2026_0_wasm32", "--python-version", "314", "--only-binary=:all:"),
)
PYMUNK = Package(
    "pymunk",
    "7.3.1",
    "pymunk-7.3.1-cp314-cp314-pyemscripten_2026_0_wasm32.whl",
    "dedd9ea9aba1e916bfbee7bf7450c5e04fe387fcd21bfecc8cd4b3c6f9c96bb3",
    "MIT",
    "https://github.com/viblo/pymunk",
    "pip",
    MSGSPEC.options,
)
"""The lab's second engine. It needs cffi, which has no wheel for the browser: game/web/cffi replaces it."""


def cache_folder() -> Path:
    """The folder of the user's cache that fetched files stay in."""
    return platformdirs.user_cache_path("polar-breakout", appauthor=False) / "web"


def fetched(package: Package, cache: Path) -> Path:
    """A package's file in the cache, fetched where it is not there yet.

    EnvironmentMissingError where its client is missing, cannot fetch it, or brings another file than the recorded one.
    """
    path = cache / package.file
    if path.is_file() and _digest(path) == package.sha256:
        return path
    with tempfile.TemporaryDirectory() as folder:
        _CLIENTS[package.client](package, Path(folder))
        brought = Path(folder, package.file)
        if not brought.is_file() or _digest(brought) != package.sha256:
            raise EnvironmentMissingError(
                f"{package.name} {package.version}: {package.client} brought another file than recorded"
            )
        try:
            cache.mkdir(parents=True, exist_ok=True)
            write_atomically(path, brought.read_bytes())
        except OSError as error:
            raise EnvironmentMissingError(
                f"{quoted_path(cache)}: {error.strerror}; a folder for fetched files is needed"
            ) from None
    return path


def packed_files(archive: Path, names: tuple[str, ...]) -> dict[str, bytes]:
    """Files of a package by name. archive: as npm packs it."""
    with tarfile.open(archive) as packed:
        found = {name: packed.extractfile(f"package/{name}") for name in names}
        return {name: file.read() for name, file in found.items() if file is not None}


def _by_npm(package: Package, folder: Path) -> None:
    """Let npm fetch a package."""
    npm = shutil.which("npm")
    if npm is None:
        raise EnvironmentMissingError(f"npm is needed to fetch {package.name} {package.version}; install Node.js")
    _run([npm, "pack", "--silent", f"{package.name}@{package.version}", *package.options], package, folder)


def _by_pip(package: Package, folder: Path) -> None:
    """Let pip fetch a wheel for another platform than this."""
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps"]
    _run([*pip, *package.options, f"{package.name}=={package.version}"], package, folder)


def _run(command: list[str], package: Package, folder: Path) -> None:
    """Run a package client in a folder, where it leaves what it fetched."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=_PATIENCE, check=False)  # noqa: S603  # the two above
    except (OSError, subprocess.TimeoutExpired):
        done = None
    if done is None or done.returncode:
        raise EnvironmentMissingError(
            f"{package.client} cannot fetch {package.name} {package.version}; a connection to its registry is needed once"
        )


def _digest(path: Path) -> str:
    """SHA-256 of a file, in hex."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


_CLIENTS: dict[str, Callable[[Package, Path], None]] = {"npm": _by_npm, "pip": _by_pip}
