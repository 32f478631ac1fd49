"""Random draws for a level: every draw takes the next number of the level's generator."""

from collections.abc import Callable, Sequence
from typing import TypeVar

Chance = Callable[[], float]
"""Gives numbers from 0 to below 1."""

_Item = TypeVar("_Item")


def below(chance: Chance, count: int) -> int:
    """A random whole number from 0 to below count."""
    return int(chance() * count)


def between(chance: Chance, least: float, most: float) -> float:
    """A random number between two."""
    return least + (most - least) * chance()


def one_of(chance: Chance, items: Sequence[_Item]) -> _Item:
    """A random one of several items."""
    return items[below(chance, len(items))]


def sign(chance: Chance) -> float:
    """1 or -1 at random."""
    return 1.0 if chance() < 0.5 else -1.0


def rounded(value: float) -> float:
    """A number with as few digits as in a level file."""
    return round(value, 2)
