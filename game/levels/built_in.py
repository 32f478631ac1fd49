"""The levels that come with the game, and those that a game is played with."""

import difflib
from functools import cache
from importlib.resources import files
from pathlib import Path

from game.level_format.specs import Level
from game.levels.reading import load_file, parse
from game.system.errors import BadInputError
from game.system.wording import quoted

_MAX_DIGITS = 9
_FOLDER = files("game") / "levels"
"""Inside an archive or a frozen application this is no folder of the file system."""


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
