"""What stands in a slot of the flat view, as sectors and polygons: the same parts that the desktop paints."""

import cmath
import math

from game.drawing.palette import Theme
from game.drawing.slots.contents import ContentKind, SlotContent
from game.drawing.slots.parts import Bar, FootShade, Part, Slab, SlotShape, height, parts
from game.picture.display_list import DisplayList, inset_half_angle

_WHITE, _BLACK = (255, 255, 255), (0, 0, 0)
_EDGE = 0.22
"""Width of the edge that catches the light, in half widths."""
_INNER_LIGHT, _OUTER_SHADE = 0.26, 0.26
"""Opacities of the light on the inner edge and of the shade on the outer one."""
_FOOT_STEPS = 3
"""Sectors that the shade at the foot of a terrace is made of."""
_SHADOW_STEPS, _SHADOW_LENGTH = 3, 0.16
"""Sectors that a shadow on the ground is made of, and its reach for every layer of height, world units."""


def add_slot(
    out: DisplayList, centre: complex, scale: float, shape: SlotShape, content: SlotContent, theme: Theme, angle: float
) -> None:
    """Add what stands in a slot. centre: pixel of the arena's; scale: pixels per world unit; angle: of the slot's middle."""
    if content.kind is ContentKind.EMPTY:
        return
    for part in parts(content, shape, 0.0, theme):
        _add_part(out, centre, scale, shape, part, angle)
    if theme.relief > 0.0 and content.kind is not ContentKind.GHOST:
        _add_light(out, centre, scale, shape, angle, theme.relief)


def add_shadow(
    out: DisplayList, centre: complex, scale: float, shape: SlotShape, content: SlotContent, theme: Theme, angle: float
) -> None:
    """Add the shadow that a slot's content throws outwards on the ground."""
    if content.kind in (ContentKind.EMPTY, ContentKind.GHOST) or theme.relief <= 0.0:
        return
    reach = _SHADOW_LENGTH * (0.6 + 0.4 * height(content))
    for step in range(_SHADOW_STEPS):
        far = reach * (1.0 - step / _SHADOW_STEPS)
        half = shape.half_angle + (0.3 * far / shape.radius if shape.half_angle < math.pi else 0.0)
        radii = (shape.inner_radius * scale, (shape.outer_radius + far) * scale)
        out.sector(centre, radii, angle, (half, half), _BLACK, theme.shadow / _SHADOW_STEPS)


def _add_part(out: DisplayList, centre: complex, scale: float, shape: SlotShape, part: Part, angle: float) -> None:
    """Add one part."""
    match part:
        case Slab(inset=inset, colour=colour):
            _add_sector(out, centre, scale, shape, inset, angle, colour, 1.0)
        case FootShade(inset=inset, reach=reach, darkness=darkness):
            for step in range(_FOOT_STEPS):
                at = inset - reach * (1.0 - (step + 0.5) / _FOOT_STEPS)
                _add_sector(out, centre, scale, shape, max(at, 0.0), angle, _BLACK, darkness / (_FOOT_STEPS + 1.0))
        case Bar():
            out.polygon(_bar(part, centre, scale, angle), part.colour)


def _add_sector(
    out: DisplayList,
    centre: complex,
    scale: float,
    shape: SlotShape,
    inset: float,
    angle: float,
    colour: tuple[int, int, int],
    opacity: float,
) -> None:
    """Add a slot's sector, smaller by an inset; nothing where that leaves nothing."""
    inner, outer = shape.inner_radius + inset, shape.outer_radius - inset
    halves = inset_half_angle(shape.half_angle, inner, inset), inset_half_angle(shape.half_angle, outer, inset)
    if inner < outer and min(halves) > 0.0:
        out.sector(centre, (inner * scale, outer * scale), angle, halves, colour, opacity)


def _add_light(out: DisplayList, centre: complex, scale: float, shape: SlotShape, angle: float, strength: float) -> None:
    """The light of the flat view stands over the arena's centre: inner edges are bright, outer ones dark."""
    edge, half = _EDGE * shape.half_width, (shape.half_angle, shape.half_angle)
    inner, outer = shape.inner_radius, shape.outer_radius
    out.sector(centre, (inner * scale, (inner + edge) * scale), angle, half, _WHITE, _INNER_LIGHT * strength)
    out.sector(centre, ((outer - edge) * scale, outer * scale), angle, half, _BLACK, _OUTER_SHADE * strength)


def _bar(bar: Bar, centre: complex, scale: float, angle: float) -> list[complex]:
    """The corners of a bar, pixels."""
    corners = []
    for (radius, offset), side in ((bar.inner, -1.0), (bar.inner, 1.0), (bar.outer, 1.0), (bar.outer, -1.0)):
        at = cmath.rect(radius * scale, angle + offset + side * bar.half_width / radius)
        corners.append(centre + at.conjugate())
    return corners
