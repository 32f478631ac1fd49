"""Random arenas, and the play that goes on in them."""

import math
from random import Random
from typing import NamedTuple

from physics import PERMANENT, Arena, Ball, Ring
from tools.fuzz.oracle import ring_gap

TICK = 1.0 / 240.0
TICKS = 100
"""Ticks of one case."""

_ROOM = 1e-6


class Case(NamedTuple):
    """Where a play begins."""

    arena: Arena
    speed: float
    chance: Random  # where a lost ball comes back


def random_case(seed: int, index: int) -> Case:
    """The arena of a number: 1 to 5 rings, 1 to 5 balls, up to 50 radii a tick, surfaces up to 0.99 of the balls' speed."""
    chance = Random(f"arena {seed} {index}")
    ball_radius = 10.0 ** chance.uniform(-1.3, -0.2)
    speed = 10.0 ** chance.uniform(-3.0, math.log10(50.0)) * ball_radius / TICK
    rings = _random_rings(chance, speed, ball_radius)
    layers = tuple([_random_layers(chance, ring.count) for ring in rings])
    arena = Arena((), rings, layers)
    for _ in range(chance.randint(1, 5)):
        arena = served(arena, len(arena.balls), ball_radius * chance.uniform(0.7, 1.0), speed, chance)
    return Case(arena, speed, chance)


def served(arena: Arena, index: int, ball_radius: float, speed: float, chance: Random) -> Arena:
    """The arena with one ball, new or come back, at a free place and in a direction drawn by chance."""
    edge = max([ring.radius + ring.half_width for ring in arena.rings]) + ball_radius
    p = complex(edge * 1.01, 0.0)
    for _ in range(30):
        there = chance.uniform(0.0, edge) * _unit(chance)
        if all(
            [ring_gap(there, ball_radius, r, 0.0, alive) > _ROOM for r, alive in zip(arena.rings, arena.layers, strict=True)]
        ):
            p = there
            break
    ball = Ball(p, speed * _unit(chance), ball_radius)
    return arena._replace(balls=(*arena.balls[:index], ball, *arena.balls[index + 1 :]))


def with_lost_balls_back(arena: Arena, speed: float, chance: Random) -> Arena:
    """The arena with every ball that left it served again."""
    edge = max([ring.radius + ring.half_width for ring in arena.rings])
    for index, ball in enumerate(arena.balls):
        if math.hypot(ball.position.real, ball.position.imag) > edge + 2.0 * ball.radius:
            arena = served(arena, index, ball.radius, speed, chance)
    return arena


def steered(arena: Arena, speed: float, chance: Random) -> Arena:
    """The arena, once in a while with another spin for a ring that turns, as a player would give it."""
    k = chance.randrange(8 * len(arena.rings))
    if k >= len(arena.rings) or arena.rings[k].spin == 0.0:
        return arena
    ring = arena.rings[k]
    turned = ring._replace(spin=chance.uniform(-0.99, 0.99) * speed / (ring.radius + ring.half_width))
    return arena._replace(rings=(*arena.rings[:k], turned, *arena.rings[k + 1 :]))


def _random_rings(chance: Random, speed: float, ball_radius: float) -> tuple[Ring, ...]:
    """Rings from the inside out, some flush with the one before, some closed, half of the arenas walled in."""
    rings: list[Ring] = []
    edge = chance.choice((0.01, 0.5, 1.0, 1.0)) * chance.uniform(0.5, 3.0)
    for _ in range(chance.randint(1, 5)):
        edge += chance.choice((0.0, chance.uniform(0.0, 2.0), chance.uniform(1.5, 4.0) * ball_radius))
        half_width = 10.0 ** chance.uniform(-1.5, 0.0)
        count = chance.choice((1, 1, 2, 3, 4, 8, 16, 24))
        fill = chance.choice((chance.uniform(0.02, 0.3), chance.uniform(0.3, 0.98), chance.uniform(0.3, 0.98), 1.0))
        edge += 2.0 * half_width
        spin = chance.choice((0.0, -1.0, 1.0)) * chance.choice((0.99, chance.uniform(0.0, 0.99), 0.1)) * speed / edge
        phase, friction = chance.uniform(0.0, math.tau), chance.choice((0.0, chance.random(), 1.0))
        rings.append(Ring(edge - half_width, half_width, fill * math.pi / count, count, phase, spin, friction))
    if chance.random() < 0.5:
        rings.append(Ring(edge + 3.0 * ball_radius + 0.1, 0.1, math.pi, 1, 0.0, 0.0, chance.random()))
    return tuple(rings)


def _random_layers(chance: Random, count: int) -> tuple[int, ...]:
    """Unbreakable paddles, or bricks of up to three layers with holes between them."""
    if count == 1 or chance.random() < 0.4:
        return (PERMANENT,) * count
    return tuple([chance.choice((PERMANENT, 0, 1, 2, 3)) for _ in range(count)])


def _unit(chance: Random) -> complex:
    """A direction of the plane."""
    angle = chance.uniform(0.0, math.tau)
    return complex(math.cos(angle), math.sin(angle))
