"""Changes of a level in words, found by comparing the levels before and after: so the commands need not describe themselves."""

from typing import Any

import msgspec

from game.editor.document import Path, stacks
from game.editor.fields import field_at, named
from game.editor.history import EditHistory
from game.language import ntr, tr
from game.levels import Level

_LONGEST = 24
"""Greatest number of letters of a text that are shown."""


def undo_words(history: EditHistory) -> str:
    """What undo would take back; "" if there is nothing to undo."""
    return described(history.past[-1].level, history.present.level) if history.past else ""


def redo_words(history: EditHistory) -> str:
    """What redo would do again; "" if there is nothing to redo."""
    return described(history.present.level, history.future[-1].level) if history.future else ""


def described(before: Level, after: Level) -> str:
    """The change from one level to another, in the player's language."""
    more = (
        (_has_one_more(after.rings, before.rings), tr("add ring")),
        (_has_one_more(after.wells, before.wells), tr("add well")),
    )
    fewer = (
        (_has_one_more(before.rings, after.rings), tr("remove ring")),
        (_has_one_more(before.wells, after.wells), tr("remove well")),
    )
    if words := next((words for holds, words in (*more, *fewer) if holds), ""):
        return words
    changed = _changed(msgspec.to_builtins(before), msgspec.to_builtins(after))
    keys = {path[:3] for path in changed}
    painted = {path for path in keys if path[0] == "rings" and path[-1] in ("layers", "tint")}
    if keys and keys == painted:
        return _painted_words(before, after)
    if len({path[:2] for path in keys}) == 1 and {path[-1] for path in keys} == {"distance", "angle"}:
        return tr("move well")
    if any([path[-1] == "count" and path[0] == "rings" for path in keys]):
        keys -= {path for path in keys if path[-1] in ("half_angle", "layers", "tint")}
    if len(keys) == 1:
        return _value_words(next(iter(keys)), changed)
    return ntr("{count} change", "{count} changes", len(keys)).format(count=len(keys)) if keys else tr("notes in the file")


def _has_one_more(longer: list[Any], shorter: list[Any]) -> bool:
    """Whether a list equals another one but for one additional element."""
    return len(longer) == len(shorter) + 1 and any([longer[:at] + longer[at + 1 :] == shorter for at in range(len(longer))])


def _painted_words(before: Level, after: Level) -> str:
    """What a stroke did, and to how many bricks."""
    pairs = [
        (old, new)
        for old_ring, new_ring in zip(before.rings, after.rings, strict=True)
        for old, new in zip(stacks(old_ring), stacks(new_ring), strict=True)
        if old != new
    ]
    count = len(pairs)
    if all([new.layers == 0 for _, new in pairs]):
        words = ntr("take {count} brick away", "take {count} bricks away", count)
    elif all([old.layers == new.layers for old, new in pairs]):
        words = ntr("colour {count} brick", "colour {count} bricks", count)
    else:
        words = ntr("paint {count} brick", "paint {count} bricks", count)
    return words.format(count=count)


def _value_words(path: Path, changed: dict[Path, tuple[Any, Any]]) -> str:
    """The value of a key before and after, if both are short."""
    field = field_at(path)
    label = named(path) if field is None else tr(field.label)
    if path not in changed:
        return label
    old, new = (_shown(value) for value in changed[path])
    if not old or not new or len(old) + len(new) > _LONGEST:
        return label
    return tr("{label}: {old} to {new}").format(label=label, old=old, new=new)


def _shown(value: object) -> str:
    """A value as text; "" for one that has no short form."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        return ""
    return value if isinstance(value, str) else f"{value:.10g}"


def _changed(before: Any, after: Any, path: Path = ()) -> dict[Path, tuple[Any, Any]]:
    """(before, after) of every value that differs in two nested tables, by path."""
    if isinstance(before, dict) and isinstance(after, dict):
        pairs = [(key, before.get(key), after.get(key)) for key in {**before, **after}]
    elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        pairs = list(zip(range(len(before)), before, after, strict=True))
    else:
        return {} if before == after else {path: (before, after)}
    return {at: pair for key, old, new in pairs for at, pair in _changed(old, new, (*path, key)).items()}
