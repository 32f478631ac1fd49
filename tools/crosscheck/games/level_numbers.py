"""What a level says, in numbers: all that pymunk's side knows of a game before it starts."""

import math
from typing import NamedTuple

from game.levels import Level
from physics import Arena
from tools.crosscheck.pymunk_model.ring_model import Geometry

UNBREAKABLE = -1
"""Layers of a sector that no hit removes, in a level file."""


class RingNumbers(NamedTuple):
    """One ring of a level.

    phase: of slot 0 at the start, radians. spin: rad/s; None for the paddles, which are steered. friction: in [0, 1].
    layers: per slot, 0 where nothing is, UNBREAKABLE where no hit removes one.
    """

    geometry: Geometry
    phase: float
    spin: float | None
    friction: float
    layers: tuple[int, ...]


class LevelNumbers(NamedTuple):
    """A level, or an arena drawn at random. Ring 0 is the paddles. speed: of every ball after a bounce.

    turn: the most that the arcade rules turn a ball by the position of its hit on a paddle, radians.
    """

    rings: tuple[RingNumbers, ...]
    ball_radius: float
    speed: float
    turn: float = 0.0


def numbers_of_level(level: Level) -> LevelNumbers:
    """The numbers of a level file; degrees become radians."""
    paddles = level.paddles
    geometry = Geometry(paddles.radius, paddles.half_width, math.radians(paddles.half_angle), paddles.count)
    rings = [RingNumbers(geometry, math.radians(paddles.phase), None, paddles.friction, (UNBREAKABLE,) * paddles.count)]
    for ring in level.rings:
        half_angle = min(math.radians(ring.half_angle), math.pi / ring.count)  # 180 / count in degrees may round above
        geometry = Geometry(ring.radius, ring.half_width, half_angle, ring.count)
        rings.append(RingNumbers(geometry, math.radians(ring.phase), math.radians(ring.spin), ring.friction, ring.slots()))
    return LevelNumbers(tuple(rings), level.ball.radius, level.ball.speed)


def numbers_of_arena(arena: Arena, speed: float) -> LevelNumbers:
    """The numbers of an arena that no file describes, as it was drawn. Its balls all have one radius."""
    rings = []
    for index, (ring, layers) in enumerate(zip(arena.rings, arena.layers, strict=True)):
        geometry = Geometry(ring.radius, ring.half_width, ring.half_angle, ring.count)
        rings.append(RingNumbers(geometry, ring.phase, ring.spin if index else None, ring.friction, layers))
    return LevelNumbers(tuple(rings), arena.balls[0].radius, speed)
