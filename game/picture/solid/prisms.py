"""What stands in a slot of the solid view: prisms on outlines, one above the other.

Everything here is at angle 0, so that it stays the same while its ring and the camera turn. A slot's sector is divided twice:
into wedges, each so narrow that it can be sorted by itself, and every wedge's arcs into straight pieces.
"""

import cmath
import math
from functools import lru_cache
from typing import NamedTuple

from game.drawing.palette import Colour, Theme, mixed
from game.picture.slots.contents import SlotContent
from game.picture.slots.parts import WHOLE, Bar, FootShade, Part, Slab, SlotShape, parts

_SAGITTA, _SAGITTA_ALONE = 0.2, 0.8
"""Pixels that a straight piece may be away from the arc it stands for, its ends outside, its middle within; and those of an arc
that is one piece: there are no bends for the eye to find."""
_WIDE = math.radians(35.0)
"""Half angle from which a sector's arcs are shaded piece by piece."""
_LEAST_ROOM = 0.001
"""Share of the half width that is left of a sector where an inset takes all of it."""
_BLACK = (0, 0, 0)
_SHADE_REACH, _SHADE_DARKNESS = 0.35 / 0.6, 0.5
"""Of a shade that fades out, one of a single darkness is drawn: so wide and so dark, in shares of its reach and darkness."""


class SlotDivision(NamedTuple):
    """How the sectors of a ring's slots are divided, and how exact their outlines are.

    wedges: parts, side by side, that are sorted each by itself.
    pieces: straight pieces of every wedge's arcs.
    fringe: world units that a painter's filling adds on every side of a sector; its outline is so much smaller.
    """

    wedges: int
    pieces: int
    fringe: float


class Prism(NamedTuple):
    """A prism; where bottom and top are the same, a polygon painted on what is below it.

    outline: corners, clockwise, world units: along the inner arc from the right, the smallest angle, to the left, and back
    along the outer arc.
    bottom, top: heights, world units.
    colour: of the top; sides are the same in the shade.
    wedges: None for a sector, which all wedges of its slot have a part of; else the first and the last wedge that it lies on.
    """

    outline: tuple[complex, ...]
    bottom: float
    top: float
    colour: Colour
    wedges: tuple[int, int] | None = None


class SlotPrisms(NamedTuple):
    """What stands in a slot.

    prisms: from the lowest to the highest.
    shadow: None if it throws none; else the heights, world units, between which it keeps the light from the ground.
    """

    prisms: tuple[Prism, ...]
    shadow: tuple[float, float] | None


def slot_division(shape: SlotShape, widest: float, scale: float, fringe: float) -> SlotDivision:
    """How slots are divided. widest: half angle of the widest wedge; scale: pixels per world unit; fringe: world units."""
    if shape.half_angle <= min(widest, _half_angle(shape, _SAGITTA_ALONE, scale)):
        return SlotDivision(1, 1, fringe)
    pieces = math.ceil(shape.half_angle / min(widest, _half_angle(shape, _SAGITTA, scale)))
    return SlotDivision(1, pieces, fringe) if shape.half_angle <= widest else SlotDivision(pieces, 1, fringe)


def evenly_lit(half_angle: float) -> bool:
    """Whether an arc is shaded as one surface that is turned to where its middle is turned, or else piece by piece."""
    return half_angle < _WIDE


@lru_cache(maxsize=1024)
def slot_prisms(
    content: SlotContent, shape: SlotShape, drop: float, unit: float, theme: Theme, division: SlotDivision
) -> SlotPrisms:
    """What stands in a slot. drop: layers that a stack has still to fall; unit: height of a layer, world units."""
    prisms = tuple([prism for part in parts(content, shape, drop, theme) for prism in _prisms(part, shape, unit, division)])
    standing = bool(prisms) and prisms[0].top > prisms[0].bottom
    return SlotPrisms(prisms, (prisms[0].bottom, prisms[-1].top) if standing else None)


def part_of(prism: Prism, division: SlotDivision, first: int, last: int) -> Prism | None:
    """What the wedges from one to another have of a prism.

    What lies on several wedges is not divided: it belongs to those of them that are named; None if there is none.
    """
    named = wedges_between(first, last, division.wedges)
    if prism.wedges is not None:
        return prism if any([prism.wedges[0] <= wedge <= prism.wedges[1] for wedge in named]) else None
    corners = [division.pieces * wedge + k for wedge in named for k in range(division.pieces)]
    corners.append(corners[-1] + 1)
    inner, outer = prism.outline, prism.outline[::-1]
    return prism._replace(outline=(*[inner[k] for k in corners], *[outer[k] for k in reversed(corners)]))


def wedges_between(first: int, last: int, wedges: int) -> list[int]:
    """The wedges of a slot from one to another. wedges: of the slot. Of a whole ring, the first one follows the last."""
    return [wedge % wedges for wedge in range(first, last + 1 + (wedges if last < first else 0))]


def _half_angle(shape: SlotShape, sagitta: float, scale: float) -> float:
    """Half the angle that a straight piece may span, so many pixels away from its arc."""
    return math.acos(max(1.0 - 2.0 * sagitta / (shape.outer_radius * scale), 0.0))


def _prisms(part: Part, shape: SlotShape, unit: float, division: SlotDivision) -> list[Prism]:
    """The prism of a part; none where its inset leaves nothing."""
    match part:
        case Slab(bottom, top, inset, colour):
            return [Prism(_outline(shape, inset, division), bottom * unit, top * unit, colour)]
        case FootShade(top, inset, reach, darkness, colour):
            dark = mixed(colour, _BLACK, _SHADE_DARKNESS * darkness)
            return [Prism(_outline(shape, inset - _SHADE_REACH * reach, division), top * unit, top * unit, dark)]
        case Bar(top, colour=colour):
            return [Prism(_bar(part), top * unit, top * unit, colour, _wedges_below(part, shape, division))]


@lru_cache(maxsize=1024)
def _outline(shape: SlotShape, inset: float, division: SlotDivision) -> tuple[complex, ...]:
    """The outline of a slot's sector that is smaller by an inset.

    Corners are as far outside the arcs as the middles of the pieces are within. All sectors of a slot are divided at the same
    angles, but within their ends, which the inset moves inwards.
    """
    inset += division.fringe
    count = division.wedges * division.pieces
    room = min(inset, shape.half_width * (1.0 - _LEAST_ROOM))
    beyond = (3.0 - math.cos(shape.half_angle / count)) / 2.0
    arcs = []
    for radius in (shape.inner_radius + room, shape.outer_radius - room):
        moved = 0.0 if shape.half_angle >= WHOLE else math.asin(min(inset / max(radius, 1e-9), 1.0))
        end = max(shape.half_angle - moved, 0.0)
        angles = [min(max((2.0 * k / count - 1.0) * shape.half_angle, -end), end) for k in range(count + 1)]
        arcs.append([cmath.rect(radius * beyond, angle) for angle in angles])
    return (*arcs[0], *reversed(arcs[1]))


def _corners(bar: Bar) -> tuple[tuple[float, float], ...]:
    """Radius and angle of a bar's corners, clockwise from the inner right one."""
    ends = (bar.inner, -1.0), (bar.inner, 1.0), (bar.outer, 1.0), (bar.outer, -1.0)
    return tuple([(radius, offset + side * bar.half_width / radius) for (radius, offset), side in ends])


def _bar(bar: Bar) -> tuple[complex, ...]:
    """The outline of a bar."""
    return tuple([cmath.rect(*corner) for corner in _corners(bar)])


def _wedges_below(bar: Bar, shape: SlotShape, division: SlotDivision) -> tuple[int, int]:
    """The first and the last of a slot's wedges that a bar lies on."""
    width, most = 2.0 * shape.half_angle / division.wedges, division.wedges - 1
    found = [min(max(math.floor((angle + shape.half_angle) / width), 0), most) for _, angle in _corners(bar)]
    return min(found), max(found)
