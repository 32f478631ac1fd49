"""The signatures of the source's functions: arguments as a flat list of numbers, and the kind of the result."""

import math
import sys
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, TypeGuard

from game.student.slides import SlideFunctions

Result = float | bool | str | list[float] | None
"""A number, a truth value, one of OUTCOMES, two numbers (x and y, or radius and angle), or None for "no contact"."""

OUTCOMES = ("game over", "paddles", "bricks", "no collision")

KINDS = ("number", "angle", "truth", "outcome", "point", "polar", "normal")
"""Kinds of a result. angle: compared round the circle, and in [0, 2 pi]. polar: radius and angle. normal: a point, or None."""


class Signature(NamedTuple):
    """A function of the source.

    parameters: their names, in order. points: those of them that are points; each is two numbers, x and y. The last of
    `broad_phase`, `positions`, is all remaining numbers: r_p and theta_p of every paddle in turn. result: one of KINDS.
    slide: of the source.
    """

    name: str
    parameters: tuple[str, ...]
    points: frozenset[str]
    result: str
    slide: int

    @property
    def numbers(self) -> tuple[str, ...]:
        """The names of the numbers that are handed over."""
        return tuple(
            [part for name in self.parameters for part in ([f"{name}.x", f"{name}.y"] if name in self.points else [name])]
        )


def _signature(text: str, result: str, slide: int) -> Signature:
    """From a line such as "to_cartesian radius angle"; points are written with a star."""
    name, *parameters = text.split()
    names = tuple([parameter.rstrip("*") for parameter in parameters])
    points = frozenset([parameter.rstrip("*") for parameter in parameters if parameter.endswith("*")])
    return Signature(name, names, points, result, slide)


_ALL = (
    _signature("broad_phase_outcome p* r r_g r_p w_p r_b w_b", "outcome", 2),
    _signature("min_difference a b", "number", 3),
    _signature("broad_phase p* r theta w_p phi_p positions", "normal", 3),
    _signature("narrow_phase_case_1 p* r_p", "point", 4),
    _signature("on_left a b", "truth", 5),
    _signature("to_cartesian radius angle", "point", 5),
    _signature("closest_point_on_line a* b* p*", "point", 5),
    _signature("narrow_phase_case_2 p* r theta r_p theta_p w_p phi_p", "normal", 5),
    _signature("collision_response v* n* v_p* mu_p v_0", "point", 10),
    _signature("normalize_angle angle", "angle", 11),
    _signature("add_angles a b", "angle", 11),
    _signature("subtract_angles a b", "angle", 11),
    _signature("to_polar p*", "polar", 11),
)
SIGNATURES: Mapping[str, Signature] = {signature.name: signature for signature in _ALL}
"""Every function, in the order of the slides."""


def answer(functions: SlideFunctions, name: str, arguments: Sequence[float], number: Any = float) -> Result:
    """A function's result, rounded to floats. ZeroDivisionError where the slides divide by zero.

    number: turns each argument into a number of the functions' library.
    """
    signature, rest = SIGNATURES[name], [number(argument) for argument in arguments]
    values: list[Any] = []
    for parameter in signature.parameters:
        if parameter == "positions":
            values.append(list(zip(rest[::2], rest[1::2], strict=True)))
        elif parameter in signature.points:
            values.append(functions.point(rest.pop(0), rest.pop(0)))
        else:
            values.append(rest.pop(0))
    return _plain(getattr(functions, name)(*values), signature.result)


def _plain(value: Any, kind: str) -> Result:
    """A result of a kind as floats."""
    if value is None or kind in {"truth", "outcome"}:
        return value  # type: ignore[no-any-return]
    if kind in {"number", "angle"}:
        return float(value)
    return [float(part) + 0.0 for part in (value if kind == "polar" else (value.real, value.imag))]


def agrees(kind: str, given: object, expected: Result, tolerance: float) -> bool:
    """Whether a result is the expected one: every number within the tolerance, an angle round the circle and in [0, 2 pi]."""
    if expected is None or isinstance(expected, bool | str):
        return type(given) is type(expected) and given == expected
    numbers = expected if isinstance(expected, list) else [expected]
    found = _numbers(given) if isinstance(expected, list) else _numbers([given])
    if found is None or len(found) != len(numbers):
        return False
    angle = {"angle": 0, "polar": 1}.get(kind)
    return all(
        [
            _is_angle(one, other, tolerance) if i == angle else abs(one - other) <= tolerance
            for i, (one, other) in enumerate(zip(found, numbers, strict=True))
        ]
    )


def _numbers(given: object) -> list[float] | None:
    """A list of finite numbers; None for anything else."""
    if not isinstance(given, list):
        return None
    return [float(part) for part in given if is_number(part)] if all([is_number(part) for part in given]) else None


def is_number(value: object) -> TypeGuard[int | float]:
    """Whether something is a finite number, no truth value, and no integer larger than every float."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= sys.float_info.max


def _is_angle(one: float, other: float, tolerance: float) -> bool:
    """Whether an angle has the expected direction, and is normalised."""
    return -tolerance <= one <= math.tau + tolerance and abs(math.remainder(one - other, math.tau)) <= tolerance
