"""Arguments for a function, chosen for a trap; and how their numbers are drawn."""

import math
from collections.abc import Callable, Iterator
from random import Random
from typing import NamedTuple

UNITS = (1 + 0j, 0.6 + 0.8j, 0.8 + 0.6j, 0.28 + 0.96j, 0.96 + 0.28j, 0.352 + 0.936j, 0.936 + 0.352j)
"""Directions of length 1 whose coordinates are short decimals; quarter turns of them are as short."""


class ChosenInput(NamedTuple):
    """Arguments in the order of `Signature.numbers`, and the trap that they are chosen for."""

    function: str
    trap: str
    arguments: tuple[float, ...]


Draw = Callable[[Random], tuple[float, ...]]
"""Draws the arguments of one call."""


class InputPlan(NamedTuple):
    """How many vectors of a trap there are, and how one is drawn."""

    function: str
    trap: str
    amount: int
    draw: Draw


def listed(function: str, trap: str, *calls: tuple[float, ...]) -> Iterator[ChosenInput]:
    """Calls that are written down: on a boundary, where floats decide as the slides do however the formula is computed."""
    for arguments in calls:
        yield ChosenInput(function, trap, arguments)


def decimal(chance: Random, low: float, high: float) -> float:
    """A number of two decimals."""
    return round(chance.uniform(low, high), 2) + 0.0


def unit(chance: Random) -> complex:
    """A direction of length 1, in short decimals."""
    return complex(chance.choice(UNITS) * 1j ** chance.randrange(4))


def short(p: complex) -> complex:
    """A point rounded to two decimals."""
    return complex(round(p.real, 2) + 0.0, round(p.imag, 2) + 0.0)


def polar_point(radius: float, angle: float) -> complex:
    """A point at a radius and an angle."""
    return complex(radius * math.cos(angle), radius * math.sin(angle))


def angle_of(p: complex) -> float:
    """Its angle in [0, 2 pi)."""
    return math.atan2(p.imag, p.real) % math.tau
