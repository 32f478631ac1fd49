"""A ring of sectors as pymunk sees it: circles and segments of zero radius, built from the level's numbers alone.

Every side of a sector has an exact shape. An end is a segment, a corner a circle of radius 0. The outer face is part of a
circle that the ball touches from outside; the inner face is part of one that it touches from inside, which pymunk answers
after a point reflection at the nearest point of that circle. Beside them stands the chain: both arcs as N chords each.
"""

import cmath
import math
from collections.abc import Sequence
from enum import IntFlag
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import pymunk

from tools.crosscheck.pymunk_model.facets import arc_points, sagitta

SMALLEST_SKIN = 1e-6
"""World units added to the ball so that it overlaps what it touches: pymunk sees no contact at distance 0. No normal moves."""

_SAME = 1e-12
"""World units: two distances that are one."""


class Part(IntFlag):
    """What a shape stands for; as a bit mask, what a query looks for."""

    OUTER_FACET = 1
    INNER_FACET = 2
    END = 4
    CORNER = 8
    OUTER_CIRCLE = 16
    INNER_CIRCLE = 32
    FACETED = OUTER_FACET | INNER_FACET | END
    POINTED = END | CORNER


_FILTERS = {part: pymunk.ShapeFilter(categories=part) for part in Part}
_MASKS = {parts: pymunk.ShapeFilter(mask=parts) for parts in (*Part, Part.FACETED, Part.POINTED, Part.FACETED | Part.CORNER)}
_UNSEEN = pymunk.ShapeFilter(categories=0)
"""Of a slot that is empty: no query finds it."""


class Geometry(NamedTuple):
    """The level's numbers for one ring, in the ring's own frame: slot 0 has its middle at angle 0."""

    radius: float
    half_width: float
    half_angle: float
    count: int  # type: ignore[assignment]  # hides tuple.count, which nothing needs

    @property
    def inner(self) -> float:
        """Radius of the inner faces."""
        return self.radius - self.half_width

    @property
    def outer(self) -> float:
        """Radius of the outer faces."""
        return self.radius + self.half_width


class ModelShape(NamedTuple):
    """One pymunk shape, what it stands for, and the slot of the sector that it belongs to."""

    shape: pymunk.Circle | pymunk.Segment
    part: Part
    slot: int


class ShapeContact(NamedTuple):
    """Where pymunk says a ball and a shape are nearest.

    normal: unit, from the shape to the ball. distance: world units from the ball's centre to the shape, negative inside
    material.
    """

    shape: ModelShape
    normal: complex
    distance: float


class RingModel:
    """One ring in pymunk spaces of its own, whose frame turns with the ring.

    Turning the frame instead of thousands of segments is what makes a query at every tick affordable; the body that turns,
    with its angular velocity, is in `one_bounce`. All sectors being alike, only slot 0 has chords: a query of another
    slot's chords is turned to slot 0, and its answer turned back.
    """

    def __init__(self, geometry: Geometry, facets: int) -> None:
        self.geometry, self.facets = geometry, facets
        self.sagitta = sagitta(geometry.outer, geometry.half_angle, facets)
        self.inner_sagitta = sagitta(geometry.inner, geometry.half_angle, facets)
        self.alive = [True] * geometry.count
        self.living = True  # any of them
        self.outer_circle, self.inner_circle = _circle(geometry.outer), _circle(geometry.inner)
        self._pitch = math.tau / geometry.count
        self._points, self._chain = pymunk.Space(), pymunk.Space()
        self._shapes: dict[pymunk.Shape, ModelShape] = {}
        self._pointed = [pointed_shapes(self._points.static_body, geometry, slot) for slot in range(geometry.count)]
        for shapes in self._pointed:
            self._add(self._points, shapes)
        self._chords: list[ModelShape] = []  # made when they are first asked for
        self._probe_body = pymunk.Body(1.0, math.inf)
        self._probe = pymunk.Circle(self._probe_body, 1.0)

    def set_alive(self, layers: Sequence[int]) -> bool:
        """Take over which slots hold material; whether any slot came to life."""
        revived = False
        for slot, (was, now) in enumerate(zip(self.alive, layers, strict=True)):
            if was is bool(now):
                continue
            revived |= bool(now)
            self.alive[slot] = bool(now)
            for shape in self._pointed[slot]:
                shape.shape.filter = _FILTERS[shape.part] if now else _UNSEEN
        self.living = any(self.alive)
        return revived

    def ends(self, slot: int) -> list[pymunk.Segment]:
        """The two ends of a slot's sector."""
        return [shape.shape for shape in self._pointed[slot] if isinstance(shape.shape, pymunk.Segment)]

    def exact(self, p: complex, reach: float) -> ShapeContact | None:
        """The nearest exact shape within reach of a point, with its normal."""
        found = self.nearest_exact(p, reach)
        if found is None:
            return None
        shape, distance = found
        if shape.part != Part.END:
            return self.contact(p, distance, shape)
        corner = self._nearest(self._points, p, distance + _SAME, Part.CORNER)  # an end's own end point is its corner
        return self.contact(p, distance, shape if corner is None else corner[0])

    def nearest_exact(self, p: complex, reach: float) -> tuple[ModelShape, float] | None:
        """The nearest exact shape within reach of a point, and its distance, which is negative in material.

        Over a sector's bearings its face is nearest, of the two that pymunk finds nearer; elsewhere an end or a corner. That
        a face reaches only over the bearings of its own sector is all that this method knows about sectors.
        """
        slot = self.slot_over(p)
        if slot is None:
            return self._nearest(self._points, p, reach, Part.POINTED)
        face = self._face(p, slot)
        return face if face[1] < reach else None

    def exact_near(self, p: complex, reach: float) -> list[tuple[ModelShape, float]]:
        """Every living exact shape within reach of a point, nearest first; of the faces the one over whose bearings it is."""
        found = self._points.point_query((p.real, p.imag), reach, _MASKS[Part.POINTED])
        near = [(self._shapes[info.shape], info.distance) for info in found if info.shape is not None]
        slot = self.slot_over(p)
        if slot is not None and (face := self._face(p, slot))[1] <= reach:
            near.append(face)
        return sorted(near, key=_by_distance)

    def faceted(self, p: complex, reach: float) -> ShapeContact | None:
        """The nearest chord or end."""
        end = self._nearest(self._points, p, reach, Part.END)
        nearest = None if end is None else self.contact(p, end[1], end[0])
        for slot in self._living_slots_near(p, reach):
            turn = cmath.rect(1.0, slot * self._pitch)
            local = p * turn.conjugate()
            found = self._nearest(self._chords_space(), local, reach, Part.FACETED)
            if found is not None and (nearest is None or found[1] < nearest.distance):
                nearest = self._turned(self.contact(local, found[1], found[0]), slot, turn)
        return nearest

    def faceted_near(self, p: complex, reach: float) -> list[ShapeContact]:
        """Every living chord, end and corner within reach of a point."""
        found = self._points.point_query((p.real, p.imag), reach, _MASKS[Part.POINTED])
        near = [self.contact(p, info.distance, self._shapes[info.shape]) for info in found if info.shape is not None]
        for info, turn in self.facets_near(p, reach):
            shape = self._shapes[info.shape]
            if shape.part != Part.END:
                slot = round(-cmath.phase(turn) / self._pitch) % self.geometry.count
                near.append(self._turned(self.contact(p * turn, info.distance, shape), slot, turn.conjugate()))
        return near

    def contact(self, p: complex, distance: float, shape: ModelShape) -> ShapeContact:
        """What pymunk's own collision routine says of a ball centred at p that just overlaps a shape.

        distance: between p and the shape, as pymunk measured it; the probe's radius is that and a skin. A ball inside a
        circle is reflected to the other side of the nearest point, and its normal turned round.
        """
        reflected = shape.part == Part.INNER_CIRCLE
        if reflected:
            nearest = shape.shape.point_query((p.real, p.imag)).point
            p = 2.0 * complex(nearest.x, nearest.y) - p
        self._probe.unsafe_set_radius(max(distance, 0.0) + SMALLEST_SKIN)
        self._probe_body.position = p.real, p.imag
        self._probe.cache_bb()
        normal = self._probe.shapes_collide(shape.shape).normal
        to_shape = complex(normal.x, normal.y)
        return ShapeContact(shape, to_shape if reflected else -to_shape, distance)

    def slot_over(self, p: complex, widened: float = 0.0) -> int | None:
        """The living slot whose sector spans the bearing of p."""
        bearing = cmath.phase(p)
        nearest = round(bearing / self._pitch)
        if abs(bearing - nearest * self._pitch) > self.geometry.half_angle + widened:
            return None
        slot = nearest % self.geometry.count
        return slot if self.alive[slot] else None

    def pointed_near(self, p: complex, reach: float) -> list[pymunk.PointQueryInfo]:
        """What pymunk's query says of every living end and corner within reach of a point."""
        return self._points.point_query((p.real, p.imag), reach, _MASKS[Part.POINTED])

    def facets_near(self, p: complex, reach: float) -> list[tuple[pymunk.PointQueryInfo, complex]]:
        """What pymunk says of every living chord and end near a point, and what turns the point to the query's frame."""
        near = [(info, 1.0 + 0.0j) for info in self._points.point_query((p.real, p.imag), reach, _MASKS[Part.END])]
        for slot in self._living_slots_near(p, reach):
            turn = cmath.rect(1.0, -slot * self._pitch)
            local = p * turn
            found = self._chords_space().point_query((local.real, local.imag), reach, _MASKS[Part.FACETED])
            near += [(info, turn) for info in found]
        return near

    def _face(self, p: complex, slot: int) -> tuple[ModelShape, float]:
        """The nearer face of a sector to a point over its bearings. pymunk counts distances inside a circle as negative."""
        position = (p.real, p.imag)
        outside = self.outer_circle.point_query(position).distance
        if outside > -self.geometry.half_width:
            return ModelShape(self.outer_circle, Part.OUTER_CIRCLE, slot), outside
        inside = -self.inner_circle.point_query(position).distance
        return ModelShape(self.inner_circle, Part.INNER_CIRCLE, slot), inside

    def _nearest(self, space: pymunk.Space, p: complex, reach: float, parts: Part) -> tuple[ModelShape, float] | None:
        """The nearest living shape of a space and its distance."""
        found = space.point_query_nearest((p.real, p.imag), reach, _MASKS[parts])
        if found is None or found.shape is None:
            return None
        return self._shapes[found.shape], found.distance

    def _living_slots_near(self, p: complex, reach: float) -> list[int]:
        """The living slots whose sectors a disc of radius `reach` around p can touch."""
        count, distance = self.geometry.count, abs(p)
        spanned = self.geometry.half_angle + (math.asin(reach / distance) if reach < distance else math.pi)
        bearing = cmath.phase(p)
        first, last = math.ceil((bearing - spanned) / self._pitch), math.floor((bearing + spanned) / self._pitch)
        slots = {slot % count for slot in range(first, min(last + 1, first + count))}
        return [slot for slot in sorted(slots) if self.alive[slot]]

    def _chords_space(self) -> pymunk.Space:
        """The space with the chords of slot 0."""
        if not self._chords:
            self._chords = chord_shapes(self._chain.static_body, self.geometry, self.facets)
            self._add(self._chain, self._chords)
        return self._chain

    @staticmethod
    def _turned(contact: ShapeContact, slot: int, turn: complex) -> ShapeContact:
        """A contact with slot 0, turned to another slot."""
        return ShapeContact(contact.shape._replace(slot=slot), contact.normal * turn, contact.distance)

    def _add(self, space: pymunk.Space, shapes: list[ModelShape]) -> None:
        """Put shapes into a space."""
        for shape in shapes:
            shape.shape.filter = _FILTERS[shape.part]
            self._shapes[shape.shape] = shape
        if shapes:
            space.add(*[shape.shape for shape in shapes])


@lru_cache(maxsize=128)
def ring_model(geometry: Geometry, facets: int) -> RingModel:
    """The model of a ring, cached: a level's rings come back in every game."""
    return RingModel(geometry, facets)


def chord_shapes(body: pymunk.Body, geometry: Geometry, facets: int) -> list[ModelShape]:
    """The chords of the outer face of slot 0, then those of its inner face."""
    shapes = []
    for part, radius in ((Part.OUTER_FACET, geometry.outer), (Part.INNER_FACET, geometry.inner)):
        points = arc_points(radius, 0.0, geometry.half_angle, facets)
        shapes += [ModelShape(pymunk.Segment(body, a, b, 0.0), part, 0) for a, b in pairwise(points)]
    return shapes


def pointed_shapes(body: pymunk.Body, geometry: Geometry, slot: int) -> list[ModelShape]:
    """The two ends and four corners of one sector. A closed ring has none."""
    if geometry.half_angle >= math.pi:
        return []
    middle = slot * (math.tau / geometry.count)
    shapes = []
    for angle in (middle - geometry.half_angle, middle + geometry.half_angle):
        inner, outer = cmath.rect(geometry.inner, angle), cmath.rect(geometry.outer, angle)
        a, b = (inner.real, inner.imag), (outer.real, outer.imag)
        shapes.append(ModelShape(pymunk.Segment(body, a, b, 0.0), Part.END, slot))
        shapes += [ModelShape(pymunk.Circle(body, 0.0, corner), Part.CORNER, slot) for corner in (a, b)]
    return shapes


def _circle(radius: float) -> pymunk.Circle:
    """A circle around the ring's centre, on a body of its own that never moves."""
    circle = pymunk.Circle(pymunk.Body(body_type=pymunk.Body.STATIC), radius)
    circle.cache_bb()
    return circle


def _by_distance(found: tuple[ModelShape, float]) -> float:
    return found[1]
