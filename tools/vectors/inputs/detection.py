"""Inputs for the broad phase and the narrow phase."""

import math
from collections.abc import Iterator
from random import Random

from tools.vectors.inputs.chosen import ChosenInput, InputPlan, angle_of, decimal, listed, polar_point, short, unit

_ASSIGNMENT = 3
"""Paddles in the assignment."""


def detection_lists() -> Iterator[ChosenInput]:
    """Calls on a boundary, with numbers that floats hold exactly: |p| = 5 for p = (3, 4)."""
    rings = (8.0, 0.5, 2.0, 0.5)
    yield from listed(
        "narrow_phase_case_1", "|p| = r_p", (3.0, 4.0, 5.0), (-4.0, 3.0, 5.0), (0.0, -5.0, 5.0), (6.0, -8.0, 10.0)
    )
    outcomes = (
        (3.0, 4.0, 0.5, 4.5, *rings),
        (3.0, 4.0, 2.5, 12.0, *rings),
        (6.0, 8.0, 1.5, 12.0, *rings),
        (3.0, 4.0, 2.5, 12.0, 9.0, 0.5, 2.0, 0.5),
    )
    yield from listed("broad_phase_outcome", "boundary", *outcomes)
    yield from listed("closest_point_on_line", "A = B", (1.0, 2.0, 1.0, 2.0, 3.0, 4.0), (0.0, 0.0, 0.0, 0.0, 0.0, 5.0))
    yield from listed("closest_point_on_line", "p on the line", (0.0, 0.0, 4.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 4.0, 0.0, 3.0))
    yield from listed("narrow_phase_case_1", "p = 0", (0.0, 0.0, 5.0))


def detection_plans() -> tuple[InputPlan, ...]:
    """What is drawn for each trap."""
    return (*_outcome_plans(), *_closest_plans(), *_case_1_plans(), *_case_2_plans(), *_broad_plans())


def _outcome_plans() -> tuple[InputPlan, ...]:
    """A ball at each distance that matters: nearer and farther than every border, with its radius and without."""

    def at(chance: Random, low: float, high: float) -> tuple[float, ...]:
        p = short(polar_point(decimal(chance, low, high), chance.uniform(0.0, math.tau)))
        r_p, w_p = decimal(chance, 9.5, 10.5), decimal(chance, 0.2, 0.6)
        return p.real, p.imag, decimal(chance, 0.3, 1.0), 12.0, r_p, w_p, decimal(chance, 4.5, 5.5), decimal(chance, 0.5, 1.0)

    ranges = {
        "in the hole": (0.1, 2.4),
        "at the bricks": (2.5, 7.5),
        "between": (7.0, 8.5),
        "at the paddles": (8.0, 12.0),
        "near the rim": (11.0, 13.5),
        "beyond the rim": (13.6, 15.0),
    }
    return tuple(
        [InputPlan("broad_phase_outcome", trap, 80, lambda c, span=span: at(c, *span)) for trap, span in ranges.items()]  # type: ignore[misc]
    )


def _closest_plans() -> tuple[InputPlan, ...]:
    """A line, and a point before, beside and beyond it."""

    def beside(chance: Random, low: float, high: float, direction: complex | None = None) -> tuple[float, ...]:
        a = complex(decimal(chance, -4.0, 4.0), decimal(chance, -4.0, 4.0))
        along = unit(chance) if direction is None else direction * chance.choice([-1, 1])
        b = short(a + along * decimal(chance, 1.0, 4.0))
        side = 1j * (b - a) * chance.choice([-1, 1]) * chance.uniform(0.2, 0.9)
        p = short(a + (b - a) * chance.uniform(low, high) + side)
        return a.real, a.imag, b.real, b.imag, p.real, p.imag

    name = "closest_point_on_line"
    return (
        InputPlan(name, "between A and B", 120, lambda c: beside(c, 0.05, 0.95)),
        InputPlan(name, "upright line", 80, lambda c: beside(c, 0.05, 0.95, 1j)),
        InputPlan(name, "level line", 80, lambda c: beside(c, 0.05, 0.95, 1 + 0j)),
        InputPlan(name, "beyond A", 80, lambda c: beside(c, -1.0, -0.1)),
        InputPlan(name, "beyond B", 80, lambda c: beside(c, 1.1, 2.0)),
    )


def _case_1_plans() -> tuple[InputPlan, ...]:
    """A ball inside of the middle radius, and outside of it."""

    def at(chance: Random, low: float, high: float) -> tuple[float, float, float]:
        r_p = decimal(chance, 4.0, 11.0)
        p = short(polar_point(r_p + chance.uniform(low, high), chance.uniform(0.0, math.tau)))
        return p.real, p.imag, r_p

    return (
        InputPlan("narrow_phase_case_1", "|p| < r_p", 200, lambda c: at(c, -1.5, -0.02)),
        InputPlan("narrow_phase_case_1", "|p| > r_p", 200, lambda c: at(c, 0.02, 1.5)),
    )


def _at_end(
    chance: Random, sign: int, half_angle: tuple[float, float], along: tuple[float, float], seam: int = 0
) -> tuple[float, ...]:
    """A ball beside an end: p, r, theta, r_p, theta_p, w_p, phi_p.

    sign: of the end. half_angle: range of phi_p. along: range of the distance from the end's middle, in half widths. seam: 0
    anywhere; 1 where theta_p is just above the polar axis, -1 just below.
    """
    r_p, w_p, phi_p, r = (
        decimal(chance, 6.0, 11.0),
        decimal(chance, 0.2, 1.2),
        decimal(chance, *half_angle),
        decimal(chance, 0.3, 1.2),
    )
    theta_p = decimal(chance, 0.0, 6.28)
    if seam:
        theta_p = round(chance.uniform(0.0, phi_p) if seam > 0 else math.tau - chance.uniform(0.01, phi_p), 2)
    end = theta_p + sign * phi_p
    across = 1j * sign * polar_point(1.0, end) * r * chance.uniform(0.1, 0.9)
    p = short(polar_point(r_p + chance.choice([-1, 1]) * w_p * chance.uniform(*along), end) + across)
    return p.real, p.imag, r, angle_of(p), r_p, theta_p, w_p, phi_p


def _case_2_plans() -> tuple[InputPlan, ...]:
    """A ball beside either end, also across the polar axis, at a corner, beside a wide sector, and too far away."""
    usual, wide, middle, corner = (0.1, 0.6), (1.7, 2.6), (0.0, 0.9), (1.05, 1.6)

    def far(chance: Random) -> tuple[float, ...]:
        px, py, r, _, *sector = _at_end(chance, chance.choice([-1, 1]), usual, middle)
        p = short(complex(px, py) * polar_point(1.0, chance.uniform(1.2, 2.0) * chance.choice([-1, 1])))
        return p.real, p.imag, r, angle_of(p), *sector

    name = "narrow_phase_case_2"
    return (
        InputPlan(name, "counter-clockwise end", 80, lambda c: _at_end(c, 1, usual, middle)),
        InputPlan(name, "clockwise end", 80, lambda c: _at_end(c, -1, usual, middle)),
        InputPlan(name, "seam crossed counter-clockwise", 80, lambda c: _at_end(c, 1, usual, middle, -1)),
        InputPlan(name, "seam crossed clockwise", 80, lambda c: _at_end(c, -1, usual, middle, 1)),
        InputPlan(name, "too far", 60, far),
        InputPlan(name, "corner", 80, lambda c: _at_end(c, c.choice([-1, 1]), usual, corner)),
        InputPlan(name, "wide sector", 80, lambda c: _at_end(c, c.choice([-1, 1]), wide, middle)),
    )


def _paddles(chance: Random, call: tuple[float, ...]) -> tuple[float, ...]:
    """A call of case 2 as one of the broad phase: its sector among others, evenly spaced, in any order."""
    px, py, r, theta, r_p, theta_p, w_p, phi_p = call
    positions = [(r_p, round((theta_p + k * math.tau / _ASSIGNMENT) % math.tau, 2)) for k in range(_ASSIGNMENT)]
    chance.shuffle(positions)
    return px, py, r, theta, w_p, phi_p, *[number for position in positions for number in position]


def _over(chance: Random, seam: int = 0) -> tuple[float, ...]:
    """A ball within the angle of a sector: a call of case 2, which the broad phase answers with case 1."""
    *_, r, _, r_p, theta_p, w_p, phi_p = _at_end(chance, seam or 1, (0.2, 0.6), (0.0, 0.9), seam)
    side = chance.choice([-1, 1])
    turned = -seam * phi_p * 0.9 if seam else chance.uniform(-0.9, 0.9) * phi_p
    p = short(polar_point(r_p + side * (w_p + r * chance.uniform(0.1, 0.9)), theta_p + turned))
    return p.real, p.imag, r, angle_of(p), r_p, theta_p, w_p, phi_p


def _broad_plans() -> tuple[InputPlan, ...]:
    """One of three paddles, near a face or an end, on either side of the polar axis; and one paddle alone."""
    usual, middle = (0.1, 0.6), (0.0, 0.9)

    def alone(chance: Random) -> tuple[float, ...]:
        px, py, r, theta, r_p, theta_p, w_p, phi_p = _over(chance)
        return px, py, r, theta, w_p, phi_p, r_p, theta_p

    name = "broad_phase"
    return (
        InputPlan(name, "face", 100, lambda c: _paddles(c, _over(c))),
        InputPlan(name, "face, seam crossed", 100, lambda c: _paddles(c, _over(c, c.choice([-1, 1])))),
        InputPlan(name, "end", 100, lambda c: _paddles(c, _at_end(c, c.choice([-1, 1]), usual, middle))),
        InputPlan(
            name,
            "end, seam crossed",
            100,
            lambda c: _paddles(c, _at_end(c, *c.choice([(1, usual, middle, -1), (-1, usual, middle, 1)]))),
        ),
        InputPlan(name, "one paddle", 60, alone),
    )
