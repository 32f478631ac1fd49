"""A ring's slabs as arrays: every one cut into narrow blocks, each an extruded annular sector with two arcs of points.

Everything here is relative to the ring's phase: a turning ring has the same blocks at every moment.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.slabs import Slab

Reals = NDArray[np.float64]
Flags = NDArray[np.bool_]
Integers = NDArray[np.int64]

SEGMENTS = 3
"""Chords of an arc of one block."""
_SAG = 0.2
"""Pixels that a chord may run inside its arc."""
_WIDE = math.radians(35.0)
"""Half angle from which a sector's faces are shaded block by block."""
_LINE = 0.06
"""World units, width of a bar."""


class Blocks(NamedTuple):
    """Many blocks, one a row."""

    outer: Reals  # angles of the points of the outer arc, rising, SEGMENTS + 1 a row
    inner: Reals
    outer_radius: Reals
    inner_radius: Reals
    bottom: Reals  # heights
    top: Reals
    middle: Reals  # angle of the block's middle, the same for all blocks on top of each other
    slot_middle: Reals  # of its slot's
    facing: Reals  # angle of its arcs' shading
    right: Flags  # whether the block has an end face at its smallest angle
    left: Flags  # and at its largest
    side_colour: Reals  # three a row
    top_colour: Reals
    slot: Integers
    level: Integers  # of its slab in the pile, 0 the lowest


class Cut(NamedTuple):
    """How a ring is cut into blocks."""

    radius: float
    half_width: float
    half_angle: float
    slots: int
    widest: float  # half angle of the widest block allowed
    scale: float  # pixels per world unit
    fringe: float  # world units that drawing adds to every side, to be taken off here


def blocks(cut: Cut, piles: list[tuple[int, tuple[Slab, ...]]]) -> Blocks:
    """The blocks of a ring. piles: slots and what stands in them."""
    slot = np.array([number for number, pile in piles for _ in pile], dtype=np.int64)
    every = [slab for _, pile in piles for slab in pile]
    wedges = wedges_of(cut)
    shares = np.linspace(-1.0, 1.0, wedges * SEGMENTS + 1)
    inset = np.array([slab.inset for slab in every]) + cut.fringe
    room = cut.half_width * 0.999
    outer_radius = cut.radius + cut.half_width - np.minimum(inset, room)
    inner_radius = cut.radius - cut.half_width + np.minimum(inset, room)
    middle = slot * (math.tau / cut.slots)
    outer = _arcs(cut, shares, inset, outer_radius) + middle[:, None]
    inner = _arcs(cut, shares, inset, inner_radius) + middle[:, None]
    bars = [(row, slab.strut) for row, slab in enumerate(every) if slab.strut is not None]
    for row, (low, high) in bars:
        outer[row] = middle[row] + high + shares * (_LINE / 2.0 / outer_radius[row])
        inner[row] = middle[row] + low + shares * (_LINE / 2.0 / inner_radius[row])
    columns = np.arange(wedges)[:, None] * SEGMENTS + np.arange(SEGMENTS + 1)[None, :]
    middles = (middle[:, None] + cut.half_angle * (shares[columns[:, 0]] + shares[columns[:, -1]])[None, :] / 2.0).ravel()
    rows, open_ends = len(every), cut.half_angle < math.pi * 0.999
    first, last = np.arange(wedges) == 0, np.arange(wedges) == wedges - 1
    return Blocks(
        outer[:, columns].reshape(rows * wedges, SEGMENTS + 1),
        inner[:, columns].reshape(rows * wedges, SEGMENTS + 1),
        np.repeat(outer_radius, wedges),
        np.repeat(inner_radius, wedges),
        np.repeat(np.array([slab.bottom for slab in every]), wedges),
        np.repeat(np.array([slab.top for slab in every]), wedges),
        middles,
        np.repeat(middle, wedges),
        np.repeat(middle, wedges) if cut.half_angle < _WIDE else middles,
        np.tile(first & open_ends, rows),
        np.tile(last & open_ends, rows),
        np.repeat(np.array([slab.side_colour for slab in every], dtype=np.float64).reshape(-1, 3), wedges, axis=0),
        np.repeat(np.array([slab.top_colour for slab in every], dtype=np.float64).reshape(-1, 3), wedges, axis=0),
        np.repeat(slot, wedges),
        np.repeat(np.array([level for _, pile in piles for level in range(len(pile))], dtype=np.int64), wedges),
    )


def wedges_of(cut: Cut) -> int:
    """Into how many blocks a slab is cut, side by side: few enough chords that arcs stay round, narrow enough to be sorted."""
    chord = math.sqrt(8.0 * _SAG / max((cut.radius + cut.half_width) * cut.scale, 8.0 * _SAG))
    return max(math.ceil(cut.half_angle / min(cut.widest, SEGMENTS * chord / 2.0) - 1e-9), 1)


def _arcs(cut: Cut, shares: Reals, inset: Reals, radius: Reals) -> Reals:
    """Angles from the slot's middle: cuts stay where they are, but within the ends, which an inset moves sideways."""
    if cut.half_angle >= math.pi * 0.999:
        return np.repeat((shares * cut.half_angle)[None, :], len(radius), axis=0)
    end = np.maximum(cut.half_angle - np.arcsin(np.minimum(inset / radius, 1.0)), 0.0)[:, None]
    return np.asarray(np.clip(shares[None, :] * cut.half_angle, -end, end))


def joined(parts: list[Blocks]) -> Blocks:
    """Blocks of several rings."""
    columns: list[Any] = [np.concatenate(column) for column in zip(*parts, strict=True)]
    return Blocks(*columns)


def ordered(every: Blocks, order: Integers) -> Blocks:
    """The same blocks in another order."""
    columns: list[Any] = [column[order] for column in every]
    return Blocks(*columns)
