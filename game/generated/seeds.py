"""The levels of a seed, one after another.

A level's number decides how hard it is, and what it may have: at first only rings at rest, then rings that turn, bumpers,
gravity wells, steel, and at every fifth level a ring that grows again. Random numbers from the seed decide the rest. All of
them come from `random()`, and the arithmetic gives the same bits everywhere, so a seed gives the same levels on every machine.
"""

import datetime as dt
import random
from typing import NamedTuple, get_args

from game.generated.arena import drawn
from game.generated.chance import below, one_of
from game.generated.figures import STYLES, Style
from game.level_format.specs import Palette
from game.levels import Level, checked, warnings
from game.system.errors import BadInputError

SEQUENCE = 99
"""Number of levels of a sequence: enough for hours of play."""

_HARDEST = 30
"""From this number on levels grow no harder."""
_LEAST, _LEAST_GROWTH = 60.0, 25.0
_MOST, _MOST_GROWTH = 125.0, 50.0
"""Layers to be broken in an easy level, at least and at most, and how many more in the hardest."""
_GUARDED_SHARE = 0.75
"""Share of the greatest number that is allowed if bricks grow again, since these have to be broken more than once."""
_TRIES = 200
_NUMBERS = 256
"""Numbers that a seed has draws for: its levels', and the last one for what is drawn once for all of them."""
_PALETTES: tuple[Palette, ...] = get_args(Palette)
_PALETTE_STRIDES = (1, 3, 5, 7)
"""Strides through the list of palettes that reach all of them."""


class _Subject(NamedTuple):
    """The kind of figure of a level's wall, and its colours."""

    style: Style
    palette: Palette


def sequence(seed: int, count: int = SEQUENCE) -> tuple[Level, ...]:
    """The levels of a seed, the easiest first. seed: 0 <= seed < 2**63. count: how many, from 1."""
    return tuple([generated(seed, number) for number in range(count)])


def daily_seed(day: dt.date) -> int:
    """The seed of a day: its digits, as in 20261126."""
    return day.year * 10000 + day.month * 100 + day.day


def generated(seed: int, number: int) -> Level:
    """One level of a sequence. number: from 0; it decides how hard the level is.

    A level that breaks a rule of the format, or has too few or too many bricks, is discarded, and another one is drawn.
    """
    style, palette = _subject(seed, number)
    hardness = min(number / _HARDEST, 1.0)
    chance = random.Random(seed * _NUMBERS + number).random
    for _ in range(_TRIES):
        level = drawn(chance, number, hardness, style, palette)
        if _is_of_size(level, hardness) and _is_sound(level):
            return level
    raise AssertionError(f"no level for seed {seed}, number {number}")


def _subject(seed: int, number: int) -> _Subject:
    """The figure and the palette of a level: two levels in a row differ in both."""
    chance = random.Random(seed * _NUMBERS + _NUMBERS - 1).random
    style, stride = below(chance, len(STYLES)), 1 + below(chance, len(STYLES) - 1)
    palette, palette_stride = below(chance, len(_PALETTES)), one_of(chance, _PALETTE_STRIDES)
    return _Subject(
        STYLES[(style + number * stride) % len(STYLES)], _PALETTES[(palette + number * palette_stride) % len(_PALETTES)]
    )


def _is_of_size(level: Level, hardness: float) -> bool:
    """Whether the number of layers to be broken is within limits."""
    layers = sum([max(layers, 0) for ring in level.rings if not ring.regrow for layers in ring.slots()])
    share = _GUARDED_SHARE if any([ring.regrow for ring in level.rings]) else 1.0
    return _LEAST + _LEAST_GROWTH * hardness <= layers <= share * (_MOST + _MOST_GROWTH * hardness)


def _is_sound(level: Level) -> bool:
    """Whether a level breaks no rule of the format and gets none of its warnings."""
    try:
        checked(level, level.name)
    except BadInputError:
        return False
    return not warnings(level)
