"""Levels as data: TOML files, degrees for people, checked on load."""

import difflib
import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import msgspec

from game.level_format.checks import broken_rules, warnings
from game.level_format.specs import (
    BallSpec,
    DropSpec,
    Level,
    LookSpec,
    PaddleSpec,
    RingSpec,
    WellSpec,
)
from game.system.errors import BadInputError
from game.system.files import read_input
from game.system.wording import quoted, quoted_message, quoted_path

__all__ = [
    "MAX_FILE_SIZE",
    "BallSpec",
    "DropSpec",
    "Level",
    "LookSpec",
    "PaddleSpec",
    "RingSpec",
    "WellSpec",
    "built_in",
    "campaign",
    "checked",
    "chosen",
    "classic",
    "draft",
    "from_level",
    "level_schema",
    "load_file",
    "number_of",
    "parse",
    "warnings",
]

MAX_FILE_SIZE = 64 * 1024
_MAX_LINE = 1000
_MAX_KEY_DOTS = 8
_MAX_DIGITS = 9
_FOLDER = files("game") / "levels"
"""Inside an archive or a frozen application this is no folder of the file system."""
_TABLES = (Level, BallSpec, PaddleSpec, RingSpec, WellSpec, DropSpec, LookSpec)


@cache
def campaign() -> tuple[Level, ...]:
    """The levels of the campaign, in order, chapter by chapter."""
    return _levels_in("campaign")


@cache
def classic() -> tuple[Level, ...]:
    """Seven levels for the source's rules: no power-ups, one speed; recorded games and measurements use them."""
    return _levels_in("classic")


def built_in() -> tuple[Level, ...]:
    """The levels that come with the game: the campaign, then the classic ones."""
    return campaign() + classic()


def from_level(index: int, levels: tuple[Level, ...]) -> tuple[Level, ...]:
    """The levels of a game that begins with one of a list: it and those after it, the campaign or the classic ones alone.

    index: from 0, in the list.
    """
    level = levels[index]
    part = next((part for part in (campaign(), classic()) if level in part), levels[index:])
    return tuple([other for other in levels[index:] if other in part])


def number_of(level: Level, levels: tuple[Level, ...]) -> tuple[int, int]:
    """A level's number, from 1, and the number of levels: of its part of the built-in ones, else of the levels being played."""
    known = next((part for part in (campaign(), classic()) if level in part), levels)
    return known.index(level) + 1, len(known)


def chosen(wanted: str) -> tuple[Level, ...]:
    """The levels to play from a name, a number or a file on: the rest of its part of the built-in ones, or the file's alone."""
    if wanted.casefold().endswith(".toml") or len(Path(wanted).parts) > 1:
        return (load_file(Path(wanted)),)
    number = int(wanted) if wanted.isdecimal() and len(wanted) <= _MAX_DIGITS else 0
    for part in (campaign(), classic()):
        names = [level.name.casefold() for level in part]
        if wanted.casefold() in names:
            return part[names.index(wanted.casefold()) :]
        if 1 <= number <= len(part):
            return part[number - 1 :]
        number -= len(part)
    levels = built_in()
    near = difflib.get_close_matches(wanted.casefold(), [level.name.casefold() for level in levels], 1)
    meant = f"; did you mean {near[0]!r}?" if near else ""
    raise BadInputError(
        f"--level {quoted(wanted)}: no such level; expected a number from 1 to {len(levels)}, a name that"
        f" `polar-breakout levels` lists, or a .toml file{meant}"
    )


def _levels_in(folder: str) -> tuple[Level, ...]:
    """The levels of a folder that comes with the game, in the order of their files' names."""
    found = sorted([file for file in (_FOLDER / folder).iterdir() if file.name.endswith(".toml")], key=lambda file: file.name)
    return tuple([parse(file.read_bytes(), file.name) for file in found])


def load_file(path: Path) -> Level:
    """A level from a TOML file; BadInputError, naming file, key and rule, for anything that cannot be played."""
    return parse(read_input(path, "level", MAX_FILE_SIZE), quoted_path(path))


def parse(data: bytes, source: str) -> Level:
    """A level from the bytes of a TOML file; `source` names it in errors."""
    return checked(draft(data, source), source)


def draft(data: bytes, source: str) -> Level:
    """A level that fits the format, and need not be a possible arena: what is on the way to one in the editor."""
    try:
        return msgspec.convert(_toml(data, source), Level)
    except msgspec.ValidationError as error:
        what, _, where = str(error).partition(" - at ")
        key = where.strip("`").removeprefix("$.")
        named = f"{quoted(key)}: " if key else ""
        raise BadInputError(f"{source}: {named}{quoted_message(what)}{_suggestion(what)}") from None


def checked(level: Level, source: str) -> Level:
    """The level itself, if it describes a possible arena; else BadInputError with the first rule it breaks."""
    for key, rule in broken_rules(level):
        raise BadInputError(f"{source}: {key}: {rule}")
    try:
        level.arena()
    except ValueError as error:  # a size that the physics does not take
        raise BadInputError(f"{source}: {error}") from None
    return level


def level_schema() -> str:
    """The JSON schema of level files: keys, types, ranges. The rules between the numbers are those of `checked`."""
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Polar Breakout level",
        **msgspec.json.schema(Level),
    }
    return msgspec.json.format(msgspec.json.encode(schema), indent=2).decode()


def _suggestion(what: str) -> str:
    """The known key most like the unknown one that an error names; none for a key that belongs to another table."""
    unknown = what.partition("unknown field `")[2].rstrip("`")
    known = [field for table in _TABLES for field in table.__struct_fields__]
    near = difflib.get_close_matches(unknown, known, 1) if unknown and unknown not in known else []
    return f"; did you mean `{near[0]}`?" if near else ""


def _toml(data: bytes, source: str) -> dict[str, Any]:
    """The tables of a TOML file. Long lines and deep keys are refused first: they take the parser seconds and gigabytes."""
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadInputError(f"{source}: not UTF-8 at byte {error.start}") from None
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > _MAX_LINE:
            raise BadInputError(f"{source}: line {number}: longer than {_MAX_LINE} characters")
        if line.partition("=")[0].count(".") > _MAX_KEY_DOTS:
            raise BadInputError(f"{source}: line {number}: key with more than {_MAX_KEY_DOTS} dots")
    try:
        return tomllib.loads(text)
    except ValueError as error:
        raise BadInputError(f"{source}: not valid TOML; {quoted_message(str(error))}") from None
    except RecursionError:
        raise BadInputError(f"{source}: not valid TOML; nested too deeply") from None
