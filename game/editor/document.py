"""A level file being edited: its text, with comments, and the level that the text describes.

Every change takes a document and gives a new one, so that undo is a list of documents. A change that leaves the format is
refused (BadInputError). A change that only breaks a rule of a possible arena gives a document with a `problem`: on the way
from one level to the next such states cannot be avoided.
"""

from collections.abc import Collection
from typing import Any, NamedTuple

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import AoT, Item, Table

from game.levels import Level, RingSpec, checked, draft
from game.system.errors import BadInputError
from game.system.wording import quoted_message

_SOURCE = "level"
_DECIMALS = 6
"""Of a number that the editor writes."""
_LONGEST_ROW = 60
"""Entries of a list in one line of the file; a line may have 1,000 characters."""

Path = tuple[str | int, ...]
"""Keys that lead to a value: ("rings", 0, "radius")."""


class Document(NamedTuple):
    """A level file's text and what it says.

    text: TOML.
    level: the level; it fits the format.
    problem: the first rule of a possible arena that it breaks, with its key; empty where it can be played.
    """

    text: str
    level: Level
    problem: str


def opened(text: str) -> Document:
    """The document of a text; BadInputError, naming key and rule, where it does not fit the format."""
    level = draft(text.encode(), _SOURCE)
    try:
        checked(level, _SOURCE)
    except BadInputError as error:
        return Document(text, level, str(error).removeprefix(f"{_SOURCE}: "))
    return Document(text, level, "")


def value_at(document: Document, path: Path) -> Any:
    """The value at a path, whether the file gives it or the format's default holds."""
    value: Any = document.level
    for key in path:
        value = value[key] if isinstance(key, int) else getattr(value, key)
    return value


def with_value(document: Document, path: Path, value: float | str | list[int]) -> Document:
    """The document with one value changed, or added where the default held. path: of a table's key, not of a whole table."""
    toml = _tables(document.text)
    table: Any = toml
    for key in path[:-1]:
        table = table[key]
    key = path[-1]
    _put(table, str(key), _rounded(value))
    return opened(tomlkit.dumps(toml))


def painted(document: Document, ring: int, slots: Collection[int], layers: int) -> Document:
    """The document with stacks of a ring set. layers: 1 to 9; 0 takes the brick away; -1 is unbreakable."""
    before = document.level.rings[ring].slots()
    return painted_slots(document, ring, [layers if slot in slots else old for slot, old in enumerate(before)])


def painted_slots(document: Document, ring: int, after: list[int]) -> Document:
    """The document with all stacks of a ring set, each as for `painted`."""
    if after == list(document.level.rings[ring].slots()):
        return document
    same = after[0] if len(set(after)) == 1 else None
    return with_value(document, ("rings", ring, "layers"), after if same is None else same)


def with_count(document: Document, ring: int, count: int) -> Document:
    """The document with another number of slots in a ring.

    Bricks keep their share of the turn; every slot takes the layers and the tint of where it begins.
    """
    spec = document.level.rings[ring]
    if count < 1:
        raise BadInputError(f"rings[{ring}].count: must be at least 1")
    sampled, slots = [slot * spec.count // count for slot in range(count)], spec.slots()
    toml = _tables(document.text)
    table: Any = toml["rings"][ring]
    _put(table, "count", count)
    _put(table, "half_angle", _rounded(spec.half_angle * spec.count / count))
    if isinstance(spec.layers, list):
        _put(table, "layers", [slots[slot] for slot in sampled])
    if isinstance(spec.tint, list):
        _put(table, "tint", [spec.tint_at(slot) for slot in sampled])
    return opened(tomlkit.dumps(toml))


def ring_added(document: Document, like: int, radius: float) -> Document:
    """The document with a copy of a ring at another radius, as its last ring. radius: world units."""
    toml = _tables(document.text)
    rings = toml["rings"]
    if not isinstance(rings, AoT):
        raise BadInputError("rings: written in one line; write each ring as a table, [[rings]]")
    table = tomlkit.table()
    spec = document.level.rings[like]
    for key in RingSpec.__struct_fields__:
        value = getattr(spec, key)
        if value != _default(key):
            table.add(key, _item(_rounded(radius) if key == "radius" else value))
    rings.append(table)
    return opened(_with_blank_line(tomlkit.dumps(toml)))


def ring_removed(document: Document, ring: int) -> Document:
    """The document without one of its rings; BadInputError for the last one."""
    toml = _tables(document.text)
    rings: Any = toml["rings"]
    if len(rings) == 1:
        raise BadInputError("rings: a level has at least one ring")
    del rings[ring]
    return opened(tomlkit.dumps(toml))


def saved_text(document: Document) -> str:
    """The text to be written to a file; BadInputError, naming key and rule, where the level cannot be played."""
    if document.problem:
        raise BadInputError(f"not saved: {document.problem}")
    return document.text


def _tables(text: str) -> tomlkit.TOMLDocument:
    """The text's tables with their comments. Raises BadInputError for what one TOML reader takes and the other does not."""
    try:
        return tomlkit.parse(text)
    except TOMLKitError as error:
        raise BadInputError(f"this file cannot be edited here; {quoted_message(str(error))}") from None


def _put(table: Table, key: str, value: float | str | list[int]) -> None:
    """Set a key of a table; the comment behind its old value stays."""
    old = table.get(key)
    item = _item(value)
    if isinstance(old, Item):
        item.trivia.comment, item.trivia.comment_ws = old.trivia.comment, old.trivia.comment_ws
    table[key] = item


def _item(value: float | str | list[int]) -> Item:
    """A value as TOML writes it; a long list in several lines."""
    if not isinstance(value, list) or len(value) <= _LONGEST_ROW:
        return tomlkit.item(value)
    rows = [", ".join(map(str, value[first : first + _LONGEST_ROW])) for first in range(0, len(value), _LONGEST_ROW)]
    return tomlkit.array("[\n    " + ",\n    ".join(rows) + ",\n]")


def _rounded(value: Any) -> Any:
    """A float without the digits that a binary fraction leaves behind it: 2.4, not 2.4000000000000004; else the value."""
    return round(value, _DECIMALS) if isinstance(value, float) else value


def _default(key: str) -> Any:
    """The format's default of a key of a ring; None where there is none."""
    fields, defaults = RingSpec.__struct_fields__, RingSpec.__struct_defaults__
    optional = dict(zip(fields[len(fields) - len(defaults) :], defaults, strict=True))
    return optional.get(key)


def _with_blank_line(text: str) -> str:
    """The text with an empty line before its last table."""
    head, mark, tail = text.rpartition("[[rings]]")
    return f"{head.rstrip()}\n\n{mark}{tail}"
