"""The parts of a ring's slots as arrays: every one cut into narrow blocks, prisms on a foot with four corners.

Everything here is relative to the ring's phase: a turning ring has the same blocks at every moment.
"""

import cmath
import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.palette import mixed
from game.drawing.slots.parts import Bar, FootShade, Part, Slab
from game.effects import Recoil

Reals = NDArray[np.float64]
Flags = NDArray[np.bool_]
Integers = NDArray[np.int64]
Points = NDArray[np.complex128]

_SAGITTA, _SAGITTA_ALONE = 0.2, 0.8
"""Pixels that a straight side may be away from the arc it stands for, its corners outside, its middle within; and those of a
block that is all of its sector: there are no bends for the eye to find."""
_WIDE = math.radians(35.0)
"""Half angle from which a sector's faces are shaded block by block."""
_CLOSE = 0.15
"""World units between two slots that a shadow does not show in."""
_WHOLE = math.pi * 0.999
"""Half angle from which a sector is a whole ring, which has no ends."""
_BLACK = (0, 0, 0)
_SHADE_REACH, _SHADE_DARKNESS = 0.35 / 0.6, 0.5
"""Of a shade that fades out, one of a single darkness is drawn: so wide and so dark, in shares of its reach and darkness."""


class Blocks(NamedTuple):
    """Many blocks, one a row. Their sides are numbered: outer, left (at the largest angle), inner, right.

    foot: four corners, world units: side k from corner k to the next, seen from above counter-clockwise.
    bottom, top: heights, world units.
    pile_top: height of the highest part in the block's slot, world units.
    middles: angles of the first and of the last of the narrow pieces of its slot that the block stands on.
    slot_middle: angle of the middle of its slot.
    normals: of the four sides, unit.
    facing: directions that the sides are turned to as far as the light goes, unit.
    sides: which of the four sides there are.
    casting: which of them throw a shadow for the whole pile.
    colours: red, green and blue, 0 to 255.
    slot: number of its slot.
    level: position of its part in the pile, 0 the lowest.
    """

    foot: Points
    bottom: Reals
    top: Reals
    pile_top: Reals
    middles: Reals
    slot_middle: Reals
    normals: Points
    facing: Points
    sides: Flags
    casting: Flags
    colours: Reals
    slot: Integers
    level: Integers


class Cut(NamedTuple):
    """How a ring is cut into blocks.

    radius, half_width: of the ring, world units.
    half_angle: of its slots, radians.
    slots: how many.
    widest: half angle of the widest block allowed, radians.
    layer_height: world units.
    scale: pixels per world unit.
    fringe: world units that drawing adds to every side; blocks are so much smaller.
    """

    radius: float
    half_width: float
    half_angle: float
    slots: int
    widest: float
    layer_height: float
    scale: float
    fringe: float


def ring_blocks(cut: Cut, piles: list[tuple[int, tuple[Part, ...]]]) -> Blocks:
    """The blocks of a ring. piles: slots and the parts that stand in them, from the lowest to the highest."""
    every = _drawn(piles)
    wedges = wedges_of(cut)
    number = np.array([k for k, part in enumerate(every) for _ in range(_cuts(part, wedges))], dtype=np.int64)
    wedge = np.array([k for part in every for k in range(_cuts(part, wedges))], dtype=np.int64)
    slot = np.array([slot for slot, pile in piles for _ in pile], dtype=np.int64)
    level = np.array([level for _, pile in piles for level in range(len(pile))], dtype=np.int64)
    middle = np.asarray(slot * (math.tau / cut.slots), dtype=np.float64)
    foot, pieces = _feet(cut, every, wedges, number, wedge)
    foot *= np.exp(1j * middle[number])[:, None]
    normals = -1j * (np.roll(foot, -1, axis=1) - foot)
    normals /= np.maximum(np.abs(normals), 1e-12)
    middles = middle[number, None] + pieces
    shaded = np.exp(1j * (middle[number] if cut.half_angle < _WIDE else middles[:, 0]))
    bottom = np.array([part.bottom if isinstance(part, Slab) else part.top for part in every]) * cut.layer_height
    top = np.array([part.top for part in every]) * cut.layer_height
    pile_top = np.array([pile[-1].top for _, pile in piles for _ in pile]) * cut.layer_height
    high, open_ends = (top > bottom)[number], cut.half_angle < _WHOLE
    first, last = (open_ends & (wedge == k) for k in (0, wedges - 1))
    sides = np.stack([high, high & last, high, high & first], axis=1)
    return Blocks(
        foot,
        bottom[number],
        top[number],
        pile_top[number],
        middles,
        middle[number],
        normals,
        np.stack([shaded, normals[:, 1], -shaded, normals[:, 3]], axis=1),
        sides,
        sides & _casting(cut, piles, slot, level, pile_top)[number],
        _colours(every)[number],
        slot[number],
        level[number],
    )


def recoloured(blocks: Blocks, piles: list[tuple[int, tuple[Part, ...]]]) -> Blocks:
    """The blocks of a ring in other colours. piles: the parts of all slots, which differ from the old ones in colour only."""
    first = np.cumsum([0, *[len(pile) for _, pile in piles]])
    return blocks._replace(colours=_colours(_drawn(piles))[first[blocks.slot] + blocks.level])


def pushed(blocks: Blocks, recoils: tuple[Recoil, ...]) -> Blocks:
    """The paddles' blocks, those of a struck paddle farther out."""
    for recoil in recoils:
        out = np.where(blocks.slot == recoil.slot, recoil.out, 0.0)[:, None]
        blocks = blocks._replace(foot=blocks.foot * (1.0 + out / np.abs(blocks.foot)))
    return blocks


def joined(parts: list[Blocks]) -> Blocks:
    """Blocks of several rings."""
    columns: list[Any] = [np.concatenate(column) for column in zip(*parts, strict=True)]
    return Blocks(*columns)


def wedges_of(cut: Cut) -> int:
    """Into how many blocks a slab is cut, side by side: so narrow that arcs stay round and that blocks can be sorted."""
    if cut.half_angle <= min(cut.widest, _half_angle(cut, _SAGITTA_ALONE)):
        return 1
    return math.ceil(cut.half_angle / min(cut.widest, _half_angle(cut, _SAGITTA)))


def _half_angle(cut: Cut, sagitta: float) -> float:
    """Half the angle that a straight side may span, so many pixels away from its arc."""
    return math.acos(max(1.0 - 2.0 * sagitta / ((cut.radius + cut.half_width) * cut.scale), 0.0))


def _drawn(piles: list[tuple[int, tuple[Part, ...]]]) -> list[Slab | Bar]:
    """All parts in the order of drawing, pile after pile."""
    return [_sheet(part) if isinstance(part, FootShade) else part for _, pile in piles for part in pile]


def _colours(every: list[Slab | Bar]) -> Reals:
    """Red, green and blue of parts, a row for each."""
    return np.array([part.colour for part in every], dtype=np.float64).reshape(-1, 3)


def _sheet(shade: FootShade) -> Slab:
    """A shade at a foot as something painted, of a single darkness."""
    colour = mixed(shade.colour, _BLACK, _SHADE_DARKNESS * shade.darkness)
    return Slab(shade.top, shade.top, shade.inset - _SHADE_REACH * shade.reach, colour)


def _cuts(part: Slab | Bar, wedges: int) -> int:
    """How many blocks a part becomes."""
    return wedges if isinstance(part, Slab) else 1


def _casting(cut: Cut, piles: list[tuple[int, tuple[Part, ...]]], slot: Integers, level: Integers, pile_top: Reals) -> Flags:
    """Which sides of each part may throw its pile's shadow: the lowest part's, but not where a close neighbour takes it."""
    heights = np.zeros(cut.slots)
    for number, pile in piles:
        if pile and isinstance(pile[0], Slab) and pile[0].bottom == 0.0:
            heights[number] = pile[-1].top * cut.layer_height
    alone = cut.radius * (math.tau / cut.slots - 2.0 * cut.half_angle) > _CLOSE
    left, right = (alone | (pile_top > heights[(slot + step) % cut.slots]) for step in (1, -1))
    arcs = np.ones(len(slot), dtype=np.bool_)
    return np.asarray(np.stack([arcs, left, arcs, right], axis=1) & (level == 0)[:, None])


def _feet(cut: Cut, every: list[Slab | Bar], wedges: int, number: Integers, wedge: Integers) -> tuple[Points, Reals]:
    """The feet, and the middles of the pieces that they stand on, both as in `Blocks` but about the slot's middle.

    wedges: pieces that a sector is cut into; number, wedge: of each block's part, and of its piece.
    """
    shares = np.linspace(-1.0, 1.0, wedges + 1)
    inset = np.array([part.inset if isinstance(part, Slab) else 0.0 for part in every]) + cut.fringe
    room = np.minimum(inset, cut.half_width * 0.999)
    beyond = (3.0 - math.cos(cut.half_angle / wedges)) / 2.0
    arcs = []
    for radius in (cut.radius + cut.half_width - room, cut.radius - cut.half_width + room):
        points = np.exp(1j * _arcs(cut, shares, inset, radius)) * (radius * beyond)[:, None]
        arcs += [points[number, wedge], points[number, wedge + 1]]
    foot = np.stack([arcs[0], arcs[1], arcs[3], arcs[2]], axis=1)
    middles = (shares[:-1] + shares[1:])[wedge] / 2.0 * cut.half_angle
    pieces = np.stack([middles, middles], axis=1)
    bars = {k: part for k, part in enumerate(every) if isinstance(part, Bar)}
    for k, row in zip(bars, np.flatnonzero(np.isin(number, list(bars))), strict=True):  # a bar is one block
        foot[row], pieces[row] = _bar_foot(cut, bars[k], wedges)
    return foot, pieces


def _bar_foot(cut: Cut, bar: Bar, wedges: int) -> tuple[list[complex], list[float]]:
    """The four corners of a bar, and the middles of the first and the last piece of the slot that it touches."""
    (outer, end), (inner, start) = bar.outer, bar.inner
    corners = [
        (outer, end - bar.half_width / outer),
        (outer, end + bar.half_width / outer),
        (inner, start + bar.half_width / inner),
        (inner, start - bar.half_width / inner),
    ]
    width = 2.0 * cut.half_angle / wedges
    touched = [min(max(math.floor(angle / width + wedges / 2.0), 0), wedges - 1) for _, angle in corners]
    middles = [(k + 0.5) * width - cut.half_angle for k in (min(touched), max(touched))]
    return [cmath.rect(*corner) for corner in corners], middles


def _arcs(cut: Cut, shares: Reals, inset: Reals, radius: Reals) -> Reals:
    """Angles of the cuts from the slot's middle: the same for all parts, but within the ends, which an inset moves inwards."""
    if cut.half_angle >= _WHOLE:
        return np.repeat((shares * cut.half_angle)[None, :], len(radius), axis=0)
    end = np.maximum(cut.half_angle - np.arcsin(np.minimum(inset / radius, 1.0)), 0.0)[:, None]
    return np.asarray(np.clip(shares[None, :] * cut.half_angle, -end, end))
