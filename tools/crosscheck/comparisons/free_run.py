"""Both engines start from one state and run alone. How long do they stay together?

No verdict: between round obstacles a small difference grows with every bounce, by the same factor in any engine. Chaos, not
error.
"""

import cmath
import math
import random
import statistics
from typing import NamedTuple

import pymunk

from game.levels import chosen
from physics import Arena, Ball, Ring, advance, to_cartesian
from tools.crosscheck.comparisons.hit_frame import geometry_of
from tools.crosscheck.games.sources import RANDOM
from tools.crosscheck.pymunk_model.one_bounce import ITERATIONS
from tools.crosscheck.pymunk_model.ring_model import Geometry, Part, chord_shapes, pointed_shapes

STEPS_PER_TICK = 64
"""pymunk finds a contact only after the ball has flown into it: it needs steps of a fraction of the ball's radius."""

_TICK = 1.0 / 240.0
_LONGEST = 240 * 10
_APART = 1.0
"""World units, a tenth of the arena: from here on the difference says nothing about its growth."""

Bounce = tuple[int, int]
"""Ring and slot."""


class FreeRun(NamedTuple):
    """One start, run by both engines.

    together: bounces off the same sectors in the same order. seconds: until the first bounce that differs, or the end.
    differences: world units between the two balls after bounce 1, 2, ... while they are together.
    """

    seed: int
    together: int
    seconds: float
    differences: tuple[float, ...]

    @property
    def growth(self) -> float:
        """Factor by which the difference grows from one bounce to the next; nan without three bounces."""
        points = [(k, math.log(d)) for k, d in enumerate(self.differences) if 0.0 < d < _APART]
        if len(points) < 3:
            return math.nan
        return math.exp(statistics.linear_regression(*zip(*points, strict=True)).slope)


def free_run(level: str | None, seed: int, facets: int) -> FreeRun:
    """A level's bricks, unbreakable and at rest, in a closed wall; one ball, served by the seed."""
    arena, speed = _still_arena(level, seed)
    ours, positions = _ours(arena, speed)
    theirs, other_positions = _pymunks(arena, speed, facets)
    together = next(
        (k for k, (a, b) in enumerate(zip(ours, theirs, strict=False)) if a[1] != b[1]), min(len(ours), len(theirs))
    )
    differences = []
    for tick, _ in [max(pair) for pair in zip(ours[:together], theirs[:together], strict=True)]:
        after = min(tick + 1, len(positions) - 1)  # the tick at whose end both have bounced
        differences.append(abs(positions[after] - other_positions[after]))
    end = min([run[together][0] for run in (ours, theirs) if len(run) > together], default=_LONGEST)
    return FreeRun(seed, together, end * _TICK, tuple(differences))


def _still_arena(level: str | None, seed: int) -> tuple[Arena, float]:
    """The first level named, its rings at rest and without friction, the paddles' track closed."""
    spec = chosen("1" if level in {None, RANDOM} else str(level))[0]
    rings = [ring._replace(spin=0.0, friction=0.0) for ring in spec.arena().rings]
    rings[0] = Ring(spec.paddles.radius, spec.paddles.half_width, math.pi, 1)
    chance = random.Random(seed)
    angle = chance.random() * math.tau
    position = to_cartesian(rings[0].inner_radius - 2.0 * spec.ball.radius, angle)
    velocity = to_cartesian(spec.ball.speed, angle + math.pi + 0.8 * (chance.random() - 0.5))
    layers = tuple((-1,) * ring.count for ring in rings)
    return Arena((Ball(position, velocity, spec.ball.radius),), tuple(rings), layers), spec.ball.speed


def _ours(arena: Arena, speed: float) -> tuple[list[tuple[int, Bounce]], list[complex]]:
    """Bounces with their ticks, and the ball's position at the end of every tick."""
    bounces, positions = [], []
    for tick in range(_LONGEST):
        step = advance(arena, _TICK, speed)
        bounces += [(tick, (hit.ring, hit.slot)) for hit in step.hits]
        arena = step.arena
        positions.append(arena.balls[0].position)
    return bounces, positions


def _pymunks(arena: Arena, speed: float, facets: int) -> tuple[list[tuple[int, Bounce]], list[complex]]:
    """The same from pymunk's space, where chords stand for arcs. Only the speed is reset; pymunk itself keeps it to 1e-12."""
    space = pymunk.Space()
    space.iterations = ITERATIONS
    owners = {}
    for number, ring in enumerate(arena.rings):
        for shape, slot in _placed(space.static_body, geometry_of(ring), ring.phase, facets):
            shape.elasticity = 1.0
            owners[shape] = number, slot
    space.add(*owners)
    ball = arena.balls[0]
    body = pymunk.Body(1.0, math.inf)
    body.position = ball.position.real, ball.position.imag
    body.velocity = ball.velocity.real, ball.velocity.imag
    circle = pymunk.Circle(body, ball.radius)
    circle.elasticity = 1.0
    space.add(body, circle)
    touched: list[Bounce] = []
    space.on_collision(0, 0, begin=lambda arbiter, *_: touched.extend(owners[s] for s in arbiter.shapes if s in owners))
    bounces: list[tuple[int, Bounce]] = []
    positions = []
    for tick in range(_LONGEST):
        for _ in range(STEPS_PER_TICK):
            before = body.velocity
            space.step(_TICK / STEPS_PER_TICK)
            if touched and body.velocity != before:
                bounces.append((tick, touched[0]))
            touched.clear()
        positions.append(complex(*body.position))
        body.velocity = body.velocity.normalized() * speed
    return bounces, positions


def _placed(body: pymunk.Body, geometry: Geometry, angle: float, facets: int) -> list[tuple[pymunk.Shape, int]]:
    """A ring's chords and ends, turned to where the ring stands, with their slots."""
    shapes: list[tuple[pymunk.Shape, int]] = []
    of_one = [*chord_shapes(body, geometry, facets), *pointed_shapes(body, geometry, 0)]
    for slot in range(geometry.count):
        turn = cmath.rect(1.0, angle + slot * math.tau / geometry.count)
        for found in of_one:
            if found.part in Part.FACETED and isinstance(found.shape, pymunk.Segment):
                a, b = complex(*found.shape.a) * turn, complex(*found.shape.b) * turn
                shapes.append((pymunk.Segment(body, (a.real, a.imag), (b.real, b.imag), 0.0), slot))
    return shapes
