"""Inputs for the functions of angles and of polar coordinates."""

import math
from collections.abc import Iterator
from random import Random

from tools.vectors.inputs.chosen import ChosenInput, InputPlan, decimal, listed, polar_point, short

_TURN = 6.28
"""The largest angle of two decimals below 2 pi."""


def angle_lists() -> Iterator[ChosenInput]:
    """Calls on a boundary: 0, a full turn, and just below 0."""
    full = ((0.0,), (math.tau,), (-math.tau,), (-1e-17,), (math.pi,))
    yield from listed("normalize_angle", "boundary", *full)
    yield from listed("min_difference", "boundary", (0.0, 0.0), (1.5, 1.5), (0.0, math.pi), (math.pi, 0.0))
    axes = ((1.0, 0.0), (0.0, 2.0), (-3.0, 0.0), (0.0, -4.0), (5.0, 0.0), (-5.0, 0.0))
    yield from listed("to_polar", "axis", *axes)
    yield from listed("to_cartesian", "radius 0", (0.0, 0.0), (0.0, 1.0), (0.0, 4.0))


def angle_plans() -> tuple[InputPlan, ...]:
    """What is drawn for each trap."""
    one = (
        InputPlan("normalize_angle", "in range", 80, lambda c: (decimal(c, 0.01, _TURN),)),
        InputPlan("normalize_angle", "below 0", 120, lambda c: (decimal(c, -_TURN, -0.01),)),
        InputPlan("normalize_angle", "above 2 pi", 120, lambda c: (decimal(c, 6.29, 12.56),)),
        InputPlan("normalize_angle", "several turns", 120, lambda c: (c.choice([-1, 1]) * decimal(c, 12.57, 18.84),)),
        InputPlan("to_cartesian", "in range", 120, lambda c: (decimal(c, 0.1, 10.0), decimal(c, 0.01, _TURN))),
        InputPlan("to_cartesian", "below 0", 120, lambda c: (decimal(c, 0.1, 10.0), decimal(c, -_TURN, -0.01))),
        InputPlan("to_cartesian", "above 2 pi", 120, lambda c: (decimal(c, 0.1, 10.0), decimal(c, 6.29, 12.56))),
        *[InputPlan("to_polar", f"quadrant {k}", 100, lambda c, k=k: _in_quadrant(c, k)) for k in (1, 2, 3, 4)],  # type: ignore[misc]
    )
    return (*one, *_sums(), *_comparisons())


def _in_quadrant(chance: Random, number: int) -> tuple[float, float]:
    """A point of a quadrant, 1 to 4."""
    p = short(polar_point(decimal(chance, 0.5, 10.0), (number - 1 + chance.uniform(0.05, 0.95)) * math.pi / 2.0))
    return p.real, p.imag


def _sums() -> tuple[InputPlan, ...]:
    """Sums and differences that stay in range, and that leave it; of normalised angles, which slide 11 lets one assert."""
    return (
        InputPlan("add_angles", "in range", 160, lambda c: (decimal(c, 0.0, 3.1), decimal(c, 0.01, 3.1))),
        InputPlan("add_angles", "seam crossed", 240, lambda c: (decimal(c, 3.2, _TURN), decimal(c, 3.2, _TURN))),
        InputPlan("subtract_angles", "in range", 160, lambda c: (decimal(c, 3.2, _TURN), decimal(c, 0.01, 3.1))),
        InputPlan("subtract_angles", "seam crossed", 240, lambda c: (decimal(c, 0.01, 3.1), decimal(c, 3.2, _TURN))),
    )


def _comparisons() -> tuple[InputPlan, ...]:
    """Pairs of normalised angles, near to each other or far, on either side of the polar axis."""

    def near(chance: Random, low: float, high: float) -> tuple[float, float]:
        a = decimal(chance, 3.0, 3.3)
        return a, round(a + decimal(chance, low, high), 2)

    def across(chance: Random, *, up: bool) -> tuple[float, float]:
        small, large = decimal(chance, 0.01, 1.4), decimal(chance, 4.9, _TURN)
        return (small, large) if up else (large, small)

    plans = []
    for name in ("min_difference", "on_left"):
        plans += [
            InputPlan(name, "b above a", 90, lambda c: near(c, 0.01, 2.9)),
            InputPlan(name, "b below a", 90, lambda c: near(c, -2.9, -0.01)),
            InputPlan(name, "seam crossed upwards", 120, lambda c: across(c, up=True)),
            InputPlan(name, "seam crossed downwards", 120, lambda c: across(c, up=False)),
        ]
    return tuple(plans)
