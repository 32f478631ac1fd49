"""Which functions are proved, on which boxes, and within what."""

import math
from collections.abc import Callable, Sequence
from typing import Any

from flint import arb

import physics
from tools.certify.boxes import formulas
from tools.certify.boxes.rounded import BranchBorderError, Rounded, RoundedMath, RoundedPoint, number
from tools.certify.boxes.same_code import on_other_numbers
from tools.certify.boxes.series import SeriesMath, direction_off
from tools.certify.boxes.subdivision import Box, Range

DIRECTION = 2e-15
"""What `physics.direction` may be off by: its own promise, proved by the first box, and used by those with sectors."""

LARGEST_ANGLE = 8.0
"""Radians: how far the first box reaches."""

_TURN = (0.0, math.nextafter(math.tau, 0.0))
_ANGLES = (0.015625, 6.28125)
_PADDLE = (0.2, 0.57, 5.0, 0.2, 0.4, 0.3)
"""A ball's radius and angle beside the counter-clockwise end of a sector: radius, middle angle, half width, half angle."""


def boxes() -> list[Box]:
    """All of them. The process's precision must be set."""
    return [*_directions(), *_angles(), *_lines(), *_faces(), *_ends()]


def _directions() -> list[Box]:
    """`direction`: of any angle up to more than a turn to either side."""
    code = _code(physics.direction)
    on_series = on_other_numbers(physics.direction, {"math": SeriesMath, "complex": lambda cosine, sine: (cosine, sine)})
    return [
        Box(
            "direction, an angle in [-8, 8]",
            ((-LARGEST_ANGLE, LARGEST_ANGLE),),
            lambda x: code(x[0]),
            formulas.direction,
            DIRECTION,
            lambda middle, side: direction_off(on_series, middle, side),
        )
    ]


def _angles() -> list[Box]:
    """`min_difference`: of two normalised angles; and of one and 0, either way round, down to the last bits.

    The function depends on the difference of its arguments, rounded, alone: the last two boxes hold every difference.
    """
    code = _code(physics.min_difference)
    return [
        Box(
            "min_difference, two angles in [1/64, 6 + 9/32]",
            (_ANGLES, _ANGLES),
            lambda x: code(*x),
            formulas.min_difference,
            2e-15,
        ),
        Box(
            "min_difference, an angle in [0, 2 pi) and 0",
            (_TURN,),
            lambda x: code(x[0], number(0.0)),
            lambda x: formulas.min_difference([x[0], arb(0)]),
            2e-15,
        ),
        Box(
            "min_difference, 0 and an angle in [0, 2 pi)",
            (_TURN,),
            lambda x: code(number(0.0), x[0]),
            lambda x: formulas.min_difference([arb(0), x[0]]),
            2e-15,
        ),
    ]


def _lines() -> list[Box]:
    """`closest_point_on_line`: beside a segment, beyond either end, and all around a narrower set of segments."""
    code = _code(physics.closest_point_on_line)

    def call(x: Sequence[Rounded]) -> Any:
        return code(RoundedPoint(x[0], x[1]), RoundedPoint(x[2], x[3]), RoundedPoint(x[4], x[5]))

    def box(name: str, *ranges: Range) -> Box:
        return Box(f"closest_point_on_line, {name}", ranges, call, formulas.closest_point_on_line, 1e-14)

    segments: tuple[Range, ...] = ((4.5, 4.7), (-0.1, 0.1), (5.3, 5.5), (-0.1, 0.1))
    narrow = tuple([((a + b) / 2.0, (a + b) / 2.0 + 2.0**-20) for a, b in segments])
    return [
        box("beside", *segments, (4.9, 5.1), (0.05, 0.5)),
        box("before the start", *segments, (0.0, 4.3), (-1.0, 1.0)),
        box("beyond the end", *segments, (5.8, 10.0), (-1.0, 1.0)),
        box("all around", *narrow, (0.0, 10.0), (-5.0, 5.0)),
    ]


def _faces() -> list[Box]:
    """`narrow_phase_case_1`: every point of the ground, around a ring's middle radius."""
    code = _code(physics.narrow_phase_case_1)
    return [
        Box(
            "narrow_phase_case_1, all of the ground",
            ((-12.0, 12.0), (-12.0, 12.0), (4.999, 5.001)),
            lambda x: code(RoundedPoint(x[0], x[1]), x[2]),
            formulas.narrow_phase_case_1,
            1e-15,
        )
    ]


def _ends() -> list[Box]:
    """`narrow_phase_case_2`: beside an end, at its corners, and around it."""
    code = _code(physics.narrow_phase_case_2, direction=_direction)

    def call(x: Sequence[Rounded]) -> Any:
        return code(RoundedPoint(x[0], x[1]), *x[2:])

    def box(name: str, bound: float, *ranges: Range) -> Box:
        return Box(f"narrow_phase_case_2, {name}", ranges, call, formulas.narrow_phase_case_2, bound)

    end = complex(math.cos(0.5), math.sin(0.5))

    def near(along: float, above: float, size: float) -> tuple[Range, Range]:
        p = end * complex(along, above)
        return (p.real - size, p.real + size), (p.imag - size, p.imag + size)

    wide, narrow = (tuple([(value, value + size) for value in _PADDLE]) for size in (2.0**-10, 2.0**-24))
    return [
        box("beside the end", 1e-14, *near(5.0, 0.1, 0.03), *wide),
        box("outer corner", 1e-12, *near(5.5, 0.1, 0.03), *wide),
        box("inner corner", 1e-12, *near(4.5, 0.1, 0.03), *wide),
        box("out of reach", 1e-12, *near(5.0, 0.5, 0.1), *wide),
        box("all around the end", 1e-12, *near(5.0, 0.3, 0.25), *narrow),
    ]


def _code(function: Callable[..., Any], **names: Any) -> Callable[..., Any]:
    """A function of the physics on `Rounded` numbers."""
    return on_other_numbers(function, {"math": RoundedMath(), "complex": RoundedPoint, **names})


def _direction(angle: Rounded) -> RoundedPoint:
    """`physics.direction` by its promise: cosine and sine, off by what the angle is off and by DIRECTION."""
    if not abs(angle.computed) <= LARGEST_ANGLE:
        raise BranchBorderError("the angle is beyond what is proved of direction")
    sine, cosine = angle.exact.sin_cos()
    error = angle.error + arb(DIRECTION)
    return RoundedPoint(Rounded(cosine, error), Rounded(sine, error))
