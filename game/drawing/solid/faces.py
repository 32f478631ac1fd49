"""Blocks as the camera sees them: points on the screen, and the faces that can be seen, from back to front."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.solid.painters_order import back_to_front
from game.drawing.solid.prisms import Blocks, Flags, Integers, Points, Reals
from game.drawing.solid.quad_raster import Pixels, in_pixels
from physics import Ball

LIGHT = complex(math.cos(math.radians(125.0)), math.sin(math.radians(125.0)))
"""Where the light comes from, as a bearing of the world; it also falls from above, full on every top."""
SLANT = 0.7
"""Length of a shadow over the height of what casts it, once the camera is tipped enough to show it."""
_DIMMEST, _BRIGHTEST = 0.42, 0.78
"""What of its colour a side shows that is turned from the light, and one turned to it."""

_TOP = 4
_FACES = np.array([[k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k] for k in range(4)] + [[0, 1, 2, 3]])
"""Corners of the four sides and of the top, among the top's four followed by the bottom's four."""
_AROUND = np.exp(1j * np.linspace(0.0, math.tau, 25))
_DISC = np.stack([_AROUND[:12], _AROUND[1:13], _AROUND[-2:-14:-1], _AROUND[-1:-13:-1]], axis=1)
"""A disc of radius 1, cut into strips."""


class Seen(NamedTuple):
    """Blocks on the screen, one a row; `order` has their numbers from back to front."""

    blocks: Blocks
    order: Integers
    foot: Points  # on the ground, turned to the screen, as in `Blocks`
    top: Points  # pixels
    bottom: Points
    facing: Flags  # which of its sides are turned to the eye
    turn: Points  # of each one's ring on the screen, a factor


class Drawn(NamedTuple):
    """What to fill, one quadrilateral a row."""

    corners: Pixels
    colours: NDArray[np.float32]  # red, green and blue


def seen(blocks: Blocks, phase: Reals, parting: Reals, rank: Integers, camera: Camera) -> Seen:
    """The blocks on the screen.

    phase: angle of each one's ring; parting, rank: as `back_to_front` wants them.
    """
    angle = phase - camera.azimuth
    turn = np.exp(1j * angle)
    foot = blocks.foot * turn[:, None]
    return Seen(
        blocks,
        back_to_front(blocks, angle, parting, rank, camera),
        foot,
        camera.projected(foot, blocks.top[:, None]),
        camera.projected(foot, blocks.bottom[:, None]),
        camera.nearer(foot, blocks.normals * turn[:, None]) > 0.0,
        turn,
    )


def faces(things: Seen, camera: Camera, finer: int) -> Drawn:
    """All visible faces, from back to front. finer: rows and columns of a drawing per pixel.

    Of a convex block the sides that face the eye never hide one another.
    """
    blocks, order = things.blocks, things.order
    shown = np.concatenate([blocks.sides & things.facing, np.ones((len(order), 1), np.bool_)], axis=1)
    place, face = np.nonzero(shown[order])
    row = order[place]
    points = in_pixels(np.concatenate([things.top, things.bottom], axis=1), finer)
    top = face == _TOP
    light = _light(blocks.facing[row, np.minimum(face, _TOP - 1)] * (things.turn[row] / camera.turning))
    light[top] = 1.0
    colours = blocks.colours.reshape(-1, 3)[2 * row + top] * light[:, None]
    return Drawn(points.ravel()[8 * row[:, None] + _FACES[face]], colours.astype(np.float32))


def shadows(things: Seen, balls: tuple[Ball, ...], camera: Camera, finer: int) -> Pixels:
    """The ground in the shadow of blocks and balls, as quadrilaterals.

    In a block's lies what its sides that are turned from the light pass over on their way down the light, and its foot does
    while it falls. What a side turned from the eye throws is hidden by a block that stands, if it does not end a row. A
    ball's shadow is a disc.
    """
    blocks, way = things.blocks, -LIGHT * camera.turning * SLANT * math.sin(camera.tilt)
    ahead = (blocks.normals * (things.turn * way.conjugate())[:, None]).real > 0.0
    falling = blocks.casting[:, 0] & (blocks.bottom > 0.0)
    seen_around = (blocks.casting[:, 1] | blocks.casting[:, 3] | falling)[:, None]
    row, side = np.nonzero(blocks.casting & ahead & (things.facing | seen_around))
    ends = things.foot[row, side], things.foot[row, (side + 1) % 4]
    low, high = way * blocks.bottom[row], way * blocks.reach[row]
    corners = [np.stack([ends[0] + low, ends[1] + low, ends[1] + high, ends[0] + high], axis=1)]
    corners.append(things.foot[falling] + way * blocks.bottom[falling, None])
    corners += [ball.position * camera.turning + ball.radius * (way + _DISC) for ball in balls]
    return in_pixels(camera.projected(np.concatenate(corners), 0.0), finer)


def _light(facing: Points) -> Reals:
    """What of its colour each side shows. facing: in the world."""
    towards = (facing * LIGHT.conjugate()).real
    return np.asarray(_DIMMEST + (_BRIGHTEST - _DIMMEST) * (0.5 + 0.5 * towards))
