"""The prisms of a ring as arrays: every one cut along its pieces into blocks, prisms on a foot with four corners.

Everything here is relative to the ring's phase: a turning ring has the same blocks at every moment.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.raster.arrays import Points, Reals
from game.picture.solid.prisms import Prism, SlotDivision
from game.picture.solid.rings import RingPrisms

Flags = NDArray[np.bool_]
Integers = NDArray[np.int64]


class Blocks(NamedTuple):
    """Many blocks, one a row. Their sides are numbered: outer, left (at the largest angle), inner, right.

    foot: four corners, world units: side k from corner k to the next, seen from above counter-clockwise.
    bottom, top: heights, world units.
    shadow_foot: four corners, as of the foot, where the shadow begins; without meaning where no side casts one.
    shadow_top: height up to which its slot keeps light from the ground, world units.
    slot: number of its slot.
    wedges: the first and the last wedge that the block lies on, counted through all slots of its ring.
    normals: of the four sides, unit.
    facing: directions that the sides are turned to as far as the light goes, unit.
    sides: which of the four sides there are.
    casting: which of them throw a shadow for all of the slot.
    colours: red, green and blue, 0 to 255.
    prism: its prism, counted through all slots of its ring.
    """

    foot: Points
    bottom: Reals
    top: Reals
    shadow_foot: Points
    shadow_top: Reals
    slot: Integers
    wedges: Integers
    normals: Points
    facing: Points
    sides: Flags
    casting: Flags
    colours: Reals
    prism: Integers


def ring_blocks(ring: RingPrisms) -> Blocks:
    """The blocks of a ring, slot after slot, each from the lowest prism to the highest."""
    prisms = _prisms(ring)
    pieces = ring.division.wedges * ring.division.pieces
    each = np.array([pieces if prism.wedges is None else 1 for prism in prisms], dtype=np.int64)
    number = np.repeat(np.arange(len(prisms)), each)
    piece = np.arange(len(number)) - np.repeat(np.cumsum(each) - each, each)
    slot = np.repeat(np.arange(len(ring.slots)), [len(stands.prisms) for stands in ring.slots])[number]
    middle = np.exp(1j * slot * (math.tau / len(ring.slots)))
    foot = _feet([prism.outline for prism in prisms], number, piece) * middle[:, None]
    normals = -1j * (np.roll(foot, -1, axis=1) - foot)
    normals /= np.maximum(np.abs(normals), 1e-12)
    out, into = (middle, -middle) if ring.evenly_lit else (normals[:, 0], normals[:, 2])
    bottom, top = np.array([(prism.bottom, prism.top) for prism in prisms]).reshape(-1, 2)[number].T
    high = top > bottom
    first, last = (ring.ends & (piece == end) for end in (0, pieces - 1))
    sides = np.stack([high, high & last, high, high & first], axis=1)
    lowest = np.array([level == 0 for stands in ring.slots for level in range(len(stands.prisms))], dtype=np.bool_)
    shadow_tops = np.array([shadow.high if shadow else 0.0 for shadow in ring.shadows])
    return Blocks(
        foot,
        bottom,
        top,
        _feet(_shadow_outlines(ring), number, piece) * middle[:, None],
        shadow_tops[slot],
        slot,
        slot[:, None] * ring.division.wedges + _wedges(prisms, ring.division, number, piece),
        normals,
        np.stack([out, normals[:, 1], into, normals[:, 3]], axis=1),
        sides,
        sides & lowest[number, None] & _casting(ring)[slot],
        _colours(prisms)[number],
        number,
    )


def recoloured(blocks: Blocks, ring: RingPrisms) -> Blocks:
    """The blocks of a ring in other colours. ring: prisms that differ from the blocks' own ones in colour only."""
    return blocks._replace(colours=_colours(_prisms(ring))[blocks.prism])


def _casting(ring: RingPrisms) -> Flags:
    """Which sides of each slot's lowest prism throw a shadow: all but the ends that are joined to a neighbour."""
    found = np.zeros((len(ring.shadows), 4), dtype=np.bool_)
    for slot, shadow in enumerate(ring.shadows):
        if shadow is not None:
            found[slot] = True, shadow.ends & 2, True, shadow.ends & 1
    return found


def _shadow_outlines(ring: RingPrisms) -> list[tuple[complex, ...]]:
    """For all prisms of a ring: of the lowest ones the outline that casts the slot's shadow, of the others their own."""
    return [
        shadow.casting if shadow and level == 0 else prism.outline
        for stands, shadow in zip(ring.slots, ring.shadows, strict=True)
        for level, prism in enumerate(stands.prisms)
    ]


def _prisms(ring: RingPrisms) -> list[Prism]:
    """All prisms of a ring, slot after slot, each from the lowest to the highest."""
    return [prism for stands in ring.slots for prism in stands.prisms]


def _colours(prisms: list[Prism]) -> Reals:
    """Red, green and blue of prisms, a row for each."""
    return np.array([prism.colour for prism in prisms], dtype=np.float64).reshape(-1, 3)


def _wedges(prisms: list[Prism], division: SlotDivision, number: Integers, piece: Integers) -> Integers:
    """The first and the last wedge of its slot that each block lies on. number, piece: of each block's prism, and within it."""
    wedges = np.repeat((piece // division.pieces)[:, None], 2, axis=1)
    if division.wedges > 1:
        for k, prism in enumerate(prisms):
            if prism.wedges is not None:
                wedges[number == k] = prism.wedges
    return wedges


def _feet(outlines: Sequence[tuple[complex, ...]], number: Integers, piece: Integers) -> Points:
    """The feet, as in `Blocks`, but of slots at angle 0. outlines: of prisms; number, piece: a block's prism, and within it."""
    feet: list[tuple[complex, ...]] = []
    first: dict[int, int] = {}  # by the identity of an outline, since most prisms share theirs
    for outline in outlines:
        if id(outline) not in first:
            first[id(outline)] = len(feet)
            feet += _cut(outline)
    rows = np.array([first[id(outline)] for outline in outlines], dtype=np.int64)
    return np.asarray(np.array(feet, dtype=np.complex128).reshape(-1, 4)[rows[number] + piece])


def _cut(outline: tuple[complex, ...]) -> list[tuple[complex, ...]]:
    """The feet under an outline, from the right to the left."""
    count = len(outline) // 2 - 1
    return [(outline[-1 - k], outline[-2 - k], outline[k + 1], outline[k]) for k in range(count)]
