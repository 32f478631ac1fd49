"""What of a scene can be set: numbers, counts and points with their ranges; and what it is set to."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from game.lab.kit.second_engine import Engine

_DIGITS = 10
"""Decimals kept of a value that is rounded to its step: enough for the finest step, too few for a float's noise."""


class Number(NamedTuple):
    """A number with a unit. Angles are degrees: that is what people read."""

    name: str  # in the share line
    label: str  # in the source's letters
    unit: str  # "°", "rad/s", ... or ""
    low: float
    high: float
    default: float
    step: float  # a drag or a slider moves by multiples of this; a typed number need not
    meaning: str = ""  # in a few words


class Count(NamedTuple):
    """A whole number."""

    name: str
    label: str
    low: int
    high: int
    default: int
    meaning: str = ""


class Point(NamedTuple):
    """A point, or a vector: two numbers of the same range."""

    name: str
    label: str
    low: float  # of each coordinate
    high: float
    default: complex
    step: float = 0.01
    meaning: str = ""


Parameter = Number | Count | Point


class Given(NamedTuple):
    """What a scene is given: a value for each of its parameters, and another engine to ask, if there is one."""

    values: Mapping[str, complex]
    engine: Engine | None = None

    def number(self, name: str) -> float:
        """A number in its own unit."""
        return self.values[name].real

    def angle(self, name: str) -> float:
        """A number of degrees, in radians."""
        return math.radians(self.values[name].real)

    def count(self, name: str) -> int:
        """A whole number."""
        return round(self.values[name].real)

    def point(self, name: str) -> complex:
        """A point."""
        return complex(self.values[name])


class Settled(NamedTuple):
    """Values inside their ranges, and what had to be changed to get there."""

    given: Given
    notes: tuple[str, ...]


def defaults(parameters: Sequence[Parameter], engine: Engine | None = None) -> Given:
    """Every parameter at its default."""
    return Given({parameter.name: parameter.default for parameter in parameters}, engine)


def settled(parameters: Sequence[Parameter], given: Given, wishes: Mapping[str, complex]) -> Settled:
    """The values after some of them were wished to be others.

    What lies beyond a range is set to its border, what is not finite is refused; a note says so for each.
    """
    values, notes = dict(given.values), []
    for parameter in parameters:
        if parameter.name not in wishes:
            continue
        wish = wishes[parameter.name]
        if not (math.isfinite(wish.real) and math.isfinite(wish.imag)):
            notes.append(f"{parameter.label} cannot be {written(parameter, wish)}: it stays {_shown(parameter, given)}")
            continue
        values[parameter.name] = _clamped(parameter, wish)
        if values[parameter.name] != wish:
            problem = "is beyond its range" if _is_beyond(parameter, wish) else "is not a whole number"
            set_to = written(parameter, values[parameter.name])
            notes.append(f"{parameter.label} = {written(parameter, wish)} {problem}: set to {set_to}")
    return Settled(Given(values, given.engine), tuple(notes))


def snapped(parameters: Sequence[Parameter], wishes: Mapping[str, complex]) -> dict[str, complex]:
    """The wishes rounded to each parameter's step, as a drag makes them. What is not finite stays so."""
    steps = {parameter.name: _step(parameter) for parameter in parameters}
    return {name: _rounded(wish, steps[name], point=isinstance(wish, complex)) for name, wish in wishes.items()}


def written(parameter: Parameter, value: complex) -> str:
    """A value with its unit, as short as is exact."""
    if isinstance(parameter, Point):
        return f"({plain(value.real)}, {plain(value.imag)})"
    unit = parameter.unit if isinstance(parameter, Number) else ""
    return plain(value.real) + (unit if unit in {"", "°"} else f" {unit}")


def plain(value: float) -> str:
    """The shortest decimal that is exactly this float: 25, 9.9, 1e-05.

    >>> plain(25.0), plain(9.9), plain(-0.0)
    ('25', '9.9', '0')
    """
    return repr(value + 0.0).removesuffix(".0")


def _shown(parameter: Parameter, given: Given) -> str:
    """The present value with its unit."""
    return written(parameter, given.values[parameter.name])


def _step(parameter: Parameter) -> float:
    """What a drag moves a parameter by."""
    return 1.0 if isinstance(parameter, Count) else parameter.step


def _clamped(parameter: Parameter, wish: complex) -> complex:
    """The value in the parameter's range nearest to the wish."""
    if isinstance(parameter, Point):
        return complex(_between(wish.real, parameter), _between(wish.imag, parameter))
    if isinstance(parameter, Count):
        return round(_between(wish.real, parameter))
    return _between(wish.real, parameter)


def _is_beyond(parameter: Parameter, wish: complex) -> bool:
    """Whether a number, or a coordinate of a point, is out of the parameter's range."""
    parts = (wish.real, wish.imag) if isinstance(parameter, Point) else (wish.real,)
    return not all([parameter.low <= part <= parameter.high for part in parts])


def _between(value: float, parameter: Parameter) -> float:
    """The number in the parameter's range nearest to a number."""
    return min(max(value, float(parameter.low)), float(parameter.high)) + 0.0


def _rounded(wish: complex, step: float, *, point: bool) -> complex:
    """A number, or both coordinates of a point, as multiples of a step."""
    if not (math.isfinite(wish.real) and math.isfinite(wish.imag)):
        return wish
    x, y = (round(round(part / step) * step, _DIGITS) for part in (wish.real, wish.imag))
    return complex(x, y) if point else x
