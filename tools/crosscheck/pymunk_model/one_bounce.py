"""One bounce, answered by pymunk's own solver."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import pymunk

from tools.crosscheck.pymunk_model.ring_model import SMALLEST_SKIN, Geometry, ModelShape, Part

ITERATIONS = 200
"""With 10, pymunk's default, a bounce off two surfaces gains or loses energy; one surface needs one."""

_INSTANT = 2.0**-50
"""Seconds. pymunk moves bodies before it looks for contacts: in this time a ball flies less than 1e-13."""


class Surface(NamedTuple):
    """What the ball bounces off: a shape in a ring's frame, and how that frame stands and turns.

    angle: of the frame, radians. spin: rad/s.
    """

    shape: ModelShape
    geometry: Geometry
    angle: float
    spin: float


class TouchingBall(NamedTuple):
    """A ball at the moment of touch.

    normal: unit, from the surface to the ball. distance: of the ball's centre from the shape, as pymunk measured it.
    """

    position: complex
    velocity: complex
    normal: complex
    distance: float


class Solver:
    """A space with one ball and one surface, in which pymunk answers a bounce.

    The surface is new for every bounce: pymunk remembers the impulses between two shapes, and would begin with them.
    """

    def __init__(self) -> None:
        """A space without a surface."""
        self._space = pymunk.Space()
        self._space.iterations = ITERATIONS
        self._ring = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        self._body = pymunk.Body(1.0, math.inf)
        self._disc = pymunk.Circle(self._body, 1.0)
        self._disc.elasticity = self._disc.friction = 1.0
        self._space.add(self._ring, self._body, self._disc)

    def bounced(self, ball: TouchingBall, surface: Surface, friction: float) -> complex:
        """The ball's velocity after pymunk has let it bounce once; its velocity itself if pymunk sees nothing to answer.

        friction: Coulomb's coefficient. A ball inside a circle is reflected at the point of touch: it then lies outside, its
        velocity and the surface's are negated, and so is the result.
        """
        if surface.shape.part == Part.INNER_CIRCLE:
            outside = ball._replace(position=ball.position - 2.0 * ball.distance * ball.normal, velocity=-ball.velocity)
            return -self._solved(outside, surface._replace(spin=-surface.spin), friction)
        return self._solved(ball, surface, friction)

    def _solved(self, ball: TouchingBall, surface: Surface, friction: float) -> complex:
        """The ball's velocity after one step."""
        body, ring = self._body, self._ring
        ring.angle, ring.angular_velocity = surface.angle, surface.spin
        body.position = ball.position.real, ball.position.imag
        body.velocity = ball.velocity.real, ball.velocity.imag
        self._disc.unsafe_set_radius(ball.distance + SMALLEST_SKIN)
        wall = _copy(surface, ring)
        wall.elasticity, wall.friction = 1.0, friction
        self._space.add(wall)
        self._space.step(_INSTANT)
        self._space.remove(wall)
        after = body.velocity
        return complex(after.x, after.y)


class Wall(NamedTuple):
    """A surface as a ball sees it at the moment of touch: a straight wall.

    normal: unit, from the wall to the ball. distance: of the ball's centre. velocity: of the wall, whole.
    """

    normal: complex
    distance: float
    velocity: complex


def bounced_off_walls(position: complex, velocity: complex, walls: Sequence[Wall]) -> complex:
    """The ball's velocity after pymunk has let it bounce off several walls at once, without friction."""
    space = pymunk.Space()
    space.iterations = ITERATIONS
    body = pymunk.Body(1.0, math.inf)
    body.position, body.velocity = (position.real, position.imag), (velocity.real, velocity.imag)
    disc = pymunk.Circle(body, max([wall.distance for wall in walls]) + SMALLEST_SKIN)
    disc.elasticity = 1.0
    space.add(body, disc)
    for wall in walls:
        moving = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        moving.velocity = wall.velocity.real, wall.velocity.imag
        point, along = position - wall.normal * wall.distance, wall.normal * 1j * wall.distance
        a, b = point - along, point + along
        segment = pymunk.Segment(moving, (a.real, a.imag), (b.real, b.imag), 0.0)
        segment.elasticity = 1.0
        space.add(moving, segment)
    space.step(_INSTANT)
    return complex(body.velocity.x, body.velocity.y)


def movement(velocity: complex) -> float:
    """World units that a ball flies while the solver works."""
    return abs(velocity) * _INSTANT


def _copy(surface: Surface, body: pymunk.Body) -> pymunk.Shape:
    """The shape once more, on a body that turns."""
    shape = surface.shape.shape
    if isinstance(shape, pymunk.Circle):
        return pymunk.Circle(body, shape.radius, shape.offset)
    return pymunk.Segment(body, shape.a, shape.b, 0.0)
