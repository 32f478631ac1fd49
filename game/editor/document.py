"""A level file being edited: its text, with comments, and the level that the text describes.

Every change takes a document and gives a new one, so that undo is a list of documents. A change that leaves the format is
refused (BadInputError). A change that only breaks a rule of a possible arena gives a document with a `problem`: on the way
from one level to the next such states cannot be avoided.
"""

from collections.abc import Collection, Sequence
from typing import Any, NamedTuple

import msgspec
import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import AoT, Item

from game.language import tr
from game.level_format.broken_rule import BrokenRule
from game.levels import Level, RingSpec, WellSpec, draft, first_problem
from game.system.errors import BadInputError
from game.system.wording import quoted_message

_SOURCE = "level"
_DECIMALS = 6
"""Of a number that the editor writes."""
_LONGEST_ROW = 60
"""Entries of a list in one line of the file; a line may have 1,000 characters."""

Path = tuple[str | int, ...]
"""Keys that lead to a value: ("rings", 0, "radius")."""
Value = float | str | list[int] | list[str] | None
"""The value of a key; None if the file leaves it out, so that the format's default applies."""


class Stack(NamedTuple):
    """What a brush puts into a slot. layers: 1 to 9; 0 is a gap, -1 never breaks. None leaves the layers, or the tint."""

    layers: int | None
    tint: int | None = None

    def over(self, old: "Stack") -> "Stack":
        """What a slot contains after this stack was painted over another one."""
        return Stack(old.layers if self.layers is None else self.layers, old.tint if self.tint is None else self.tint)


class Document(NamedTuple):
    """A level file's text and what it says.

    text: TOML.
    level: the level; it fits the format.
    problem: the first rule of a possible arena that it breaks; None if it can be played.
    """

    text: str
    level: Level
    problem: BrokenRule | None


def opened(text: str) -> Document:
    """The document of a text; BadInputError, naming key and rule, where it does not fit the format."""
    level = draft(text.encode(), _SOURCE)
    return Document(text, level, first_problem(level))


def value_at(document: Document, path: Path) -> Any:
    """The value at a path, whether the file gives it or the format's default holds."""
    value: Any = document.level
    for key in path:
        value = value[key] if isinstance(key, int) else getattr(value, key)
    return value


def with_value(document: Document, path: Path, value: Value) -> Document:
    """The document with one value changed, or added where the default held. path: of a table's key, not of a whole table."""
    return with_values(document, {path: value})


def with_values(document: Document, values: dict[Path, Value]) -> Document:
    """The document with several values changed at once. values: by path."""
    toml, new = _tables(document.text), set()
    for path, value in values.items():
        table: Any = toml
        for key in path[:-1]:
            if key not in table and isinstance(key, str):
                table[key] = tomlkit.table()
                new.add(f"[{key}]")
            table = table[key]
        _put(table, str(path[-1]), _rounded(value))
    text = tomlkit.dumps(toml)
    for head in sorted(new):
        text = _set_apart(text, head)
    return opened(text)


def painted(document: Document, ring: int, slots: Collection[int], stack: Stack) -> Document:
    """The document with stacks of a ring set."""
    before = stacks(document.level.rings[ring])
    return with_stacks(document, ring, [stack.over(old) if slot in slots else old for slot, old in enumerate(before)])


def with_stacks(document: Document, ring: int, after: Sequence[Stack]) -> Document:
    """The document with all stacks of a ring set; if all are equal, the file has a single number."""
    spec = document.level.rings[ring]
    values: dict[Path, Value] = {}
    layers, tints = [stack.layers or 0 for stack in after], [stack.tint or 0 for stack in after]
    if layers != list(spec.slots()):
        values["rings", ring, "layers"] = layers[0] if len(set(layers)) == 1 else layers
    if tints != [stack.tint for stack in stacks(spec)]:
        values["rings", ring, "tint"] = _shortest_tint(tints)
    return with_values(document, values) if values else document


def with_count(document: Document, ring: int, count: int) -> Document:
    """The document with another number of slots in a ring.

    Bricks keep their share of the turn; every slot takes the layers and the tint of where it begins.
    """
    spec = document.level.rings[ring]
    if count < 1:
        raise BadInputError(f"rings[{ring}].count: must be at least 1")
    sampled, slots = [slot * spec.count // count for slot in range(count)], spec.slots()
    path: Path = ("rings", ring)
    values: dict[Path, Value] = {(*path, "count"): count, (*path, "half_angle"): spec.half_angle * spec.count / count}
    if isinstance(spec.layers, list):
        values[*path, "layers"] = [slots[slot] for slot in sampled]
    if isinstance(spec.tint, list):
        values[*path, "tint"] = [spec.tint_at(slot) for slot in sampled]
    return with_values(document, values)


def stacks(ring: RingSpec) -> tuple[Stack, ...]:
    """The stacks of a ring, slot by slot."""
    return tuple([Stack(layers, ring.tint_at(slot)) for slot, layers in enumerate(ring.slots())])


def ring_added(document: Document, ring: RingSpec) -> Document:
    """The document with a ring added at the end."""
    return _added(document, "rings", ring)


def well_added(document: Document, well: WellSpec) -> Document:
    """The document with a gravity well added at the end."""
    return _added(document, "wells", well)


def ring_removed(document: Document, ring: int) -> Document:
    """The document without one of its rings; BadInputError for the last one."""
    if len(document.level.rings) == 1:
        raise BadInputError(tr("a level has at least one ring"))
    return _removed(document, "rings", ring)


def well_removed(document: Document, well: int) -> Document:
    """The document without one of its gravity wells."""
    return _removed(document, "wells", well)


def _added(document: Document, name: str, spec: RingSpec | WellSpec) -> Document:
    """The document with a table added. name: of the list of tables. Keys with default values are left out."""
    toml, table = _tables(document.text), tomlkit.table()
    for field in msgspec.structs.fields(spec):
        value = getattr(spec, field.name)
        if value != field.default:
            table.add(field.name, _item(_rounded(value)))
    if name not in toml:
        toml.append(name, tomlkit.aot())
    tables = toml[name]
    if not isinstance(tables, AoT):
        words = tr("{name}: written in one line; write each as a table, [[{name}]]")
        raise BadInputError(words.format(name=name))
    tables.append(table)
    return opened(_set_apart(tomlkit.dumps(toml), f"[[{name}]]"))


def _removed(document: Document, name: str, index: int) -> Document:
    """The document without one table. name: of the list of tables."""
    toml = _tables(document.text)
    tables: Any = toml[name]
    del tables[index]
    if not tables:
        del toml[name]
    return opened(tomlkit.dumps(toml))


def saved_text(document: Document) -> str:
    """The text to be written to a file; BadInputError, naming key and rule, where the level cannot be played."""
    if document.problem is not None:
        raise BadInputError(tr("not saved: {problem}").format(problem=document.problem.translated))
    return document.text


def _tables(text: str) -> tomlkit.TOMLDocument:
    """The text's tables with their comments. Raises BadInputError for what one TOML reader takes and the other does not."""
    try:
        return tomlkit.parse(text)
    except TOMLKitError as error:
        words = tr("this file cannot be edited here; {reason}")
        raise BadInputError(words.format(reason=quoted_message(str(error)))) from None


def _put(table: Any, key: str, value: Value) -> None:
    """Set a key of a table, or remove it; a comment behind the old value stays."""
    old = table.get(key)
    if value is None:
        if old is not None:
            del table[key]
        return
    item = _item(value)
    if isinstance(old, Item):
        item.trivia.comment, item.trivia.comment_ws = old.trivia.comment, old.trivia.comment_ws
    table[key] = item


def _item(value: float | str | list[int] | list[str]) -> Item:
    """A value as TOML writes it; a long list in several lines."""
    if not isinstance(value, list) or len(value) <= _LONGEST_ROW:
        return tomlkit.item(value)
    rows = [", ".join(map(str, value[first : first + _LONGEST_ROW])) for first in range(0, len(value), _LONGEST_ROW)]
    return tomlkit.array("[\n    " + ",\n    ".join(rows) + ",\n]")


def _shortest_tint(tints: list[int]) -> int | list[int]:
    """The tints of all slots as a file has them: the shortest list that gives them when it is repeated around the ring."""
    count = len(tints)
    length = next(size for size in range(1, count + 1) if tints == tints[:size] * (count // size))
    return tints[0] if length == 1 else tints[:length]


def _rounded(value: Any) -> Any:
    """A float without the digits that a binary fraction leaves behind it: 2.4, not 2.4000000000000004; else the value."""
    return round(value, _DECIMALS) if isinstance(value, float) else value


def _set_apart(text: str, head: str) -> str:
    """The text with an empty line before and after the last table with a head. head: as in `[[rings]]`."""
    lines = text.rstrip().split("\n")
    at = max([index for index, line in enumerate(lines) if line.strip() == head])
    before, table = lines[:at], lines[at:]
    end = next((index for index, line in enumerate(table[1:], 1) if line.startswith(("[", "#"))), len(table))
    parts = (before, table[:end], table[end:])
    return "\n\n".join(["\n".join(part).strip("\n") for part in parts if part]) + "\n"
