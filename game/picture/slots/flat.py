"""What stands in a slot of the flat view, with its light and its shadow: the same primitives for every painter.

The light of this view is above the arena's centre. So inner faces are bright, and shadows fall outwards and turn with the ring.
"""

import math
from functools import lru_cache
from typing import NamedTuple

from game.drawing.palette import Theme
from game.picture.display_list import DisplayList, Sector
from game.picture.slots.contents import SlotContent, casts_shadow
from game.picture.slots.parts import WHOLE, Bar, FootShade, Part, Slab, SlotShape, height, parts
from game.rules import PADDLES
from game.scene import Scene

_EDGE, _EDGE_PIXELS = 0.22, 1.5
"""Width of the edges that catch the light: in half widths, and at least so many pixels."""
_AT_FACES, _AT_ENDS, _SLOPE = 0.34, 0.085, 0.10
"""Strength of the light on the edges along a sector's faces and its ends, and between one face and the other."""
_SHADOW = 0.018
"""Length of the longest shadow, in shares of the ground's radius."""
_GAP_PIXELS = 3.0
"""Pixels between a shadow and the next ring outwards, at least."""
_LOW_SHADOW, _SHADOW_PER_LAYER = 0.7, 0.1
"""Length of a shadow as a share of the longest: of everything, and added for every layer of height."""
_INWARDS, _ASIDE = 0.3, 0.6
"""How far a shadow goes towards the centre and beyond the ends, in shares of its length outwards."""
_LEAST = 1e-3
"""Pixels; the least length of a shadow."""


_Sizes = tuple[tuple[float, float, float, int], ...]
"""Radius, half width, half angle and count of every ring."""


class FlatRing(NamedTuple):
    """What the slots of a ring look like from above, whatever stands in them.

    shape: of the slots.
    slots: how many there are.
    scale: pixels per world unit.
    shadow: length of the longest shadow, world units: none goes as far as the next ring outwards.
    lane: where the next ring inwards ends, and where the next one outwards begins, world units; else the centre and the rim.
    theme: the colours.
    """

    shape: SlotShape
    slots: int
    scale: float
    shadow: float
    lane: tuple[float, float]
    theme: Theme

    def sector(self, centre: complex, angle: float, out: float = 0.0) -> Sector:
        """A slot's sector, pixels. angle: of its middle; out: world units by which it is moved outwards."""
        shape, scale = self.shape, self.scale
        whole = shape.half_angle >= WHOLE
        radii = (shape.inner_radius + out) * scale, (shape.outer_radius + out) * scale
        return Sector(centre, radii, angle, math.pi if whole else shape.half_angle)


def wall_rings(scene: Scene) -> list[int]:
    """The indices of the rings that are no paddles."""
    return [k for k in range(len(scene.rings)) if k not in (PADDLES, scene.second_paddle)]


def flat_rings(scene: Scene, scale: float, theme: Theme) -> tuple[FlatRing, ...]:
    """All rings from above. scale: pixels per world unit."""
    rings = tuple([(ring.radius, ring.half_width, ring.half_angle, ring.count) for ring in scene.rings])
    return _flat_rings(rings, scene.tallest, scene.ground_radius, scale, theme)


@lru_cache(maxsize=16)
def _flat_rings(
    rings: _Sizes,
    tallest: tuple[int, ...],
    ground_radius: float,
    scale: float,
    theme: Theme,
) -> tuple[FlatRing, ...]:
    """All rings from above, made of what stays the same while rings turn."""
    found = []
    for (radius, half_width, half_angle, count), layers in zip(rings, tallest, strict=True):
        lane = _lane(rings, radius, ground_radius)
        room = lane[1] - radius - half_width - _GAP_PIXELS / scale
        shape = SlotShape(radius, half_width, half_angle, layers, 1.0 / scale)
        found.append(FlatRing(shape, count, scale, min(_SHADOW * ground_radius, max(room, 0.0)), lane, theme))
    return tuple(found)


def _lane(rings: _Sizes, radius: float, ground_radius: float) -> tuple[float, float]:
    """Where the next ring inwards ends, and where the next one outwards begins, world units; else the centre and the rim."""
    outer, inner = ([at + side * half_width for at, half_width, *_ in rings] for side in (1.0, -1.0))
    rim = max(ground_radius, *outer)
    return max([at for at in outer if at < radius], default=0.0), min([at for at in inner if at > radius], default=rim)


def add_shadow(out: DisplayList, ring: FlatRing, content: SlotContent, sector: Sector) -> None:
    """Add the shadow of a slot's content on the ground. sector: of the slot, as `FlatRing.sector` makes it."""
    theme, scale, shape = ring.theme, ring.scale, ring.shape
    darkness = theme.shadow * theme.relief
    if not casts_shadow(content) or darkness <= 0.0:
        return
    reach = ring.shadow * scale * min(_LOW_SHADOW + _SHADOW_PER_LAYER * height(content), 1.0)
    gap = (math.pi / ring.slots - shape.half_angle) * shape.radius * scale
    aside = max(min(_ASIDE * reach, gap), 1.0)
    reach = max(reach, _LEAST)
    out.cast(sector, _INWARDS * reach, reach, aside, darkness)


def add_content(out: DisplayList, ring: FlatRing, content: SlotContent, sector: Sector) -> None:
    """Add what stands in a slot, and the light on it. sector: of the slot, as `FlatRing.sector` makes it."""
    for part in parts(content, ring.shape, 0.0, ring.theme):
        _add_part(out, ring.scale, sector, part)
    if casts_shadow(content) and ring.theme.relief > 0.0:
        edge = max(_EDGE * ring.shape.half_width * ring.scale, _EDGE_PIXELS)
        out.relief(sector, edge, _AT_FACES, _AT_ENDS, _SLOPE, ring.theme.relief)


def _add_part(out: DisplayList, scale: float, sector: Sector, part: Part) -> None:
    """Add one part."""
    match part:
        case Slab(inset=inset, colour=colour):
            out.sector(sector, inset * scale, colour)
        case FootShade(inset=inset, reach=reach, darkness=darkness):
            out.foot(sector, inset * scale, reach * scale, darkness)
        case Bar(inner=(inner, start), outer=(outer, end)):
            ends = inner * scale, start, outer * scale, end
            out.bar(sector.centre, sector.angle, ends, part.half_width * scale, part.colour)
