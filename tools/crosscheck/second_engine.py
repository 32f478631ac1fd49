"""Pymunk as the lab's second engine: its shapes of a ring, its normal at a ball, and a flight by its own stepping."""

import cmath
import math
from collections.abc import Sequence

import pymunk

from game.lab.kit.second_engine import EngineContact, EngineShape
from physics import Ball, Ring
from tools.crosscheck.pymunk_model.one_bounce import ITERATIONS
from tools.crosscheck.pymunk_model.ring_model import Geometry, RingModel, chord_shapes, pointed_shapes, ring_model

FACETS = 24
"""Per arc: few enough to see them."""
_REACH = 2.0
"""Balls' radii within which a shape is looked for."""


class Pymunk:
    """Asks pymunk; it shares none of our collision code."""

    name = "pymunk"

    def touch(self, ball: Ball, ring: Ring, slots: Sequence[int]) -> EngineContact | None:
        """The exact shape nearest to the ball: a circle for either face, a segment for an end, a point for a corner."""
        model, reach = _sector_model(ring), _REACH * ball.radius
        nearest: EngineContact | None = None
        for turn in _turns(ring, slots):
            found = model.exact(ball.position * turn.conjugate(), reach)
            if found is not None and (nearest is None or found.distance < nearest.distance):
                nearest = EngineContact(found.normal * turn, found.distance)
        return nearest

    def shapes(self, ring: Ring, slots: Sequence[int]) -> tuple[EngineShape, ...]:
        """Chords, ends and corners."""
        shapes = _sector_shapes(pymunk.Body(body_type=pymunk.Body.STATIC), ring)
        return tuple([_piece(shape, turn) for turn in _turns(ring, slots) for shape in shapes])

    def flight(self, ball: Ball, rings: Sequence[Ring], dt: float, ticks: int, facets: int = FACETS) -> tuple[complex, ...]:
        """The ball's positions by pymunk's stepping: elastic, without a fixed speed, and without our friction."""
        space = pymunk.Space()
        space.iterations = ITERATIONS
        for ring in rings:
            body = pymunk.Body(body_type=pymunk.Body.KINEMATIC if ring.spin else pymunk.Body.STATIC)
            body.angular_velocity = ring.spin
            turns = _turns(ring, range(ring.count))
            shapes = [_turned(body, shape, turn) for turn in turns for shape in _sector_shapes(body, ring, facets)]
            for shape in shapes:
                shape.elasticity = 1.0
            space.add(body, *shapes)
        flying = pymunk.Body(1.0, math.inf)
        flying.position = ball.position.real, ball.position.imag
        flying.velocity = ball.velocity.real, ball.velocity.imag
        disc = pymunk.Circle(flying, ball.radius)
        disc.elasticity = 1.0
        space.add(flying, disc)
        positions = [ball.position]
        for _ in range(ticks):
            space.step(dt)
            positions.append(complex(flying.position.x, flying.position.y))
        return tuple(positions)


def _sector_model(ring: Ring) -> RingModel:
    """One sector of a ring in its own frame: all of them are alike."""
    return ring_model(_sector(ring), FACETS)


def _sector(ring: Ring) -> Geometry:
    """The numbers of one sector of a ring."""
    return Geometry(ring.radius, ring.half_width, ring.half_angle, 1)


def _sector_shapes(body: pymunk.Body, ring: Ring, facets: int = FACETS) -> list[pymunk.Circle | pymunk.Segment]:
    """The chords, ends and corners of one sector, its middle at angle 0."""
    geometry = _sector(ring)
    return [shape.shape for shape in (*chord_shapes(body, geometry, facets), *pointed_shapes(body, geometry, 0))]


def _turns(ring: Ring, slots: Sequence[int]) -> list[complex]:
    """What turns the frame of one sector to that of each slot's."""
    return [cmath.rect(1.0, ring.phase + slot * math.tau / ring.count) for slot in slots]


def _piece(shape: pymunk.Shape, turn: complex) -> EngineShape:
    """One of pymunk's shapes in the world's frame."""
    if isinstance(shape, pymunk.Circle):
        centre = complex(*shape.offset) * turn
        return EngineShape(centre, centre, shape.radius)
    assert isinstance(shape, pymunk.Segment)
    return EngineShape(complex(*shape.a) * turn, complex(*shape.b) * turn, shape.radius)


def _turned(body: pymunk.Body, shape: pymunk.Circle | pymunk.Segment, turn: complex) -> pymunk.Shape:
    """A shape turned about the centre, on the same body."""
    piece = _piece(shape, turn)
    a, b = (piece.a.real, piece.a.imag), (piece.b.real, piece.b.imag)
    return pymunk.Circle(body, piece.radius, a) if isinstance(shape, pymunk.Circle) else pymunk.Segment(body, a, b, 0.0)
