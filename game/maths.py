"""Functions for formulas that take numbers or arrays, so that the same formula also works where there is no numpy."""

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

if TYPE_CHECKING:  # in a browser there is no numpy
    from game.array_maths import Arrays

Values = TypeVar("Values", float, "Arrays")
"""A number, or an array of them."""
Planes = tuple[Values, Values, Values]
"""Red, green and blue, 0 to 255."""


class Maths(NamedTuple, Generic[Values]):
    """The functions, by numpy's names. pick: the number at an index, which is rounded down."""

    sin: Callable[[Values], Values]
    cos: Callable[[Values], Values]
    sqrt: Callable[[Values], Values]
    hypot: Callable[[Values, Values], Values]
    arctan2: Callable[[Values, Values], Values]
    expm1: Callable[[Values], Values]
    clip: Callable[[Values, float, float], Values]
    minimum: Callable[[Values, Values], Values]
    pick: Callable[[Sequence[float], Values], Values]


def _clip(value: float, low: float, high: float) -> float:
    """The nearest number within limits."""
    return low if value < low else min(value, high)


def _least(one: float, other: float) -> float:
    """The smaller of two numbers."""
    return min(one, other)


def _pick(numbers: Sequence[float], index: float) -> float:
    """The number at an index; the index is rounded down."""
    return numbers[int(index)]


NUMBERS = Maths[float](math.sin, math.cos, math.sqrt, math.hypot, math.atan2, math.expm1, _clip, _least, _pick)
