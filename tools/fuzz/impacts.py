"""Random cases for `time_of_impact` alone, their gaps evaluated with 50 digits."""

import importlib
import math
from collections.abc import Sequence
from random import Random
from typing import Any, NamedTuple

from physics import Ball, Impact, Ring, time_of_impact
from tools.fuzz.oracle import first_overlap, ring_gap

TOLERANCE = 1e-12
"""World units: the promised accuracy of the gap at the time of impact."""

_TICK = 1.0 / 240.0
_FINEST = 1e-6


class ImpactCase(NamedTuple):
    """One question to `time_of_impact`."""

    ball: Ball
    ring: Ring
    dt: float
    alive: tuple[int, ...]


def multiprecision() -> Any:
    """The mpmath library, set to 50 digits. ImportError where it is not installed."""
    mpmath = importlib.import_module("mpmath")  # noqa: TID251  # may be missing
    mpmath.mp.dps = 50
    return mpmath


def random_impact(seed: int, index: int) -> ImpactCase:
    """The case of a number: a free ball and a ring of size 10 at most, up to 50 radii of flight, up to a turn of spin."""
    chance = Random(f"impact {seed} {index}")
    while True:
        ring = _random_ring(chance)
        ball_radius = 10.0 ** chance.uniform(-2.0, 0.0)
        alive = tuple([int(chance.random() < 0.7) for _ in range(ring.count)])
        outer = ring.radius + ring.half_width + ball_radius
        p = chance.uniform(0.0, 1.2 * outer) * _unit(chance)
        if ring_gap(p, ball_radius, ring, 0.0, alive) < 0.0:
            continue
        travel = chance.choice((0.0, chance.uniform(0.0, 1.0), chance.uniform(0.0, 50.0), 10.0 ** chance.uniform(-6.0, 0.0)))
        v = travel * ball_radius / _TICK * _unit(chance)
        if chance.random() < 0.3:
            p, v = _near_graze(chance, ring, ball_radius, p, v)
            if ring_gap(p, ball_radius, ring, 0.0, alive) < 0.0:
                continue
        return ImpactCase(Ball(p, v, ball_radius), ring, _TICK, alive)


def fault(case: ImpactCase, found: Impact | None, mpmath: Any) -> str | None:
    """What is wrong with an answer of `time_of_impact`; None if nothing is."""
    ball, ring, dt, alive = case
    if found is not None:
        if not 0.0 <= found.time <= dt:
            return f"the time {found.time} is outside [0, {dt}]"
        if not (0 <= found.slot < ring.count and alive[found.slot]):
            return f"slot {found.slot} holds no sector"
        gap = exact_gap(case, found.time, found.slot, mpmath)
        if abs(gap) > TOLERANCE:
            return f"the gap at the reported time is {mpmath.nstr(gap, 5)}"
    stop = dt if found is None else found.time
    missed = first_overlap(ball, ring, 0.0, stop, alive, TOLERANCE, _FINEST)
    return None if missed is None else f"the ball overlaps at {missed}, reported: {found and found.time}"


def exact_gap(case: ImpactCase, time: float, slot: int, mpmath: Any) -> Any:
    """The gap between the ball and one sector at a time, with 50 digits."""
    ball, ring = case.ball, case.ring
    t = mpmath.mpf(time)
    x = mpmath.mpf(ball.position.real) + mpmath.mpf(ball.velocity.real) * t
    y = mpmath.mpf(ball.position.imag) + mpmath.mpf(ball.velocity.imag) * t
    middle = mpmath.mpf(ring.phase) + 2 * mpmath.pi * slot / ring.count + mpmath.mpf(ring.spin) * t
    offset = mpmath.atan2(y, x) - middle
    offset -= 2 * mpmath.pi * mpmath.nint(offset / (2 * mpmath.pi))
    distance = mpmath.hypot(x, y)
    inner = mpmath.mpf(ring.radius) - mpmath.mpf(ring.half_width)
    outer = mpmath.mpf(ring.radius) + mpmath.mpf(ring.half_width)
    beside = abs(offset) - mpmath.mpf(ring.half_angle)
    if beside <= 0:
        return max(inner - distance, distance - outer) - mpmath.mpf(ball.radius)
    along, across = distance * mpmath.cos(beside), distance * mpmath.sin(beside)
    return mpmath.hypot(along - min(max(along, inner), outer), across) - mpmath.mpf(ball.radius)


def check_impacts(seed: int, indices: Sequence[int], mpmath: Any) -> tuple[int, list[tuple[int, str]]]:
    """How many of the cases touch, and the faults found: (index, what is wrong)."""
    touches, faults = 0, []
    for index in indices:
        case = random_impact(seed, index)
        found = time_of_impact(case.ball, case.ring, case.dt, case.alive)
        touches += found is not None
        wrong = fault(case, found, mpmath)
        if wrong is not None:
            faults.append((index, wrong))
    return touches, faults


def checked_chunk(job: tuple[int, range]) -> tuple[int, int, list[tuple[int, str]]]:
    """How many cases of a seed were checked, how many of them touch, and the faults found. job: the seed and the indices."""
    seed, indices = job
    return (len(indices), *check_impacts(seed, indices, multiprecision()))


def _random_ring(chance: Random) -> Ring:
    """Paddles or bricks: narrow and wide sectors, full rings, thin and thick ones, at rest and up to a turn a tick."""
    radius = chance.uniform(0.5, 9.0)
    half_width = min(10.0 ** chance.uniform(-2.0, 0.0), 0.95 * radius, 10.0 - radius)
    count = chance.choice((1, 1, 2, 3, 4, 7, 16, 48))
    fill = chance.choice((1.0, chance.uniform(0.01, 0.3), chance.uniform(0.3, 0.99), chance.uniform(0.9, 0.999)))
    turn = chance.choice((0.0, chance.uniform(-0.05, 0.05), chance.uniform(-2.0 * math.pi, 2.0 * math.pi)))
    return Ring(radius, half_width, fill * math.pi / count, count, chance.uniform(0.0, 2.0 * math.pi), turn / _TICK)


def _near_graze(chance: Random, ring: Ring, ball_radius: float, p: complex, v: complex) -> tuple[complex, complex]:
    """A flight that passes the edge of the band, or a corner at rest, by next to nothing."""
    miss = chance.choice((0.0, 1.0, -1.0)) * 10.0 ** chance.uniform(-16.0, -3.0)
    speed = math.hypot(v.real, v.imag)
    if chance.random() < 0.5:
        edge = ring.radius + ring.half_width + ball_radius
        toward = _unit(chance)
        target = toward * (edge + miss)
        along = toward * 1j
    else:
        end = ring.phase + chance.choice((-1.0, 1.0)) * ring.half_angle
        corner = (ring.radius + chance.choice((-1.0, 1.0)) * ring.half_width) * complex(math.cos(end), math.sin(end))
        toward = _unit(chance)
        target = corner + toward * (ball_radius + miss)
        along = toward * 1j
    before = speed * _TICK * chance.random()
    return (target - along * before, along * speed) if speed > 0.0 else (p, v)


def _unit(chance: Random) -> complex:
    """A direction of the plane."""
    angle = chance.uniform(0.0, 2.0 * math.pi)
    return complex(math.cos(angle), math.sin(angle))
