"""The project's own Python for the browser: what plays and draws there, without what only a desktop can run."""

import ast
from collections.abc import Iterator
from importlib.resources import files
from importlib.resources.abc import Traversable

import polib

from game.language import CODES, ENGLISH

_STARTS = ("game.web.client.page", "game.lab.scenes", "game.languages")
"""What the browser imports, and what that imports only once it is wanted."""
_PACKAGES = ("game", "physics")
_GRADING = ("tools.grade.page",)
"""What the worker that grades imports besides."""
_ENGINE = ("game.web.cffi.backend", "tools.crosscheck.second_engine")
"""Additional modules that the lab's second engine imports."""


def browser_sources() -> dict[str, bytes]:
    """Every module that the browser's start needs, the levels and the translations, by the names of their files."""
    levels = {name: data for name, data in _tree("game") if name.startswith("game/levels/") and name.endswith(".toml")}
    return _modules(_STARTS, _PACKAGES) | levels | _translations()


def grading_sources() -> dict[str, bytes]:
    """Every module that the worker that grades needs besides."""
    return _besides(_GRADING)


def engine_sources() -> dict[str, bytes]:
    """The additional modules that the lab's second engine needs, without pymunk's own."""
    return _besides(_ENGINE)


def _besides(starts: tuple[str, ...]) -> dict[str, bytes]:
    """The modules that some modules need, without those that are loaded at the start."""
    present, wanted = _modules(_STARTS, _PACKAGES), _modules(starts, (*_PACKAGES, "tools"))
    return {name: data for name, data in wanted.items() if name not in present}


def _modules(starts: tuple[str, ...], packages: tuple[str, ...]) -> dict[str, bytes]:
    """The modules that some modules need, themselves included, by the names of their files."""
    modules = {name: data for package in packages for name, data in _tree(package) if name.endswith(".py")}
    needed: dict[str, bytes] = {}
    open_ = [*starts]
    while open_:
        module = open_.pop()
        name = next((name for name in _file_names(module) if name in modules), None)
        if name is None or name in needed:
            continue
        needed[name] = modules[name]
        open_ += _imported(modules[name])
    return needed


def _translations() -> dict[str, bytes]:
    """The translations, compiled: a browser has nothing that reads their source."""
    folder, codes = files("game.languages"), [code for code in CODES if code != ENGLISH.code]
    texts = {code: folder.joinpath(f"{code}.po").read_text(encoding="utf-8") for code in codes}
    return {f"game/languages/{code}.mo": polib.pofile(text).to_binary() for code, text in texts.items()}


def _tree(package: str) -> Iterator[tuple[str, bytes]]:
    """Names and contents of the text files of a package; it may itself be in an archive."""
    open_: list[tuple[str, Traversable]] = [(package, files(package))]
    while open_:
        name, folder = open_.pop()
        for entry in folder.iterdir():
            if entry.is_dir():
                open_.append((f"{name}/{entry.name}", entry))
            elif entry.name.endswith((".py", ".toml")):
                yield f"{name}/{entry.name}", entry.read_bytes()


def _file_names(module: str) -> tuple[str, str]:
    """The two names that a module's file may have."""
    path = module.replace(".", "/")
    return f"{path}/__init__.py", f"{path}.py"


def _imported(source: bytes) -> Iterator[str]:
    """The modules that a module imports when it is loaded, with the packages that they are in."""
    for node in _loaded(ast.parse(source).body):
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            yield from _with_packages(node.module)
            yield from [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            for alias in node.names:
                yield from _with_packages(alias.name)


def _loaded(statements: list[ast.stmt]) -> Iterator[ast.stmt]:
    """The statements that run when a module is loaded, but for what only a type checker reads."""
    for statement in statements:
        yield statement
        if isinstance(statement, ast.If) and ast.unparse(statement.test) != "TYPE_CHECKING":
            yield from _loaded([*statement.body, *statement.orelse])
        elif isinstance(statement, ast.Try):
            yield from _loaded([*statement.body, *statement.orelse, *[line for one in statement.handlers for line in one.body]])


def _with_packages(module: str) -> list[str]:
    """A module and every package around it."""
    parts = module.split(".")
    return [".".join(parts[: length + 1]) for length in range(len(parts))]
