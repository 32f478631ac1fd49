"""A ring's slabs as arrays: every one cut into narrow blocks, prisms on a foot with four corners.

Everything here is relative to the ring's phase: a turning ring has the same blocks at every moment.
"""

import cmath
import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.solid.slabs import Mark, Slab

Reals = NDArray[np.float64]
Flags = NDArray[np.bool_]
Integers = NDArray[np.int64]
Points = NDArray[np.complex128]

_AWAY, _AWAY_ALONE = 0.2, 0.8
"""Pixels that a straight side may be away from the arc it stands for, its corners outside, its middle within; and those of a
block that is all of its sector: there are no bends for the eye to find."""
_WIDE = math.radians(35.0)
"""Half angle from which a sector's faces are shaded block by block."""
_CLOSE = 0.15
"""World units between two slots that a shadow does not show in."""
_FULL = math.pi * 0.999
"""Half angle from which a sector is a whole ring."""


class Blocks(NamedTuple):
    """Many blocks, one a row. Their sides are numbered: outer, left (at the largest angle), inner, right."""

    foot: Points  # four corners, world units: side k from corner k to the next, seen from above counter-clockwise
    bottom: Reals  # heights
    top: Reals
    reach: Reals  # height of its pile
    middles: Reals  # two a row: angles of the first and the last of the narrow pieces of its slot that it stands on
    slot_middle: Reals  # of its slot's
    normals: Points  # of the four sides, unit
    facing: Points  # where they are turned to as far as the light goes, unit
    sides: Flags  # which of the four there are
    casting: Flags  # which throw a shadow for the whole pile
    colours: Reals  # of the sides and of the top, three of each
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
    every = [slab for _, pile in piles for slab in pile]
    wedges = wedges_of(cut)
    number = np.array([k for k, slab in enumerate(every) for _ in range(1 if slab.mark else wedges)], dtype=np.int64)
    wedge = np.array([k for slab in every for k in range(1 if slab.mark else wedges)], dtype=np.int64)
    slot = np.array([slot for slot, pile in piles for _ in pile], dtype=np.int64)
    level = np.array([level for _, pile in piles for level in range(len(pile))], dtype=np.int64)
    middle = np.asarray(slot * (math.tau / cut.slots), dtype=np.float64)
    foot, pieces = _feet(cut, every, wedges, number, wedge)
    foot *= np.exp(1j * middle[number])[:, None]
    normals = -1j * (np.roll(foot, -1, axis=1) - foot)
    normals /= np.maximum(np.abs(normals), 1e-12)
    middles = middle[number, None] + pieces
    shaded = np.exp(1j * (middle[number] if cut.half_angle < _WIDE else middles[:, 0]))
    bottom, top = np.array([slab.bottom for slab in every]), np.array([slab.top for slab in every])
    reach = np.array([pile[-1].top for _, pile in piles for _ in pile])
    high, open_ends = (top > bottom)[number], cut.half_angle < _FULL
    first, last = (open_ends & (wedge == k) for k in (0, wedges - 1))
    sides = np.stack([high, high & last, high, high & first], axis=1)
    return Blocks(
        foot,
        bottom[number],
        top[number],
        reach[number],
        middles,
        middle[number],
        normals,
        np.stack([shaded, normals[:, 1], -shaded, normals[:, 3]], axis=1),
        sides,
        sides & _seen_by_the_light(cut, piles, slot, level, reach)[number],
        np.array([(slab.side_colour, slab.top_colour) for slab in every], dtype=np.float64).reshape(-1, 2, 3)[number],
        slot[number],
        level[number],
    )


def _seen_by_the_light(
    cut: Cut, piles: list[tuple[int, tuple[Slab, ...]]], slot: Integers, level: Integers, reach: Reals
) -> Flags:
    """Which sides of each slab may throw its pile's shadow: the lowest slab's, but not where a close neighbour takes it."""
    heights = np.zeros(cut.slots)
    for number, pile in piles:
        heights[number] = pile[-1].top if pile and pile[0].bottom == 0.0 else 0.0
    alone = cut.radius * (math.tau / cut.slots - 2.0 * cut.half_angle) > _CLOSE
    left, right = (alone | (reach > heights[(slot + step) % cut.slots]) for step in (1, -1))
    arcs = np.ones(len(slot), dtype=np.bool_)
    return np.asarray(np.stack([arcs, left, arcs, right], axis=1) & (level == 0)[:, None])


def wedges_of(cut: Cut) -> int:
    """Into how many blocks a slab is cut, side by side: so narrow that arcs stay round and that blocks can be sorted."""
    if cut.half_angle <= min(cut.widest, _half_angle(cut, _AWAY_ALONE)):
        return 1
    return math.ceil(cut.half_angle / min(cut.widest, _half_angle(cut, _AWAY)))


def _half_angle(cut: Cut, away: float) -> float:
    """Half the angle that a straight side may span, so many pixels away from its arc."""
    return math.acos(max(1.0 - 2.0 * away / ((cut.radius + cut.half_width) * cut.scale), 0.0))


def _feet(cut: Cut, every: list[Slab], wedges: int, number: Integers, wedge: Integers) -> tuple[Points, Reals]:
    """The feet and the middles of the pieces that they stand on, as in `Blocks`, about the slot's middle.

    wedges: pieces that a sector is cut into; number, wedge: of each block's slab, and of its piece.
    """
    shares = np.linspace(-1.0, 1.0, wedges + 1)
    inset = np.array([slab.inset for slab in every]) + cut.fringe
    room = np.minimum(inset, cut.half_width * 0.999)
    beyond = (3.0 - math.cos(cut.half_angle / wedges)) / 2.0
    arcs = []
    for radius in (cut.radius + cut.half_width - room, cut.radius - cut.half_width + room):
        points = np.exp(1j * _arcs(cut, shares, inset, radius)) * (radius * beyond)[:, None]
        arcs += [points[number, wedge], points[number, wedge + 1]]
    foot = np.stack([arcs[0], arcs[1], arcs[3], arcs[2]], axis=1)
    middles = (shares[:-1] + shares[1:])[wedge] / 2.0 * cut.half_angle
    pieces = np.stack([middles, middles], axis=1)
    for row in np.flatnonzero([every[k].mark is not None for k in number]).tolist():
        foot[row], pieces[row] = _marked(cut, every[number[row]].mark, wedges)
    return foot, pieces


def _marked(cut: Cut, mark: Mark, wedges: int) -> tuple[list[complex], list[float]]:
    """The four corners of a mark, and the middles of the first and the last piece of the slot that it touches."""
    corners = [
        (radius, angle + way * mark.half_width / radius)
        for (radius, angle), way in ((mark.outer, -1.0), (mark.outer, 1.0), (mark.inner, 1.0), (mark.inner, -1.0))
    ]
    width = 2.0 * cut.half_angle / wedges
    ends = [min(max(math.floor(angle / width + wedges / 2.0), 0), wedges - 1) for _, angle in corners]
    return [cmath.rect(*corner) for corner in corners], [(k + 0.5) * width - cut.half_angle for k in (min(ends), max(ends))]


def _arcs(cut: Cut, shares: Reals, inset: Reals, radius: Reals) -> Reals:
    """Angles from the slot's middle: cuts stay where they are, but within the ends, which an inset moves sideways."""
    if cut.half_angle >= _FULL:
        return np.repeat((shares * cut.half_angle)[None, :], len(radius), axis=0)
    end = np.maximum(cut.half_angle - np.arcsin(np.minimum(inset / radius, 1.0)), 0.0)[:, None]
    return np.asarray(np.clip(shares[None, :] * cut.half_angle, -end, end))


def joined(parts: list[Blocks]) -> Blocks:
    """Blocks of several rings."""
    columns: list[Any] = [np.concatenate(column) for column in zip(*parts, strict=True)]
    return Blocks(*columns)
