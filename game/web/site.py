"""The files that a web host serves: the page, the project's Python, the runtime, the sounds, and the notices of their licences.

They are static and need no special headers. The runtime's large files are compressed here, since not every host does it.
"""

import base64
import hashlib
import json
import sysconfig
from importlib.resources import files
from pathlib import Path

import msgspec

from game import VERSION
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.files import write_atomically
from game.system.wording import quoted_path
from game.web.archives import compressed, page_archive, zip_archive, zip_contents
from game.web.bundle import browser_sources, engine_sources, grading_sources
from game.web.compiled import compiled
from game.web.music import rendered_music
from game.web.packages import EDITOR, EDITOR_FILES, MSGSPEC, PYMUNK, RUNTIME, RUNTIME_FILES, Package, fetched, packed_files
from game.web.samples import rendered
from game.web.standard_library import needed, needed_by_engine

_COMPRESSED = ("pyodide.asm.wasm", "pyodide.asm.mjs")
"""Files of the runtime that are served compressed, else as they are; the page unpacks them."""
_LIBRARY, _LOCK = "python_stdlib.zip", "pyodide-lock.json"
_LEFT_OUT = (
    "tests/",
    "examples/",
    "_extension_build.py",
    "pygame_util",
    "pyglet_util",
    "pyglet15_util",
    "matplotlib_util",
    "/util.py",
)
"""Parts of the wheels that nothing imports."""
_STAMPED = ("offline.js", "snapshot.js")
_PAGE = files("game") / "web" / "page"
_EDITOR_HASHES = {"js": b"HASHES-OF-THE-EDITOR", "css": b"HASHES-OF-ITS-STYLES"}
"""Stand in the page's content security policy: it unpacks the editor's files, and may run what has these hashes."""
_STAMP = b"VERSION-OF-THE-SITE"
"""Stands in these files for what `_version` says."""
_PYTHON = """The runtime contains CPython 3.14, unchanged, and of its standard library (runtime/python_stdlib.zip) what the
page needs, compiled and without documentation, under the
Python Software Foundation License Version 2: https://docs.python.org/3/license.html"""


def built_site(cache: Path) -> dict[str, bytes]:
    """Every file by its name. cache: the folder of fetched packages. EnvironmentMissingError as of `fetched`."""
    if not _PAGE.is_dir():
        raise EnvironmentMissingError("the page is not part of this application; install the package polar-breakout instead")
    site = {entry.name: entry.read_bytes() for entry in _PAGE.iterdir() if entry.is_file()}
    runtime = packed_files(fetched(RUNTIME, cache), RUNTIME_FILES)
    wheel, engine = fetched(MSGSPEC, cache), fetched(PYMUNK, cache)
    site |= {f"runtime/{name}.packed": compressed(runtime[name], cache) for name in _COMPRESSED}
    site |= {"runtime/pyodide.mjs": runtime["pyodide.mjs"], f"runtime/{_LOCK}": _without_packages(runtime[_LOCK])}
    library, *archives = _compiled(runtime, (wheel, engine), cache)
    site[f"runtime/{_LIBRARY}.packed"] = compressed(zip_archive(library), cache)
    for name, archive in zip(("program", "grading", "pymunk"), archives, strict=True):
        site[f"{name}.packed"] = compressed(page_archive(archive), cache)
    editor = {Path(name).name: data for name, data in packed_files(fetched(EDITOR, cache), EDITOR_FILES).items()}
    site["editor.packed"] = compressed(page_archive(editor), cache)
    for kind in ("js", "css"):
        hashes = [_content_hash(data) for name, data in editor.items() if name.endswith(f".{kind}")]
        site["index.html"] = site["index.html"].replace(_EDITOR_HASHES[kind], " ".join(hashes).encode())
    samples, index = rendered()
    site |= {"sounds.packed": compressed(samples, cache), "sounds.json": msgspec.json.encode(index)}
    site["music.packed"] = compressed(rendered_music(), cache)
    site["notices.txt"] = _notices(wheel, engine, editor["LICENSE"].decode()).encode()
    version = _version(site)
    for name in _STAMPED:
        site[name] = site[name].replace(_STAMP, version.encode())
    site["offline.json"] = json.dumps({"version": version, "files": ["./", *sorted(site)]}, indent=1).encode()
    return site


def _compiled(runtime: dict[str, bytes], wheels: tuple[Path, Path], cache: Path) -> list[dict[str, bytes]]:
    """Compiled modules and other files: the standard library, the game with msgspec, the grading, and pymunk with its caller.

    wheels: of msgspec and of pymunk.
    """
    every = zip_contents(runtime[_LIBRARY])
    msgspec_files, pymunk_files = (_modules_of(wheel) for wheel in wheels)
    parts = [
        {f"{_LIBRARY}/{name}": data for name, data in needed(every).items()},
        browser_sources() | msgspec_files,
        grading_sources(),
        engine_sources() | needed_by_engine(every) | pymunk_files,
    ]
    done = compiled({name: data for part in parts for name, data in part.items()}, runtime, cache)
    named = [{name if name in done else f"{name}c" for name in part} for part in parts]
    return [{name.removeprefix(f"{_LIBRARY}/"): done[name] for name in sorted(names)} for names in named]


def _modules_of(wheel: Path) -> dict[str, bytes]:
    """The modules and libraries of a wheel, without its tests and its modules for drawing in windows."""
    files = zip_contents(wheel.read_bytes())
    return {
        name: data
        for name, data in files.items()
        if name.endswith((".py", ".so")) and not any([part in name for part in _LEFT_OUT])
    }


def _content_hash(data: bytes) -> str:
    """A hash as a content security policy has it."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(data).digest()).decode()}'"


def _without_packages(lock: bytes) -> bytes:
    """The runtime's list of packages as it asks for it, without the packages: none is loaded."""
    return json.dumps(json.loads(lock) | {"packages": {}}).encode()


def write_site(site: dict[str, bytes], folder: Path) -> None:
    """Write the files into a folder. BadInputError where that cannot be."""
    try:
        for name, data in site.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            write_atomically(path, data)
    except OSError as error:
        raise BadInputError(f"{quoted_path(folder)}: cannot be written; {error.strerror}") from None


def _version(site: dict[str, bytes]) -> str:
    """A name for the files that changes with any of them: browsers look for a new service worker, and for nothing else."""
    digest = hashlib.sha256()
    for name in sorted(site):
        digest.update(name.encode() + b"\0" + hashlib.sha256(site[name]).digest())
    return digest.hexdigest()[:16]


def _notices(wheel: Path, engine: Path, editor_licence: str) -> str:
    """The licences of the third-party files that are served. wheel: of msgspec. engine: of pymunk."""
    python = Path(sysconfig.get_path("stdlib"), "LICENSE.txt")
    parts = [
        f"The polar breakout {VERSION} is under the MIT licence.\n\nIt is served together with these files:",
        _about(RUNTIME, "runtime/pyodide*, unchanged but for the list of packages, which is empty")
        + "\nIts licence: https://www.mozilla.org/MPL/2.0/",
        _PYTHON,
        _about(MSGSPEC, "in program.packed, compiled") + f"\n\n{_licence_in(wheel)}",
        _about(PYMUNK, "in pymunk.packed, compiled; with Munk2D, a version of Chipmunk2D") + f"\n\n{_licence_in(engine)}",
        _about(EDITOR, "in editor.packed, unchanged") + f"\n\n{editor_licence}",
        python.read_text(encoding="utf-8") if python.is_file() else "",
    ]
    return "\n\n".join(parts).rstrip() + "\n"


def _licence_in(wheel: Path) -> str:
    """The licence in a wheel."""
    files = zip_contents(wheel.read_bytes())
    return next(data.decode() for name, data in files.items() if "/licenses/LICENSE" in name)


def _about(package: Package, where: str) -> str:
    """A package with its licence and its source."""
    return f"{package.name} {package.version} ({where}), licence {package.licence}, source: {package.source}"
