"""Blocks as the camera sees them: points on the screen, and the faces that can be seen, from back to front."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.blocks import Blocks, Flags, Integers, Points, Reals
from game.camera import Camera
from game.depth_order import back_to_front

LIGHT = complex(math.cos(math.radians(125.0)), math.sin(math.radians(125.0)))
"""Where the light comes from, as a bearing of the world; it also falls from above, full on every top."""
SLANT = 0.7
"""Length of a shadow over the height of what casts it, once the camera is tipped enough to show it."""
_DIMMEST, _BRIGHTEST = 0.42, 0.78
"""What of its colour a side shows that is turned from the light, and one turned to it."""

_TOP = 4
_FACES = np.array([[k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k] for k in range(4)] + [[0, 1, 2, 3]])
"""Corners of the four sides and of the top, among the top's four followed by the bottom's four."""


class Seen(NamedTuple):
    """Blocks on the screen, one a row; `order` has their numbers from back to front."""

    blocks: Blocks
    order: Integers
    foot: Points  # on the ground, turned to the screen, as in `Blocks`
    top: Points  # pixels
    bottom: Points
    shadow: Points  # of the piles on the ground, pixels; eight corners a row, one row for each of `casting`
    casting: Integers  # the numbers of the blocks that cast them
    turn: Points  # of each one's ring on the screen, a factor


class Drawn(NamedTuple):
    """What to fill, one quadrilateral a row."""

    corners: NDArray[np.int32]  # columns and rows of a drawing
    colours: NDArray[np.float32]  # red, green and blue


def seen(blocks: Blocks, phase: Reals, parting: Reals, rank: Integers, camera: Camera) -> Seen:
    """The blocks on the screen.

    phase: angle of each one's ring; parting, rank: as `back_to_front` wants them.
    """
    angle = phase - camera.azimuth
    turn = np.exp(1j * angle)
    foot = blocks.foot * turn[:, None]
    casting = np.flatnonzero(blocks.reach)
    return Seen(
        blocks,
        back_to_front(blocks, angle, parting, rank, camera),
        foot,
        camera.projected(foot, blocks.top[:, None]),
        camera.projected(foot, blocks.bottom[:, None]),
        camera.projected(_shadows(blocks, foot, turn, casting, camera), 0.0),
        casting,
        turn,
    )


def _shadows(blocks: Blocks, foot: Points, turn: Points, casting: Integers, camera: Camera) -> Points:
    """Outlines of what the piles' shadows cover of the ground: all that the feet pass over when moved along the shadow.

    A corner between two sides of which one is in front, as the shadow goes, is there twice: where it was and where it comes.
    """
    way = -LIGHT * camera.turning * SLANT * math.sin(camera.tilt)
    ahead = (blocks.normals[casting] * turn[casting, None] * way.conjugate()).real > 0.0
    around = np.repeat(foot[casting], 2, axis=1)
    leading = np.stack([np.roll(ahead, 1, axis=1), ahead], axis=2).reshape(-1, 8)
    return around + way * np.where(leading, blocks.reach[casting, None], blocks.bottom[casting, None])


def faces(things: Seen, camera: Camera, finer: int) -> Drawn:
    """All visible faces, from back to front. finer: rows and columns of a drawing per pixel.

    Of a convex block the sides that face the eye never hide one another.
    """
    blocks, order = things.blocks, things.order
    towards_the_eye = camera.nearer(things.foot, blocks.normals * things.turn[:, None]) > 0.0
    shown = np.concatenate([blocks.sides & towards_the_eye, np.ones((len(order), 1), np.bool_)], axis=1)
    place, face = np.nonzero(shown[order])
    row = order[place]
    points = np.concatenate([things.top, things.bottom], axis=1)
    pixels = np.floor(points.view(np.float64) * finer).astype(np.int32).reshape(-1, 8, 2)
    light = _light(blocks.facing[row, np.minimum(face, _TOP - 1)] * (things.turn[row] / camera.turning))
    colours = np.where((face == _TOP)[:, None], blocks.top_colour[row], blocks.side_colour[row] * light)
    return Drawn(pixels[row[:, None], _FACES[face]], colours.astype(np.float32))


def _light(facing: Points) -> Reals:
    """What of its colour each side shows, a column. facing: in the world."""
    towards = (facing * LIGHT.conjugate()).real
    return np.asarray(_DIMMEST + (_BRIGHTEST - _DIMMEST) * (0.5 + 0.5 * towards))[:, None]
