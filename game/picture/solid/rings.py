"""The prisms of whole rings: what they depend on, and all slots of one."""

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

from game.drawing.palette import Theme
from game.picture.slots.contents import Contents, SlotContent
from game.picture.slots.parts import LAYER_HEIGHT, WHOLE, SlotShape, slot_shape
from game.picture.solid.order import ranked
from game.picture.solid.prisms import SlotDivision, SlotPrisms, evenly_lit, slot_division, slot_prisms
from game.scene import Scene

_SCALE_STEPS = 8
"""Scales between one and its double for which prisms are divided anew; between two of them they stay as they are."""
_CLOSE = 0.15
"""World units between two slots below which no light falls through: the shadow of the one goes as far as the other."""


class SolidRing(NamedTuple):
    """A ring of the solid view: what its prisms depend on, neither its angle nor, but for the scale in steps, the camera.

    contents, shape, division: of its slots.
    falling: slots whose content has still to fall, and by how many layers.
    unit: height of a layer, world units.
    theme: the colours.
    """

    contents: tuple[SlotContent, ...]
    shape: SlotShape
    division: SlotDivision
    falling: tuple[tuple[int, float], ...]
    unit: float
    theme: Theme


class SlotShadow(NamedTuple):
    """What the shadow of a slot is made from: what its sides pass over as they are moved along the light.

    outline: of the lowest prism, at angle 0.
    casting: the outline that casts the shadow: where an end is joined to a close neighbour, it goes up to that one.
    ends: which of its ends cast a shadow, as they do unless they are joined: 1 the right one, 2 the left one, 3 both.
    low, high: heights, world units: the outline is moved from the one to the other.
    """

    outline: tuple[complex, ...]
    casting: tuple[complex, ...]
    ends: int
    low: float
    high: float


class RingPrisms(NamedTuple):
    """The prisms of a ring.

    slots: what stands in each, at angle 0.
    shadows: of each; None where there is none.
    division: of the slots.
    ends: whether their sectors have ends, as a whole ring has none.
    evenly_lit: as the function says.
    """

    slots: tuple[SlotPrisms, ...]
    shadows: tuple[SlotShadow | None, ...]
    division: SlotDivision
    ends: bool
    evenly_lit: bool


def solid_rings(
    scene: Scene, contents: Contents, theme: Theme, scale: float, fineness: float = 1.0, fringe: float = 0.0
) -> list[SolidRing]:
    """All rings as they are at present.

    scale: pixels per world unit. fineness: share of it for which arcs look round. fringe: pixels, as in `SlotDivision`.
    """
    scale = 2.0 ** (round(math.log2(scale) * _SCALE_STEPS) / _SCALE_STEPS)
    unit = LAYER_HEIGHT * scene.ground_radius
    widest = {ring: wide for ring, _, _, wide in ranked(scene.rings)}
    found = []
    for k, ring in enumerate(scene.rings):
        shape = slot_shape(ring, scene.tallest[k], 0.0)  # lines may be thinner than a pixel
        found.append(
            SolidRing(
                contents[k],
                shape,
                slot_division(shape, widest[k], scale * fineness, fringe / scale),
                tuple([(stack.slot, stack.height) for stack in scene.falling if stack.ring == k]),
                unit,
                theme,
            )
        )
    return found


def ring_prisms(ring: SolidRing) -> RingPrisms:
    """The prisms of a ring."""
    falling, shape = dict(ring.falling), ring.shape
    found: dict[tuple[SlotContent, float], SlotPrisms] = {}  # most slots look like others
    slots = []
    for slot, content in enumerate(ring.contents):
        key = content, falling.get(slot, 0.0)
        if key not in found:
            found[key] = slot_prisms(content, shape, key[1], ring.unit, ring.theme, ring.division)
        slots.append(found[key])
    ends = shape.half_angle < WHOLE
    close = ends and shape.radius * (math.tau / len(slots) - 2.0 * shape.half_angle) < _CLOSE
    shadows = tuple([_shadow(slots, slot, close=close) for slot in range(len(slots))])
    return RingPrisms(tuple(slots), shadows, ring.division, ends, evenly_lit(shape.half_angle))


def _shadow(slots: Sequence[SlotPrisms], slot: int, *, close: bool) -> SlotShadow | None:
    """The shadow of a slot. close: whether its neighbours are; it is joined to those that stand there and are as high."""
    own = slots[slot].shadow
    if own is None:
        return None
    beside = [slots[(slot + step) % len(slots)].shadow for step in (-1, 1)]
    right, left = [close and other is not None and other[0] == 0.0 and other[1] >= own[1] for other in beside]
    outline = slots[slot].prisms[0].outline
    corners, middle, pitch = list(outline), len(outline) // 2, cmath.rect(1.0, math.tau / len(slots))
    if right:  # the neighbour's left corners are its own ones, a slot further
        corners[0], corners[-1] = outline[middle - 1] / pitch, outline[middle] / pitch
    if left:
        corners[middle - 1], corners[middle] = outline[0] * pitch, outline[-1] * pitch
    return SlotShadow(outline, tuple(corners), int(not right) + 2 * int(not left), *own)
