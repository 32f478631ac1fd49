"""Blocks as the camera sees them: points on the screen, and the faces that can be seen, from back to front."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.light import LIGHT, shadow_offset
from game.drawing.raster.arrays import Points, Reals
from game.drawing.raster.quads import FinePixels, fine_pixels
from game.drawing.solid.blocks import Blocks, Flags, Integers
from game.picture.moving.balls import ball_outline
from physics import Ball

_MARGIN = 1.3
"""Factor for what the equations of hidden shadows leave out: perspective, and that walls are bent."""
_TOP = 4
"""Number of the top among a block's faces; its sides come first."""
_FACES = np.array([[k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k] for k in range(4)] + [[0, 1, 2, 3]])
"""Corners of the four sides and of the top, among the top's four followed by the bottom's four."""


class ProjectedBlocks(NamedTuple):
    """Blocks on the screen, one a row.

    blocks: the blocks themselves.
    order: their numbers, from back to front.
    foot: four corners on the ground, world units, turned by `Camera.turning`; numbered as in `Blocks`.
    top, bottom: their four corners, pixels.
    facing: which of the four sides are turned to the eye.
    turn: a factor that turns the block's ring from phase 0 to where it is on the screen.
    """

    blocks: Blocks
    order: Integers
    foot: Points
    top: Points
    bottom: Points
    facing: Flags
    turn: Points


class Faces(NamedTuple):
    """What to fill, one quadrilateral a row.

    corners: four of each, as `QuadRaster` takes them.
    colours: red, green and blue, 0 to 255.
    """

    corners: FinePixels
    colours: NDArray[np.float32]


def projected(blocks: Blocks, phase: Reals, order: Integers, camera: Camera) -> ProjectedBlocks:
    """The blocks on the screen. phase: angle of each one's ring; order: as in `ProjectedBlocks`."""
    turn = np.exp(1j * (phase - camera.azimuth))
    foot = blocks.foot * turn[:, None]
    return ProjectedBlocks(
        blocks,
        order,
        foot,
        camera.projected(foot, blocks.top[:, None]),
        camera.projected(foot, blocks.bottom[:, None]),
        camera.nearer(foot, blocks.normals * turn[:, None]) > 0.0,
        turn,
    )


def visible_faces(seen: ProjectedBlocks, camera: Camera, finer: int, shares: tuple[float, float]) -> Faces:
    """All visible faces, from back to front. finer: rows and columns of the drawing per pixel. shares: as of `side_shares`.

    Of a convex block the sides that face the eye never hide one another.
    """
    blocks, order = seen.blocks, seen.order
    shown = np.concatenate([blocks.sides & seen.facing, np.ones((len(order), 1), np.bool_)], axis=1)
    position, face = np.nonzero(shown[order])
    row = order[position]
    points = fine_pixels(np.concatenate([seen.top, seen.bottom], axis=1), finer)
    light = _light(blocks.facing[row, np.minimum(face, _TOP - 1)] * (seen.turn[row] / camera.turning), shares)
    light[face == _TOP] = 1.0
    colours = blocks.colours[row] * light[:, None]
    return Faces(points.ravel()[8 * row[:, None] + _FACES[face]], colours.astype(np.float32))


def shadows(seen: ProjectedBlocks, balls: tuple[Ball, ...], camera: Camera, finer: int) -> FinePixels:
    """The ground in the shadow of blocks and balls, as quadrilaterals.

    A block's shadow is what its sides that are turned from the light pass over as they are moved down the light, and while it
    falls, what its foot does.
    """
    blocks, down_light = seen.blocks, shadow_offset(camera) * camera.turning
    ahead = (blocks.normals * (seen.turn * down_light.conjugate())[:, None]).real > 0.0
    falling = blocks.casting[:, 0] & (blocks.bottom > 0.0)
    row, side = np.nonzero(blocks.casting & ahead)
    ends = [blocks.shadow_foot[row, end] * seen.turn[row] for end in (side, (side + 1) % 4)]
    low, high = down_light * blocks.bottom[row], down_light * blocks.shadow_top[row]
    corners = [np.stack([ends[0] + low, ends[1] + low, ends[1] + high, ends[0] + high], axis=1)]
    corners.append(blocks.shadow_foot[falling] * seen.turn[falling, None] + down_light * blocks.bottom[falling, None])
    corners += [_strips(ball_outline(ball)) * camera.turning + down_light * ball.radius for ball in balls]
    pixels = camera.projected(np.concatenate(corners), 0.0)
    shown = np.ones(len(pixels), dtype=np.bool_)
    away = np.flatnonzero(~(falling[row] | seen.facing[row, side]))
    lean = math.tan(camera.tilt)
    shown[away] = ~_hidden(seen, row[away], side[away], np.asarray(high[away]), pixels[away, 2:], lean)
    return fine_pixels(pixels[shown], finer)


def _hidden(seen: ProjectedBlocks, row: Integers, side: Integers, offset: Points, far: Points, lean: float) -> Flags:
    """Which shadows of sides that are turned from the eye are wholly behind what stands there, a wall of blocks.

    The side is so far aside that one does not see through the gaps in the wall; the wall goes on at both ends of the block, at
    least as far as the shadow does; and on the screen the shadow ends below the wall's top edge.
    row, side: of each shadow's block, and the side that casts it. offset: of the far edge from the side, world units, turned by
    `Camera.turning`; far: its ends, pixels. lean: how far along the ground a line of sight goes for each unit of height.
    """
    blocks, following = seen.blocks, (side + 1) % 4
    casting, along = blocks.casting[row], seen.foot[row, following] - seen.foot[row, side]
    aside = np.abs((blocks.normals[row, side] * seen.turn[row]).real)
    inside = ~(casting[:, 1] | casting[:, 3])
    gap = np.abs(blocks.shadow_foot[row] - blocks.foot[row]).max(axis=1)
    inside &= aside * lean * (blocks.top[row] - blocks.bottom[row]) >= _MARGIN * gap
    inside &= np.abs((offset * along.conjugate()).real) <= np.abs(along) ** 2
    begin = seen.top[row, side]
    edge = (seen.top[row, following] - begin).conjugate()
    below = np.sign(((seen.bottom[row, side] - begin) * edge).imag)[:, None]
    inside &= (((far - begin[:, None]) * edge[:, None]).imag * below >= np.abs(edge)[:, None]).all(axis=1)  # by a pixel
    return np.asarray(inside)


def _strips(outline: list[complex]) -> Points:
    """A convex polygon with an even number of corners, cut into quadrilaterals, one a row."""
    around = np.array(outline)
    half = len(outline) // 2
    there, back = around[:half], around[: half - 1 : -1]
    return np.stack([there[:-1], there[1:], back[1:], back[:-1]], axis=1)


def _light(facing: Points, shares: tuple[float, float]) -> Reals:
    """Share of its colour that each side shows. facing: directions that they are turned to; shares: as of `side_shares`."""
    towards = (facing * LIGHT.conjugate()).real
    return np.asarray(shares[0] + (shares[1] - shares[0]) * (0.5 + 0.5 * towards))
