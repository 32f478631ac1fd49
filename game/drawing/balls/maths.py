"""The functions that a ball's shading needs, on numbers or on arrays: so one description serves where there is no numpy."""

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

if TYPE_CHECKING:  # in a browser there is no numpy
    from game.drawing.raster.annulus import Floats

Values = TypeVar("Values", float, "Floats")
"""A number, or an array of them."""
Planes = tuple[Values, Values, Values]
"""Red, green and blue, 0 to 255."""


class Maths(NamedTuple, Generic[Values]):
    """The functions, by numpy's names. pick: of some numbers the one of an index, which is rounded down."""

    sin: Callable[[Values], Values]
    sqrt: Callable[[Values], Values]
    hypot: Callable[[Values, Values], Values]
    arctan2: Callable[[Values, Values], Values]
    clip: Callable[[Values, float, float], Values]
    pick: Callable[[Sequence[float], Values], Values]


def _clip(value: float, low: float, high: float) -> float:
    """The nearest number within limits."""
    return low if value < low else min(value, high)


def _pick(numbers: Sequence[float], index: float) -> float:
    """The number of an index, rounded down."""
    return numbers[int(index)]


NUMBERS = Maths[float](math.sin, math.sqrt, math.hypot, math.atan2, _clip, _pick)
