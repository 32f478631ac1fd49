"""Pymunk as the lab's second engine: its shapes of a ring, its normal at a ball, and a flight by its own stepping."""

import cmath
import math
from collections.abc import Sequence

import pymunk

from game.lab.kit.second_engine import EngineContact, EngineShape
from physics import Ball, Ring
from tools.crosscheck.pymunk_model.one_bounce import ITERATIONS
from tools.crosscheck.pymunk_model.ring_model import Geometry, RingModel, ring_model, sector

FACETS = 24
"""Per arc: few enough to see them."""
_REACH = 2.0
"""Balls' radii within which a shape is looked for."""


class Pymunk:
    """Asks pymunk; it shares none of our collision code."""

    name = "pymunk"

    def touch(self, ball: Ball, ring: Ring, slots: Sequence[int]) -> EngineContact | None:
        """The shape nearest to the ball: an exact one where there is one, else a facet."""
        model, reach = _sector_model(ring), _REACH * ball.radius
        nearest: EngineContact | None = None
        for turn in _turns(ring, slots):
            place = ball.position * turn.conjugate()
            found = model.exact(place, reach) or model.faceted(place, reach)
            if found is not None and (nearest is None or found.distance < nearest.distance):
                nearest = EngineContact(found.normal * turn, found.distance)
        return nearest

    def shapes(self, ring: Ring, slots: Sequence[int]) -> tuple[EngineShape, ...]:
        """Chords, ends and corners."""
        shapes = [piece.shape for piece in _sector_model(ring).slots[0]]
        return tuple([_piece(shape, turn) for turn in _turns(ring, slots) for shape in shapes])

    def flight(self, ball: Ball, rings: Sequence[Ring], dt: float, ticks: int, facets: int = FACETS) -> tuple[complex, ...]:
        """The ball's places by pymunk's stepping: elastic, without a fixed speed, and without our friction."""
        space = pymunk.Space()
        space.iterations = ITERATIONS
        for ring in rings:
            body = pymunk.Body(body_type=pymunk.Body.KINEMATIC if ring.spin else pymunk.Body.STATIC)
            body.angle, body.angular_velocity = ring.phase, ring.spin
            geometry = Geometry(ring.radius, ring.half_width, ring.half_angle, ring.count)
            shapes = [piece.shape for slot in range(ring.count) for piece in sector(body, geometry, slot, facets)]
            for shape in shapes:
                shape.elasticity = 1.0
            space.add(body, *shapes)
        flying = pymunk.Body(1.0, math.inf)
        flying.position = ball.position.real, ball.position.imag
        flying.velocity = ball.velocity.real, ball.velocity.imag
        disc = pymunk.Circle(flying, ball.radius)
        disc.elasticity = 1.0
        space.add(flying, disc)
        places = [ball.position]
        for _ in range(ticks):
            space.step(dt)
            places.append(complex(flying.position.x, flying.position.y))
        return tuple(places)


def _sector_model(ring: Ring) -> RingModel:
    """One sector of a ring in its own frame: all of them are alike."""
    return ring_model(Geometry(ring.radius, ring.half_width, ring.half_angle, 1), FACETS)


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
