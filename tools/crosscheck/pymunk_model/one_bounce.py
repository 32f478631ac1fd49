"""One bounce, answered by pymunk's own solver."""

import math
from typing import NamedTuple

import pymunk

from tools.crosscheck.pymunk_model.ring_model import SMALLEST_SKIN, Geometry, Part, Piece

ITERATIONS = 200
"""With 10, pymunk's default, a bounce off two surfaces gains or loses energy; one surface needs one."""

_INSTANT = 2.0**-50
"""Seconds. pymunk moves bodies before it looks for contacts: in this time a ball flies less than 1e-13."""


class Surface(NamedTuple):
    """What the ball bounces off: a shape in a ring's frame, and how that frame stands and turns."""

    piece: Piece
    geometry: Geometry
    angle: float
    spin: float


def bounced(position: complex, velocity: complex, distance: float, surface: Surface, friction: float) -> complex:
    """The ball's velocity after pymunk has let it bounce once; velocity itself if pymunk sees nothing to answer.

    distance: of the ball's centre from the shape, as pymunk measured it. friction: Coulomb's coefficient.
    """
    space = pymunk.Space()
    space.iterations = ITERATIONS
    ring = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
    ring.angle, ring.angular_velocity = surface.angle, surface.spin
    wall = _copy(surface, ring)
    wall.elasticity, wall.friction = 1.0, friction
    body = pymunk.Body(1.0, math.inf)
    body.position, body.velocity = (position.real, position.imag), (velocity.real, velocity.imag)
    ball = pymunk.Circle(body, distance + SMALLEST_SKIN)
    ball.elasticity = ball.friction = 1.0
    space.add(ring, wall, body, ball)
    space.step(_INSTANT)
    return complex(body.velocity.x, body.velocity.y)


def _copy(surface: Surface, body: pymunk.Body) -> pymunk.Shape:
    """The shape once more, on a body that turns."""
    shape = surface.piece.shape
    if surface.piece.part == Part.OUTER_CIRCLE:
        return pymunk.Circle(body, surface.geometry.outer)
    if isinstance(shape, pymunk.Circle):
        return pymunk.Circle(body, shape.radius, shape.offset)
    return pymunk.Segment(body, shape.a, shape.b, 0.0)


def movement(velocity: complex) -> float:
    """World units that a ball flies while the solver works."""
    return abs(velocity) * _INSTANT
