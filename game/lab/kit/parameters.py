"""What of a scene can be set: numbers, counts and points with their ranges; and the values that they have."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from game.lab.kit.second_engine import Engine

_DIGITS = 10
"""Decimals of a value that is rounded to its step: enough for the finest step, too few for the noise of a float."""


class Number(NamedTuple):
    """A number with a unit.

    name: in the share line. label: in the source's letters. unit: "°" (angles are set in degrees), "rad/s", ... or "".
    low, high: the range, both included. step: a drag or a slider moves by multiples of it; a typed number need not.
    meaning: in a few words.
    """

    name: str
    label: str
    unit: str
    low: float
    high: float
    default: float
    step: float
    meaning: str = ""


class Count(NamedTuple):
    """A whole number. Its fields are those of `Number`; its step is 1."""

    name: str
    label: str
    low: int
    high: int
    default: int
    meaning: str = ""


class Point(NamedTuple):
    """A point, or a vector. Its fields are those of `Number`; low and high are the range of each coordinate."""

    name: str
    label: str
    low: float
    high: float
    default: complex
    step: float = 0.01
    meaning: str = ""


Parameter = Number | Count | Point


class Given(NamedTuple):
    """What a scene is given.

    values: one for each of its parameters. engine: a second engine to ask; None where there is none.
    """

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


class Clamped(NamedTuple):
    """Values inside their ranges. notes: one sentence for each requested value that was changed or refused."""

    given: Given
    notes: tuple[str, ...]


def defaults(parameters: Sequence[Parameter], engine: Engine | None = None) -> Given:
    """Every parameter at its default."""
    return Given({parameter.name: parameter.default for parameter in parameters}, engine)


def clamped(parameters: Sequence[Parameter], given: Given, requested: Mapping[str, complex]) -> Clamped:
    """The values after some parameters were requested to have others.

    A value beyond its range is set to the border, one that is not finite is refused; a note says so for each.
    """
    values, notes = dict(given.values), []
    for parameter in parameters:
        if parameter.name not in requested:
            continue
        value = requested[parameter.name]
        if not (math.isfinite(value.real) and math.isfinite(value.imag)):
            present = written(parameter, given.values[parameter.name])
            notes.append(f"{parameter.label} cannot be {written(parameter, value)}: it stays {present}")
            continue
        values[parameter.name] = _in_range(parameter, value)
        if values[parameter.name] != value:
            problem = "is beyond its range" if _is_beyond(parameter, value) else "is not a whole number"
            set_to = written(parameter, values[parameter.name])
            notes.append(f"{parameter.label} = {written(parameter, value)} {problem}: set to {set_to}")
    return Clamped(Given(values, given.engine), tuple(notes))


def snapped(parameters: Sequence[Parameter], requested: Mapping[str, complex]) -> dict[str, complex]:
    """The requested values rounded to each parameter's step, as a drag makes them. What is not finite stays so."""
    steps = {parameter.name: step_of(parameter) for parameter in parameters}
    return {name: _rounded(value, steps[name]) for name, value in requested.items()}


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


def step_of(parameter: Parameter) -> float:
    """What a drag moves a parameter by."""
    return 1.0 if isinstance(parameter, Count) else parameter.step


def _in_range(parameter: Parameter, value: complex) -> complex:
    """The value of the parameter's kind and range that is nearest to a requested one."""
    if isinstance(parameter, Point):
        return complex(_between(value.real, parameter), _between(value.imag, parameter))
    if isinstance(parameter, Count):
        return round(_between(value.real, parameter))
    return _between(value.real, parameter)


def _is_beyond(parameter: Parameter, value: complex) -> bool:
    """Whether a number, or a coordinate of a point, is out of the parameter's range."""
    numbers = (value.real, value.imag) if isinstance(parameter, Point) else (value.real,)
    return not all([parameter.low <= number <= parameter.high for number in numbers])


def _between(number: float, parameter: Parameter) -> float:
    """The number in the parameter's range nearest to a number."""
    return min(max(number, float(parameter.low)), float(parameter.high)) + 0.0


def _rounded(value: complex, step: float) -> complex:
    """A number, or both coordinates of a point, as multiples of a step."""
    if not (math.isfinite(value.real) and math.isfinite(value.imag)):
        return value
    x, y = (round(round(number / step) * step, _DIGITS) for number in (value.real, value.imag))
    return complex(x, y) if isinstance(value, complex) else x
