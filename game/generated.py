"""Levels made from a seed: the same seed is the same sequence of levels for everyone, and a day has a seed of its own.

A level's number decides how hard it is: more rings, thicker stacks, faster turning, a faster ball, narrower paddles. Its draws
decide the rest. A wall that breaks a rule of the format, or whose gates a ball finds through only by luck, is drawn again.
"""

import datetime as dt
import random
from collections.abc import Callable

from game.language import tr_noop
from game.level_names import GENERATED
from game.levels import BallSpec, Level, PaddleSpec, RingSpec, checked, warnings
from game.system.errors import BadInputError
from physics import PERMANENT

SEQUENCE = 99
"""Levels of a sequence. The longest of them would take hours."""

_GROUND = 10.0
_BALL = 0.25
_TRACK = 9.2
_INNERMOST, _OUTERMOST = 1.6, 7.4
"""Radii between which rings lie, world units."""
_APART = 0.25
"""Least distance between two rings; a wider one lets the ball in."""
_HARDEST = 30
"""From this number on levels grow no harder."""
_GATE = 2.5
"""Least width of a gate between unbreakable sectors, in diameters of the ball."""
_TRIES = 200

Chance = Callable[[], float]
"""Gives numbers from 0 to below 1."""


def sequence(seed: int, count: int = SEQUENCE) -> tuple[Level, ...]:
    """The levels of a seed, the easiest first. seed: 0 <= seed < 2**63. count: how many, from 1."""
    return tuple([generated(seed, number) for number in range(count)])


def daily_seed(day: dt.date) -> int:
    """The seed of a day: its digits, as in 20261126."""
    return day.year * 10000 + day.month * 100 + day.day


def generated(seed: int, number: int) -> Level:
    """One level of a sequence. number: from 0; it decides how hard the level is."""
    chance = random.Random((seed << 8) + number).random
    hardness = min(number / _HARDEST, 1.0)
    for _ in range(_TRIES):
        level = _drawn(chance, hardness, number)
        try:
            checked(level, level.name)
        except BadInputError:
            continue
        if not warnings(level):
            return level
    raise AssertionError(f"no level for seed {seed}, number {number}")


def _drawn(chance: Chance, hardness: float, number: int) -> Level:
    """A level that may still break a rule."""
    rings: list[RingSpec] = []
    outer = _OUTERMOST - 1.2 * chance()
    wanted = 2 + _below(chance, 2 + round(3.0 * hardness))
    while len(rings) < wanted:
        half_width = 0.25 + 0.25 * chance()
        radius = outer - half_width
        if radius - half_width < _INNERMOST:
            break
        rings.append(_ring(chance, hardness, radius, half_width, turns=len(rings) % 2 == 0))
        lane = _APART if chance() < 0.5 else 2.0 * _BALL * (1.6 + chance())
        outer = radius - half_width - lane
    return Level(
        name=GENERATED.format(number=number + 1),
        ground_radius=_GROUND,
        ball=BallSpec(_BALL, _rounded(7.5 + 2.5 * hardness + 0.5 * chance())),
        paddles=PaddleSpec(
            radius=_TRACK,
            half_width=0.2,
            half_angle=_rounded(27.0 - 6.0 * hardness),
            top_speed=_rounded(44.0 + 8.0 * hardness),
            acceleration=600.0,
            friction=0.5,
        ),
        rings=rings,
        description=tr_noop("A level from a seed: the same for everyone who plays it."),
    )


def _ring(chance: Chance, hardness: float, radius: float, half_width: float, *, turns: bool) -> RingSpec:
    """One ring. turns: whether counter-clockwise, if at all."""
    fold = 2 + _below(chance, 5)
    count = fold * max(2 + _below(chance, 4), round(radius * 1.6 / fold))
    share = 0.72 + 0.24 * chance()
    spin = (8.0 + 22.0 * chance()) * hardness if chance() < 0.3 + 0.5 * hardness else 0.0
    return RingSpec(
        radius=_rounded(radius),
        half_width=_rounded(half_width),
        half_angle=_rounded(share * 180.0 / count),
        count=count,
        layers=_pattern(chance, hardness, fold, count, radius - half_width),
        phase=_rounded(360.0 * chance()),
        spin=_rounded(spin if turns else -spin),
        friction=_rounded(0.5 * chance()) if spin else 0.0,
    )


def _pattern(chance: Chance, hardness: float, fold: int, count: int, inner: float) -> list[int]:
    """Layers that repeat `fold` times around the ring."""
    tallest = 1 + round(3.0 * hardness)
    part = [1 + _below(chance, tallest) if chance() < 0.85 else 0 for _ in range(count // fold)]
    steel = chance() < 0.15 + 0.25 * hardness
    pitch = 6.283 * inner / count
    if steel and len(part) >= 3 and (len(part) - 1) * pitch > _GATE * 2.0 * _BALL:
        part[0] = PERMANENT
    return part * fold


def _below(chance: Chance, count: int) -> int:
    """A whole number from 0 to below count."""
    return int(chance() * count)


def _rounded(value: float) -> float:
    """A number as a level file would write it."""
    return round(value, 2)
