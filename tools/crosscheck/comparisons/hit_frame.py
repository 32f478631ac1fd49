"""One hit of a trajectory, brought into the frame of the ring it is on, with the numbers every comparison needs."""

import cmath
import math
from typing import NamedTuple

from physics import Hit, Ring
from tools.crosscheck.comparisons.rules import TOGETHER
from tools.crosscheck.games.level_numbers import RingNumbers
from tools.crosscheck.games.trajectory import Tick
from tools.crosscheck.pymunk_model import facets, rounding
from tools.crosscheck.pymunk_model.one_bounce import Surface
from tools.crosscheck.pymunk_model.ring_model import Geometry, Part, RingModel, ShapeContact
from tools.crosscheck.results.measurements import ANYWHERE, FEATURE_OF_PART, FEATURES, Situation


class CheckedTick(NamedTuple):
    """A tick with pymunk's models of its rings.

    options: of the command that shows this game again.
    """

    tick: Tick
    models: list[RingModel]
    options: str

    def situation(self, ball: int, ring: int, position: complex, time: float) -> Situation:
        """A ball away from any hit, beside a ring, some seconds after the tick's start."""
        model, turning = self.models[ring], self.tick.arena.rings[ring]
        angle = turning.phase + turning.spin * time
        radius = self.tick.level.ball_radius
        return Situation(
            ANYWHERE,
            self.options,
            self.tick.number,
            time,
            ball,
            ring,
            -1,
            position,
            radius,
            model.geometry,
            angle,
            tuple(model.alive),
        )


class Moment(NamedTuple):
    """A hit as both engines have to answer it.

    numbers: the level's, of the ring. position: of the ball's centre. ball_radius, speed: the level's. angle: of the ring's
    frame, radians. spin: rad/s. local: the ball's centre in the ring's frame. shared: whether the bounce is off two sectors
    at once.
    """

    tick: Tick
    hit: Hit
    model: RingModel
    numbers: RingNumbers
    position: complex
    angle: float
    spin: float
    local: complex
    options: str
    shared: bool

    @property
    def ball_radius(self) -> float:
        """World units."""
        return self.tick.level.ball_radius

    @property
    def speed(self) -> float:
        """The fixed speed of the balls."""
        return self.tick.level.speed

    @property
    def claimed_feature(self) -> str:
        """The feature that the game names."""
        return FEATURES[self.hit.contact.feature]

    @property
    def reach(self) -> float:
        """How far from the ball's centre pymunk is asked to look."""
        return 1.5 * self.ball_radius + self.model.sagitta

    @property
    def normal_noise(self) -> float:
        """Radians: the bound for exact shapes."""
        return rounding.normal_noise(self.model.geometry.outer, self.ball_radius)

    @property
    def contact_noise(self) -> float:
        """World units: the bound for the gap at exact shapes."""
        together = TOGETHER * self.ball_radius if self.shared else 0.0
        return rounding.contact_noise(self.model.geometry.outer, self.ball_radius) + together

    def facet_bound(self, part: Part) -> float:
        """Radians: the bound for the chain's normal where the exact shape is this part."""
        geometry, count = self.model.geometry, self.model.facets
        if part == Part.END:
            return self.normal_noise
        if part == Part.OUTER_CIRCLE:
            bound = facets.outer_facet_bound(geometry.outer, self.ball_radius, geometry.half_angle, count)
            return bound + self.normal_noise
        return facets.half_facet(geometry.half_angle, count) + self.normal_noise

    def world(self, vector: complex) -> complex:
        """A vector of the ring's frame in the world's."""
        return vector * cmath.rect(1.0, self.angle)

    def surface(self, contact: ShapeContact) -> Surface:
        """What the ball bounces off."""
        return Surface(contact.shape, self.model.geometry, self.angle, self.spin)

    def pushed(self, contact: ShapeContact) -> complex:
        """The surface's velocity at the point that pymunk touches."""
        return 1j * self.spin * (self.position - self.world(contact.normal) * contact.distance)

    def situation(self, part: Part | None) -> Situation:
        """This hit, with the feature that pymunk names; None where it touches nothing."""
        hit = self.hit
        return Situation(
            self.claimed_feature if part is None else FEATURE_OF_PART[part],
            self.options,
            self.tick.number,
            hit.time,
            hit.ball,
            hit.ring,
            hit.slot,
            self.position,
            self.ball_radius,
            self.model.geometry,
            self.angle,
            tuple(self.model.alive),
        )


def moment_of(checked: CheckedTick, hit: Hit, position: complex, *, shared: bool = False) -> Moment:
    """The moment of a hit at which the ball's centre is at `position`. shared: whether another hit is part of the bounce."""
    tick = checked.tick
    ring, numbers = tick.arena.rings[hit.ring], tick.level.rings[hit.ring]
    spin = ring.spin if numbers.spin is None else numbers.spin
    angle = ring.phase + spin * hit.time
    local = position * cmath.rect(1.0, -angle)
    return Moment(tick, hit, checked.models[hit.ring], numbers, position, angle, spin, local, checked.options, shared)


def geometry_of(ring: Ring) -> Geometry:
    """The numbers of a ring in the game."""
    return Geometry(ring.radius, ring.half_width, ring.half_angle, ring.count)


def angle_between(a: complex, b: complex) -> float:
    """Radians between two directions, from cross and dot: acos would lose half the digits where it matters."""
    product = a.conjugate() * b
    return abs(math.atan2(product.imag, product.real))


def dot(a: complex, b: complex) -> float:
    """Scalar product, with Python's own complex numbers: the harness shares no arithmetic with the game."""
    return (a.conjugate() * b).real
