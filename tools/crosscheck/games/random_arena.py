"""Arenas drawn from a seed: wide and narrow sectors, closed rings, seams, turning bricks, several balls."""

import math
import random
from collections.abc import Iterator

from physics import PERMANENT, Arena, Ball, Ring, to_cartesian
from tools.crosscheck.games.level_numbers import numbers_of_arena
from tools.crosscheck.games.trajectory import Advance, Tick

TICK = 1.0 / 240.0
_TRACK = 9.5
_LEAST_ROOM = 0.2
_FASTEST = 0.8
"""Fraction of the balls' speed that the rim of a ring may reach."""


def random_ticks(seed: int, ticks: int, physics: Advance) -> Iterator[Tick]:
    """Balls in an arena drawn from the seed; paddles that change their mind; lost balls come back, broken walls too."""
    chance = random.Random(seed)
    speed = chance.uniform(6.0, 14.0)
    ball_radius = chance.uniform(0.1, 0.35)
    arena, fresh = _arena(chance, speed, ball_radius)
    level = numbers_of_arena(arena, speed)
    for number in range(ticks):
        if number % 60 == 0:
            arena = _steered(arena, chance, speed)
        step = physics(arena, TICK, speed)
        yield Tick(number, arena, TICK, step, level)
        arena = step.arena
        if any(abs(ball.position) > _TRACK + 2.0 for ball in arena.balls):
            balls = tuple(_served(chance, speed, ball_radius) if abs(b.position) > _TRACK + 2.0 else b for b in arena.balls)
            arena = arena._replace(balls=balls)
        if not any(layers > 0 for ring in arena.layers for layers in ring):
            balls = tuple(_served(chance, speed, ball_radius) for _ in arena.balls)
            arena = arena._replace(layers=fresh, balls=balls)
            level = numbers_of_arena(arena, speed)


def _arena(chance: random.Random, speed: float, ball_radius: float) -> tuple[Arena, tuple[tuple[int, ...], ...]]:
    """Paddles, one to four rings of bricks below them, and one to four balls."""
    count = chance.choice((1, 2, 3, 4, 5))
    half_width = chance.uniform(0.1, 0.4)
    paddles = Ring(
        _TRACK, half_width, chance.uniform(0.5, 0.95) * math.pi / count, count, friction=chance.choice((0.0, 0.5, 1.0))
    )
    rings, layers = [paddles], [(PERMANENT,) * count]
    outside = _TRACK - half_width - chance.uniform(1.0, 3.0)
    for _ in range(chance.randint(1, 4)):
        half_width = chance.uniform(0.1, 0.5)
        inner = outside - 2.0 * half_width
        if inner < _free_radius(ball_radius):
            break
        rings.append(_bricks(chance, outside - half_width, half_width, speed))
        layers.append(tuple(chance.choice((0, 1, 1, 1, 2, 3, PERMANENT)) for _ in range(rings[-1].count)))
        outside = inner - chance.uniform(0.0, 2.0) - chance.choice((0.0, 2.0 * ball_radius))
    balls = tuple(_served(chance, speed, ball_radius) for _ in range(chance.randint(1, 4)))
    return Arena(balls, tuple(rings), tuple(layers)), tuple(layers)


def _bricks(chance: random.Random, radius: float, half_width: float, speed: float) -> Ring:
    """A ring of bricks: one in four closed without gaps, half of them turning."""
    count = chance.choice((1, 2, 3, 5, 8, 13, 21, 34))
    share = 1.0 if chance.random() < 0.25 else chance.uniform(0.2, 0.98)
    spin = chance.choice((0.0, 1.0)) * chance.uniform(-_FASTEST, _FASTEST) * speed / (radius + half_width)
    friction = chance.choice((0.0, 0.0, 0.3, 1.0))
    return Ring(radius, half_width, share * math.pi / count, count, chance.uniform(0.0, math.tau), spin, friction)


def _steered(arena: Arena, chance: random.Random, speed: float) -> Arena:
    """The arena with another spin of the paddles; they rest one time in three."""
    paddles = arena.rings[0]
    spin = chance.choice((0.0, 1.0, 1.0)) * chance.uniform(-_FASTEST, _FASTEST) * speed / paddles.outer_radius
    return arena._replace(rings=(paddles._replace(spin=spin), *arena.rings[1:]))


def _free_radius(ball_radius: float) -> float:
    """The radius around the centre that every arena keeps free, so that a ball can be served there."""
    return ball_radius + _LEAST_ROOM


def _served(chance: random.Random, speed: float, ball_radius: float) -> Ball:
    """A ball at the free disc around the centre, flying anywhere."""
    position = to_cartesian(chance.uniform(0.0, 0.9 * _LEAST_ROOM), chance.uniform(0.0, math.tau))
    return Ball(position, to_cartesian(speed, chance.uniform(0.0, math.tau)), ball_radius)
