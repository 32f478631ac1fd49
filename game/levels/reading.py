"""A level from a TOML file: degrees for people, checked on load."""

import difflib
import tomllib
from pathlib import Path
from typing import Any

import msgspec

from game.level_format.broken_rule import BrokenRule
from game.level_format.checks import broken_rules
from game.level_format.specs import BallSpec, DropSpec, Level, LookSpec, PaddleSpec, RingSpec, WellSpec
from game.system.errors import BadInputError
from game.system.files import read_input
from game.system.wording import quoted, quoted_message, quoted_path

MAX_FILE_SIZE = 64 * 1024
_MAX_LINE = 1000
_MAX_KEY_DOTS = 8
_TABLES = (Level, BallSpec, PaddleSpec, RingSpec, WellSpec, DropSpec, LookSpec)


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
    problem = first_problem(level)
    if problem is not None:
        raise BadInputError(f"{source}: {problem}")
    return level


def first_problem(level: Level) -> BrokenRule | None:
    """The first rule of a possible arena that a level breaks; None if it can be played."""
    for broken in broken_rules(level):
        return broken
    try:
        level.arena()
    except ValueError as error:  # a size that the physics does not take
        return BrokenRule("", "{reason}", {"reason": str(error)})
    return None


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
