"""One hit of a trajectory, brought into the frame of the ring it is on, with the numbers every comparison needs."""

import cmath
import math
from typing import NamedTuple

from physics import Feature, Hit, Ring
from tools.crosscheck.games.trajectory import Tick
from tools.crosscheck.pymunk_model import facets
from tools.crosscheck.pymunk_model.ring_model import Geometry, Part, RingModel, Touch
from tools.crosscheck.results.cases import ANYWHERE, FEATURES, Case, Class, Comparison


class Scene(NamedTuple):
    """A tick with the rings' models."""

    tick: Tick
    models: list[RingModel]
    options: str  # of the command that shows this game again

    def case(
        self,
        comparison: Comparison,
        what: str,
        measured: tuple[float, float],
        place: tuple[int, int],
        position: complex,
        time: float,
    ) -> Case:
        """A ball away from any hit, as a case to show. measured: error and bound; place: ball and ring."""
        kind = Class.UNEXPLAINED if measured[0] > measured[1] else Class.FACETS
        ring = self.tick.arena.rings[place[1]]
        return Case(
            kind=kind,
            comparison=comparison,
            feature=ANYWHERE,
            what=what,
            options=self.options,
            tick=self.tick.number,
            time=time,
            ball=place[0],
            ring=place[1],
            slot=-1,
            error=measured[0],
            bound=measured[1],
            ours=0j,
            pymunks=0j,
            position=position,
            ball_radius=self.tick.arena.balls[place[0]].radius,
            geometry=self.models[place[1]].geometry,
            angle=ring.phase + ring.spin * time,
            alive=tuple(self.models[place[1]].alive),
        )


class Moment(NamedTuple):
    """A hit as both engines have to answer it."""

    tick: Tick
    hit: Hit
    model: RingModel
    ring: Ring
    position: complex  # of the ball's centre
    ball_radius: float
    angle: float  # of the ring's frame
    local: complex  # the ball's centre in the ring's frame
    options: str

    @property
    def feature(self) -> str:
        """The feature that the game names."""
        return FEATURES[self.hit.contact.feature]

    @property
    def reach(self) -> float:
        """How far from the ball's centre pymunk is asked to look."""
        return 1.5 * self.ball_radius + self.model.sagitta

    @property
    def normal_noise(self) -> float:
        """Radians: the bound for exact shapes."""
        return facets.normal_noise(self.ring.outer_radius, self.ball_radius)

    @property
    def contact_noise(self) -> float:
        """World units: the bound for the gap at exact shapes."""
        return facets.contact_noise(self.ring.outer_radius)

    @property
    def half_facet(self) -> float:
        """Radians: half a facet's angle."""
        return facets.half_facet(self.ring.half_angle, self.model.facets)

    def facet_bound(self) -> float:
        """Radians: the bound for the faceted ring's normal."""
        feature = self.hit.contact.feature
        if feature == Feature.END:
            return self.normal_noise
        if feature == Feature.OUTER_FACE:
            arguments = (self.ring.outer_radius, self.ball_radius, self.ring.half_angle, self.model.facets)
            return facets.outer_facet_bound(*arguments) + self.normal_noise
        return self.half_facet + self.normal_noise

    def world(self, vector: complex) -> complex:
        """A vector of the ring's frame in the world's."""
        return vector * cmath.rect(1.0, self.angle)

    def case(
        self, kind: Class, comparison: Comparison, what: str, measured: tuple[float, float], answers: tuple[complex, complex]
    ) -> Case:
        """This hit as a case to show. measured: error and bound; answers: ours and pymunk's."""
        hit = self.hit
        return Case(
            kind=kind,
            comparison=comparison,
            feature=self.feature,
            what=what,
            options=self.options,
            tick=self.tick.number,
            time=hit.time,
            ball=hit.ball,
            ring=hit.ring,
            slot=hit.slot,
            error=measured[0],
            bound=measured[1],
            ours=answers[0],
            pymunks=answers[1],
            position=self.position,
            ball_radius=self.ball_radius,
            geometry=self.model.geometry,
            angle=self.angle,
            alive=tuple(self.model.alive),
        )


def moment_of(scene: Scene, hit: Hit, position: complex) -> Moment:
    """The moment of a hit at which the ball's centre is at `position`."""
    arena = scene.tick.arena
    ring = arena.rings[hit.ring]
    angle = ring.phase + ring.spin * hit.time
    local = position * cmath.rect(1.0, -angle)
    model, radius = scene.models[hit.ring], arena.balls[hit.ball].radius
    return Moment(scene.tick, hit, model, ring, position, radius, angle, local, scene.options)


def geometry_of(ring: Ring) -> Geometry:
    """The level's numbers of a ring."""
    return Geometry(ring.radius, ring.half_width, ring.half_angle, ring.count)


def angle_between(a: complex, b: complex) -> float:
    """Radians between two directions, from cross and dot: acos would lose half the digits where it matters."""
    product = a.conjugate() * b
    return abs(math.atan2(product.imag, product.real))


def tie(moment: Moment, bound: float) -> Touch | None:
    """Another shape as near as the nearest, to within the chords' sagitta, whose normal agrees with the game's."""
    ours = moment.hit.contact.normal
    slack = moment.model.sagitta + moment.contact_noise
    near = moment.model.all_near(moment.local, moment.ball_radius + slack, Part.FACETED | Part.CORNER)
    for piece, distance in near:
        touch = moment.model.touch(moment.local, distance, piece)
        if distance >= moment.ball_radius - slack and angle_between(ours, moment.world(touch.normal)) <= bound:
            return touch
    return None
