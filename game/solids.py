"""Blocks as the camera sees them: points on the screen, and the faces that can be seen, from back to front."""

import math
from typing import NamedTuple

import numpy as np

from game.blocks import SEGMENTS, Blocks, Flags, Integers, Reals, ordered
from game.camera import Camera, Points
from game.depth_order import back_to_front

LIGHT = complex(math.cos(math.radians(125.0)), math.sin(math.radians(125.0)))
"""Where the light comes from, as a bearing of the world; it also falls from above, full on every top."""
_DIMMEST, _BRIGHTEST = 0.42, 0.78
"""What of its colour a side shows that is turned from the light, and one turned to it."""


class Seen(NamedTuple):
    """Blocks on the screen, one a row, from back to front; their arcs have SEGMENTS + 1 points."""

    outer_foot: Points  # on the ground, turned to the screen
    inner_foot: Points
    outer_top: Points  # pixels
    inner_top: Points
    outer_bottom: Points
    inner_bottom: Points
    blocks: Blocks
    group: Integers  # which are close together on the screen
    turned: Reals  # angle of each one's ring on the screen
    turn: complex  # of the screen, back to the world


class Face(NamedTuple):
    """What to fill: the colour, corners in whole pixels of a drawing, and the number of the drawing."""

    colour: list[int]
    corners: list[list[int]]
    area: int


def seen(blocks: Blocks, phase: Reals, parting: Reals, rank: Integers, group: Integers, camera: Camera) -> Seen:
    """The blocks on the screen.

    phase: angle of each one's ring; parting, rank: as `back_to_front` wants them; group: as in `Seen`.
    """
    turn = phase - camera.azimuth
    order = back_to_front(blocks, turn, parting, rank, camera)
    sorted_blocks = ordered(blocks, order)
    shift = turn[order][:, None]
    outer = np.exp(1j * (sorted_blocks.outer + shift)) * sorted_blocks.outer_radius[:, None]
    inner = np.exp(1j * (sorted_blocks.inner + shift)) * sorted_blocks.inner_radius[:, None]
    top, bottom = sorted_blocks.top[:, None], sorted_blocks.bottom[:, None]
    return Seen(
        outer,
        inner,
        camera.projected(outer, top),
        camera.projected(inner, top),
        camera.projected(outer, bottom),
        camera.projected(inner, bottom),
        sorted_blocks,
        group[order],
        turn[order],
        1.0 / camera.turning,
    )


class _Side(NamedTuple):
    """One side of every block: a strip between two lines of points, and where it faces."""

    shown: Flags
    top: Points
    bottom: Points
    facing: Points  # unit, turned to the screen


def faces(things: Seen, camera: Camera, finer: int, areas: list[complex], area: Integers) -> list[Face]:
    """All visible faces, from back to front.

    finer: rows and columns of a drawing per pixel; areas: the pixel drawn at each drawing's corner; area: which drawing each
    block belongs to.
    """
    blocks, corner = things.blocks, np.array(areas)[area]
    every: list[Face] = []
    places: list[Integers] = []
    for number, side in enumerate(_sides(things, camera)):
        rows = np.flatnonzero(side.shown)
        outline = np.concatenate([side.top[rows], side.bottom[rows, ::-1]], axis=1) - corner[rows, None]
        every += _filled(outline, blocks.side_colour[rows] * _light(side.facing[rows] * things.turn), finer, area[rows])
        places.append(rows * 4 + min(number, 2))
    tops = np.concatenate([things.outer_top, things.inner_top[:, ::-1]], axis=1) - corner[:, None]
    every += _filled(tops, blocks.top_colour, finer, area)
    places.append(np.arange(len(tops)) * 4 + 3)
    return [every[place] for place in np.argsort(np.concatenate(places), kind="stable").tolist()]


def _sides(things: Seen, camera: Camera) -> tuple[_Side, ...]:
    """Inner faces, outer faces, and the two ends. Of a convex block those that face the eye never hide one another."""
    blocks = things.blocks
    high = blocks.top > blocks.bottom
    ends = [0, SEGMENTS]
    outward = _unit(things.outer_foot[:, ends])
    middle = np.exp(1j * (blocks.facing + things.turned))
    right = -1j * _unit(things.outer_foot[:, 0] - things.inner_foot[:, 0])
    left = 1j * _unit(things.outer_foot[:, -1] - things.inner_foot[:, -1])
    return (
        _Side(
            high & (camera.nearer(things.inner_foot[:, ends], -outward).max(axis=1) > 0.0),
            things.inner_top,
            things.inner_bottom,
            -middle,
        ),
        _Side(
            high & (camera.nearer(things.outer_foot[:, ends], outward).max(axis=1) > 0.0),
            things.outer_top,
            things.outer_bottom,
            middle,
        ),
        _end(high & blocks.right & (camera.nearer(things.outer_foot[:, 0], right) > 0.0), things, 0, right),
        _end(high & blocks.left & (camera.nearer(things.outer_foot[:, -1], left) > 0.0), things, -1, left),
    )


def _end(shown: Flags, things: Seen, column: int, facing: Points) -> _Side:
    """The end at the first or the last point of the arcs."""
    top = np.stack([things.outer_top[:, column], things.inner_top[:, column]], axis=1)
    bottom = np.stack([things.outer_bottom[:, column], things.inner_bottom[:, column]], axis=1)
    return _Side(shown, top, bottom, facing)


def _unit(ways: Points) -> Points:
    """The same directions, of length 1."""
    return np.asarray(ways / np.maximum(np.abs(ways), 1e-12))


def _light(facing: Points) -> Reals:
    """What of its colour each side shows, a column. facing: in the world."""
    towards = (facing * LIGHT.conjugate()).real
    return np.asarray(_DIMMEST + (_BRIGHTEST - _DIMMEST) * (0.5 + 0.5 * towards))[:, None]


def _filled(outlines: Points, colours: Reals, finer: int, area: Integers) -> list[Face]:
    """Polygons in the pixels of drawings."""
    pixels = np.floor(outlines.view(np.float64) * finer).astype(np.int64)
    corners = pixels.reshape(*outlines.shape, 2).tolist()
    shades = np.rint(colours).astype(np.int64).tolist()
    return [Face(*parts) for parts in zip(shades, corners, area.tolist(), strict=True)]
