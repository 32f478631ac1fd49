"""The files that a web host serves: the page, the project's Python, the runtime, the sounds, and the notices of their licences.

They are static and need no special headers. The runtime's large files are compressed here, since not every host does it.
"""

import gzip
import hashlib
import json
import sysconfig
import zipfile
from importlib.resources import files
from pathlib import Path

import msgspec

from game import VERSION
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.files import write_whole
from game.system.wording import quoted_path
from game.web.bundle import archive, grading_archive
from game.web.packages import EDITOR, EDITOR_FILES, MSGSPEC, RUNTIME, RUNTIME_FILES, Package, fetched, packed_files
from game.web.samples import rendered

_COMPRESSED = ("pyodide.asm.wasm", "pyodide.asm.mjs", "pyodide-lock.json")
"""Files of the runtime that are served compressed; the page unpacks them."""
_PAGE = files("game") / "web" / "page"
_STAMP = b"VERSION-OF-THE-SITE"
"""Stands in the service worker for what `_version` says."""
_PYTHON = """The runtime contains CPython 3.14 and its standard library (runtime/python_stdlib.zip), under the
Python Software Foundation License Version 2: https://docs.python.org/3/license.html"""


def built_site(cache: Path) -> dict[str, bytes]:
    """Every file by its name. cache: the folder of fetched packages. EnvironmentMissingError as of `fetched`."""
    if not _PAGE.is_dir():
        raise EnvironmentMissingError("the page is not part of this application; install the package polar-breakout instead")
    site = {entry.name: entry.read_bytes() for entry in _PAGE.iterdir() if entry.is_file()}
    for name, data in packed_files(fetched(RUNTIME, cache), RUNTIME_FILES).items():
        if name in _COMPRESSED:
            site[f"runtime/{name}.packed"] = gzip.compress(data, 9, mtime=0)
        else:
            site[f"runtime/{name}"] = data
    wheel = fetched(MSGSPEC, cache)
    site["runtime/msgspec.whl"] = wheel.read_bytes()
    editor = packed_files(fetched(EDITOR, cache), EDITOR_FILES)
    site |= {f"editor/{Path(name).name}": data for name, data in editor.items() if name != "LICENSE"}
    samples, index = rendered()
    site |= {
        "game.zip": archive(),
        "grading.zip": grading_archive(),
        "sounds.bin": samples,
        "sounds.json": msgspec.json.encode(index),
    }
    site["notices.txt"] = _notices(wheel, editor["LICENSE"].decode()).encode()
    version = _version(site)
    site["offline.js"] = site["offline.js"].replace(_STAMP, version.encode())
    site["offline.json"] = json.dumps({"version": version, "files": ["./", *sorted(site)]}, indent=1).encode()
    return site


def write_site(site: dict[str, bytes], folder: Path) -> None:
    """Write the files into a folder. BadInputError where that cannot be."""
    try:
        for name, data in site.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, data)
    except OSError as error:
        raise BadInputError(f"{quoted_path(folder)}: cannot be written; {error.strerror}") from None


def _version(site: dict[str, bytes]) -> str:
    """A name for the files that changes with any of them: browsers look for a new service worker, and for nothing else."""
    digest = hashlib.sha256()
    for name in sorted(site):
        digest.update(name.encode() + b"\0" + hashlib.sha256(site[name]).digest())
    return digest.hexdigest()[:16]


def _notices(wheel: Path, editor_licence: str) -> str:
    """The licences of what is served beside the project's own files."""
    with zipfile.ZipFile(wheel) as packed:
        name = next(name for name in packed.namelist() if name.endswith("licenses/LICENSE"))
        msgspec_licence = packed.read(name).decode()
    python = Path(sysconfig.get_path("stdlib"), "LICENSE.txt")
    parts = [
        f"The polar breakout {VERSION} is under the MIT licence.\n\nIt is served together with these files, unchanged:",
        _about(RUNTIME, "runtime/pyodide*") + "\nIts licence: https://www.mozilla.org/MPL/2.0/",
        _PYTHON,
        _about(MSGSPEC, "runtime/msgspec.whl") + f"\n\n{msgspec_licence}",
        _about(EDITOR, "editor/") + f"\n\n{editor_licence}",
        python.read_text(encoding="utf-8") if python.is_file() else "",
    ]
    return "\n\n".join(parts).rstrip() + "\n"


def _about(package: Package, where: str) -> str:
    """A package with its licence and its source."""
    return f"{package.name} {package.version} ({where}), licence {package.licence}, source: {package.source}"
