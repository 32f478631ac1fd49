"""Draws of a level: every one takes the next number of the level's seed."""

from collections.abc import Callable, Sequence
from typing import TypeVar

Chance = Callable[[], float]
"""Gives numbers from 0 to below 1."""

_Item = TypeVar("_Item")


def below(chance: Chance, count: int) -> int:
    """A whole number from 0 to below count."""
    return int(chance() * count)


def between(chance: Chance, least: float, most: float) -> float:
    """A number between two."""
    return least + (most - least) * chance()


def one_of(chance: Chance, items: Sequence[_Item]) -> _Item:
    """One of several."""
    return items[below(chance, len(items))]


def sign(chance: Chance) -> float:
    """1 or -1."""
    return 1.0 if chance() < 0.5 else -1.0


def rounded(value: float) -> float:
    """A number as a level file would write it."""
    return round(value, 2)
