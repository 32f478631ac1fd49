"""Single ticks of small arenas, each checked by the fuzzer's oracle."""

import cmath
import math

from physics import PERMANENT, Arena, Ring, advance
from tests.support.oracles.impact_oracle import gap
from tools.fuzz.checks import first_fault

TICK = 1.0 / 240.0
R = 0.25
SPEED = 8.0


def at(radius, angle):
    """A point in polar coordinates."""
    return cmath.rect(radius, angle)


def arena(balls, *given, layers=None):
    """An arena of permanent sectors unless said otherwise."""
    return Arena(tuple(balls), tuple(given), tuple(layers or [(PERMANENT,) * ring.count for ring in given]))


def ticked(before, dt=TICK, speed=SPEED):
    """`advance`, its result checked by the fuzzer's oracle."""
    step = advance(before, dt, speed)
    assert first_fault(before, step, dt, speed) is None
    return step


def played(before, ticks, dt=TICK, speed=SPEED):
    """Many ticks: the last arena, all hits with their times since the start, and the counts."""
    hits, dropped, freed = [], 0, 0
    for tick in range(ticks):
        step = ticked(before, dt, speed)
        hits += [hit._replace(time=tick * dt + hit.time) for hit in step.hits]
        dropped, freed, before = dropped + step.dropped, freed + step.freed, step.arena
    return before, hits, dropped, freed


def penetration(state):
    """How deep any ball overlaps anything, in radii."""
    depths = [0.0]
    for ball in state.balls:
        for ring, alive in zip(state.rings, state.layers, strict=True):
            slots = [slot for slot in range(ring.count) if alive[slot]]
            if slots:
                depths.append(-gap(ball, ring, 0.0, slots) / ball.radius)
    return max(depths)


PADDLE = Ring(10.0, 0.5, 0.3, 1)
WALL = Ring(13.0, 0.5, math.pi, 1)
