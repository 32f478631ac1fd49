"""A ring of sectors as pymunk sees it: circles and segments of zero radius, built from the level's numbers alone.

This file, `facets` and `solver` import nothing of the project: whatever they answer, they found without its collision code.
"""

import cmath
import math
from collections.abc import Iterator, Sequence
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
    FACETED = OUTER_FACET | INNER_FACET | END
    POINTED = END | CORNER


_FILTERS = {part: pymunk.ShapeFilter(categories=part) for part in Part}
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


class Piece(NamedTuple):
    """One pymunk shape and what it stands for. slot: -1 for the outer circle, which all slots share."""

    shape: pymunk.Circle | pymunk.Segment
    part: Part
    slot: int


class Touch(NamedTuple):
    """Where pymunk says a ball and a shape are nearest."""

    piece: Piece
    normal: complex  # unit, from the shape to the ball
    distance: float  # from the ball's centre to the shape


class RingModel:
    """One ring in a pymunk space of its own, whose frame turns with the ring.

    Turning the frame instead of thousands of segments is what makes a query at every tick affordable; the body that turns,
    with its angular velocity, is in `solver`.
    """

    def __init__(self, geometry: Geometry, facets: int) -> None:
        self.geometry, self.facets = geometry, facets
        self.sagitta = sagitta(geometry.outer, geometry.half_angle, facets)
        self.inner_sagitta = sagitta(geometry.inner, geometry.half_angle, facets)
        self.space = pymunk.Space()
        self.pieces: dict[pymunk.Shape, Piece] = {}
        self.slots: list[list[Piece]] = []
        for slot in range(geometry.count):
            pieces = list(sector(self.space.static_body, geometry, slot, facets))
            self.slots.append(pieces)
            for piece in pieces:
                piece.shape.filter = _FILTERS[piece.part]
                self.pieces[piece.shape] = piece
        self.space.add(*self.pieces)
        circle = pymunk.Circle(self.space.static_body, geometry.outer)
        circle.cache_bb()
        self.outer_circle = Piece(circle, Part.OUTER_CIRCLE, -1)
        self.alive = [True] * geometry.count
        self.living = True  # any of them
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
            for piece in self.slots[slot]:
                piece.shape.filter = _FILTERS[piece.part] if now else _UNSEEN
        self.living = any(self.alive)
        return revived

    def nearest(self, p: complex, reach: float, parts: Part = Part.FACETED) -> tuple[Piece, float] | None:
        """The living shape nearest to a point of the ring's frame, within reach, and its distance."""
        found = self.space.point_query_nearest((p.real, p.imag), reach, pymunk.ShapeFilter(mask=parts))
        if found is None or found.shape is None:
            return None
        return self.pieces[found.shape], found.distance

    def all_near(self, p: complex, reach: float, parts: Part) -> list[tuple[Piece, float]]:
        """Every living shape within reach of a point, nearest first."""
        found = self.space.point_query((p.real, p.imag), reach, pymunk.ShapeFilter(mask=parts))
        near = [(self.pieces[info.shape], info.distance) for info in found if info.shape is not None]
        return sorted(near, key=lambda pair: pair[1])

    def touch(self, p: complex, distance: float, piece: Piece) -> Touch:
        """What pymunk's own collision routine says of a ball centred at p that just overlaps a shape.

        distance: between p and the shape, as pymunk measured it; the probe's radius is that and a skin.
        """
        self._probe.unsafe_set_radius(max(distance, 0.0) + SMALLEST_SKIN)
        self._probe_body.position = p.real, p.imag
        self._probe.cache_bb()
        normal = self._probe.shapes_collide(piece.shape).normal
        return Touch(piece, -complex(normal.x, normal.y), distance)

    def faceted(self, p: complex, reach: float) -> Touch | None:
        """The nearest facet or end."""
        found = self.nearest(p, reach)
        return None if found is None else self.touch(p, found[1], found[0])

    def exact(self, p: complex, reach: float) -> Touch | None:
        """The nearest shape that is exact: the outer circle over a sector, else an end or a corner. None over an inner face.

        Which of them is nearest is pymunk's answer; that a face reaches only over the bearings of its own sector is all
        this method knows about sectors.
        """
        if self.slot_over(p) is not None:
            distance = self.outer_circle.shape.point_query((p.real, p.imag)).distance
            outside = distance > -self.geometry.half_width
            return self.touch(p, distance, self.outer_circle) if outside and distance < reach else None
        found = self.nearest(p, reach, Part.POINTED)
        if found is None:
            return None
        corner = self.nearest(p, found[1] + _SAME, Part.CORNER)  # an end's own end point is its corner
        piece, distance = found if corner is None else corner
        return self.touch(p, distance, piece)

    def slot_over(self, p: complex, widened: float = 0.0) -> int | None:
        """The living slot whose sector spans the bearing of p."""
        geometry = self.geometry
        bearing = cmath.phase(p)
        pitch = math.tau / geometry.count
        nearest = round(bearing / pitch)
        if abs(bearing - nearest * pitch) > geometry.half_angle + widened:
            return None
        slot = nearest % geometry.count
        return slot if self.alive[slot] else None


@lru_cache(maxsize=128)
def ring_model(geometry: Geometry, facets: int) -> RingModel:
    """The model of a ring, built once and kept: a level's rings come back in every game."""
    return RingModel(geometry, facets)


def sector(body: pymunk.Body, geometry: Geometry, slot: int, facets: int) -> Iterator[Piece]:
    """The shapes of one sector: two chains of chords, two ends, four corners. A closed ring has no ends."""
    middle = slot * (math.tau / geometry.count)
    outer = arc_points(geometry.outer, middle, geometry.half_angle, facets)
    inner = arc_points(geometry.inner, middle, geometry.half_angle, facets)
    for part, points in ((Part.OUTER_FACET, outer), (Part.INNER_FACET, inner)):
        for a, b in pairwise(points):
            yield Piece(pymunk.Segment(body, a, b, 0.0), part, slot)
    if geometry.half_angle >= math.pi:
        return
    for k in (0, -1):
        yield Piece(pymunk.Segment(body, inner[k], outer[k], 0.0), Part.END, slot)
        for corner in (inner[k], outer[k]):
            yield Piece(pymunk.Circle(body, 0.0, corner), Part.CORNER, slot)
