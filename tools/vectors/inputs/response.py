"""Inputs for the collision response: v, n, v_p, mu_p, v_0, with |v| = v_0 and n of length 1."""

from collections.abc import Iterator
from random import Random

from tools.vectors.inputs.chosen import ChosenInput, InputPlan, decimal, listed, unit

_SPEEDS = (1.0, 2.0, 2.5, 5.0, 7.5, 10.0)


def response_lists() -> Iterator[ChosenInput]:
    """Calls on a boundary: straight on, and a surface that retreats at half the ball's speed, which leaves v_res = 0."""
    name = "collision_response"
    straight = [(0.0, -5.0, 0.0, 1.0, 0.0, 0.0, mu, 5.0) for mu in (0.0, 0.5, 1.0)]
    yield from listed(name, "straight on", *straight, (-5.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 5.0))
    yield from listed(name, "v_res = 0", (0.0, -4.0, 0.0, 1.0, 0.0, -2.0, 1.0, 4.0), (-8.0, 0.0, 1.0, 0.0, -4.0, 0.0, 0.5, 8.0))
    yield from listed(name, "dv . n = 0", (5.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.5, 5.0), (0.0, 5.0, 1.0, 0.0, 0.0, 0.0, 1.0, 5.0))


def response_plans() -> tuple[InputPlan, ...]:
    """What is drawn for each trap: friction 0, between and 1, a surface at rest, sliding, coming and going."""
    name = "collision_response"
    return (
        InputPlan(name, "wall", 60, lambda c: _call(c, mu=_between(c))),
        InputPlan(name, "mu = 0", 60, lambda c: _call(c, mu=0.0, sliding=3.0)),
        InputPlan(name, "mu = 1", 60, lambda c: _call(c, mu=1.0, sliding=3.0)),
        InputPlan(name, "mu = 1, grazing", 60, lambda c: _call(c, mu=1.0, grazing=True, sliding=3.0)),
        InputPlan(name, "moving paddle", 80, lambda c: _call(c, mu=_between(c), sliding=3.0)),
        InputPlan(name, "paddle along n", 80, lambda c: _call(c, mu=_between(c), sliding=1.0, coming=(-0.4, 0.4))),
        InputPlan(name, "separating", 80, lambda c: _call(c, mu=_between(c), sliding=1.0, away=True)),
        InputPlan(name, "carried", 60, _carried),
    )


def _between(chance: Random) -> float:
    """A friction between 0 and 1."""
    return decimal(chance, 0.1, 0.9)


def _carried(chance: Random) -> tuple[float, ...]:
    """A grazing ball, and a surface that comes after it almost as fast as the ball is, and drags it sideways."""
    n, speed, side = unit(chance), chance.choice(_SPEEDS), chance.choice([-1, 1])
    v = _tidy(n * complex(-0.28, 0.96 * side) * speed)
    v_p = _tidy(n * complex(decimal(chance, 0.8, 0.97), decimal(chance, 2.0, 4.0) * side) * speed)
    return v.real, v.imag, n.real, n.imag, v_p.real, v_p.imag, decimal(chance, 0.5, 1.0), speed


def _call(
    chance: Random,
    mu: float,
    *,
    sliding: float = 0.0,
    coming: tuple[float, float] = (0.0, 0.0),
    grazing: bool = False,
    away: bool = False,
) -> tuple[float, ...]:
    """A ball and a surface.

    sliding: largest speed of the surface along itself. coming: range of its speed along n, as a share of v_0.
    grazing: |dv_t| > |dv_n|. away: the two separate.
    """
    n, speed = unit(chance), chance.choice(_SPEEDS)
    heading = unit(chance)
    while (abs(heading.real) < abs(heading.imag)) is not grazing:
        heading = unit(chance)
    forward = abs(heading.real) if away else -abs(heading.real)
    v = _tidy(n * complex(forward, heading.imag) * speed)
    v_p = _tidy(n * complex(decimal(chance, *coming) * speed, decimal(chance, -sliding, sliding)))
    return v.real, v.imag, n.real, n.imag, v_p.real, v_p.imag, mu, speed


def _tidy(p: complex) -> complex:
    """Without the noise of the multiplication: six decimals hold the products exactly, or nearly so."""
    return complex(round(p.real, 6) + 0.0, round(p.imag, 6) + 0.0)
