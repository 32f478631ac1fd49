"""The contenders of `python -m tools.bench`: the plain engine, pymunk, Box2D, and the floor that no engine can go below."""

import math
import time
import warnings
from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Any, NamedTuple

import numpy as np

from game.system.errors import EnvironmentMissingError
from physics import Arena, Ball, FreeFlight, Ring, advance
from tools.measure.standard_arena import BALL_RADIUS, CHECK_EVERY, GROUND, SPEED, TICK, arena, served

FACETS = 16
BALLS_IN_A_SPACE = 100


class Play(NamedTuple):
    """One way to simulate.

    name: for the table. run: does so many ticks; it may return the seconds that it spent on what is no simulation.
    balls: that a tick of it moves. clock: what it is timed by, processor time or, where threads share the work, time.
    """

    name: str
    run: Callable[[int], float | None]
    balls: int = 1
    clock: Callable[[], float] = time.process_time


def plain(per_row: int) -> Callable[[int], None]:
    """Ticks of `physics.advance`."""
    state, full, chance = arena(per_row), arena(per_row).layers, Random(1)
    last: FreeFlight | None = None

    def play(ticks: int) -> None:
        nonlocal state, last
        now, flight = state, last
        for first in range(0, ticks, CHECK_EVERY):
            for _ in range(min(CHECK_EVERY, ticks - first)):
                step = advance(now, TICK, SPEED, flight)
                now, flight = step.arena, step.flight
            p = now.balls[0].position
            if p.real * p.real + p.imag * p.imag > GROUND * GROUND:
                now = Arena((served(chance),), now.rings, full)
        state, last = now, flight

    return play


def pymunk_play(
    model: Callable[[Any, Any, Ring], list[Any]], balls: int = 1, *, turning: bool = True
) -> Callable[[int], float]:
    """Ticks of pymunk's `Space.step`, its speed set anew and its lost balls served again once in a while, as needed to go on.

    balls: in one space; they pass through each other. turning: whether the paddles turn. The seconds spent on setting speeds
    and serving balls are returned.
    """
    pymunk = _pymunk()
    space = pymunk.Space()
    space.iterations = 1 if balls > 1 else space.iterations  # a ball touches one thing at a time: more is lost on it
    for ring in arena(16).rings:
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC if ring.spin and turning else pymunk.Body.STATIC)
        body.angular_velocity = ring.spin if turning else 0.0
        space.add(body, *model(pymunk, body, ring))
    chance = Random(1)
    bodies = [pymunk.Body(1.0, math.inf) for _ in range(balls)]
    for body in bodies:
        circle = pymunk.Circle(body, BALL_RADIUS)
        circle.filter = pymunk.ShapeFilter(group=1)
        space.add(body, circle)
        _put(body, served(chance))
    for shape in space.shapes:
        shape.elasticity, shape.friction = 1.0, 0.0

    def play(ticks: int) -> float:
        aside = 0.0
        for first in range(0, ticks, CHECK_EVERY):
            for _ in range(min(CHECK_EVERY, ticks - first)):
                space.step(TICK)
            start = time.process_time()
            for ball in bodies:
                if ball.position.length > GROUND or not ball.velocity.length > 0.0:
                    _put(ball, served(chance))
                ball.velocity = ball.velocity.scale_to_length(SPEED)
            aside += time.process_time() - start
        return aside

    return play


def _put(body: Any, ball: Ball) -> None:
    """Place a pymunk body where a ball is."""
    body.position = ball.position.real, ball.position.imag
    body.velocity = ball.velocity.real, ball.velocity.imag


def _pymunk() -> Any:
    """The pymunk library."""
    try:
        import pymunk  # noqa: PLC0415  # may be missing
    except ImportError:
        raise EnvironmentMissingError("the comparison needs pymunk: pip install pymunk") from None
    return pymunk


def facets(pymunk: Any, body: Any, ring: Ring) -> list[Any]:
    """Every sector's outline in segments: two arcs of facets, two ends."""
    shapes = []
    for slot in range(ring.count):
        outer, inner = _arc(ring, slot, ring.outer_radius, FACETS), _arc(ring, slot, ring.inner_radius, FACETS)
        outline = [*outer, *inner[::-1], outer[0]]
        shapes += [pymunk.Segment(body, a, b, 0.0) for a, b in pairwise(outline)]
    return shapes


def polygons(pymunk: Any, body: Any, ring: Ring) -> list[Any]:
    """Every sector as few convex polygons."""
    return [pymunk.Poly(body, corners) for corners in quadrangles(ring)]


def quadrangles(ring: Ring) -> list[list[tuple[float, float]]]:
    """The corners of the convex pieces of all sectors: 4 pieces for a paddle, 1 for a brick."""
    pieces, found = 4 if ring.spin else 1, []
    for slot in range(ring.count):
        outer, inner = _arc(ring, slot, ring.outer_radius, pieces), _arc(ring, slot, ring.inner_radius, pieces)
        found += [[outer[k], outer[k + 1], inner[k + 1], inner[k]] for k in range(pieces)]
    return found


def _arc(ring: Ring, slot: int, radius: float, pieces: int) -> list[tuple[float, float]]:
    """The corners of an arc cut into pieces."""
    first = ring.phase + slot * math.tau / ring.count - ring.half_angle
    angles = [first + 2.0 * ring.half_angle * k / pieces for k in range(pieces + 1)]
    return [(radius * math.cos(angle), radius * math.sin(angle)) for angle in angles]


def box2d_play() -> Callable[[int], float] | None:
    """Ticks of Box2D's `b2World.Step`: BALLS_IN_A_SPACE balls in one world, convex polygons, paddles at rest; None without it.

    As for pymunk, the seconds spent on setting speeds and serving balls are returned.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # its wrapper warns as it loads, and dies where warnings are errors
            import Box2D as b2  # noqa: N813, PLC0415  # may be missing
    except ImportError:
        return None
    world = b2.b2World(gravity=(0.0, 0.0), doSleep=False)
    for ring in arena(16).rings:
        for corners in quadrangles(ring):
            world.CreateStaticBody(shapes=b2.b2PolygonShape(vertices=corners)).fixtures[0].friction = 0.0
    chance, bodies = Random(1), []
    for _ in range(BALLS_IN_A_SPACE):
        circle = b2.b2FixtureDef(shape=b2.b2CircleShape(radius=BALL_RADIUS), density=1.0, friction=0.0, restitution=1.0)
        circle.filter.groupIndex = -1  # they pass through each other
        bodies.append(world.CreateDynamicBody(fixtures=circle, fixedRotation=True))
        _throw(bodies[-1], served(chance))

    def play(ticks: int) -> float:
        aside = 0.0
        for first in range(0, ticks, CHECK_EVERY):
            for _ in range(min(CHECK_EVERY, ticks - first)):
                world.Step(TICK, 1, 1)
            start = time.process_time()
            for body in bodies:
                if body.position.length > GROUND or not body.linearVelocity.length > 0.0:
                    _throw(body, served(chance))
                body.linearVelocity *= SPEED / body.linearVelocity.length
            aside += time.process_time() - start
        return aside

    return play


def _throw(body: Any, ball: Ball) -> None:
    """Place a Box2D body where a ball is."""
    body.position = ball.position.real, ball.position.imag
    body.linearVelocity = ball.velocity.real, ball.velocity.imag


def floor(balls: int) -> Callable[[int], None]:
    """Every ball's position moved by its velocity, and nothing else: the state is read and written once."""
    positions, step = np.full(balls, 7.0 + 0.0j), np.full(balls, 1e-9 + 0.0j)

    def play(ticks: int) -> None:
        for _ in range(ticks):
            np.add(positions, step, out=positions)

    return play
