"""What stands between the eye and a ball.

A ball and a convex piece of a block that do not touch are parted by a vertical plane, at right angles to the line from the
piece's nearest point to the ball: the piece hides the ball only if the eye is on the piece's side of that plane.
"""

import numpy as np

from game.drawing.camera import Camera
from game.drawing.raster.arrays import Points, Reals
from game.drawing.solid.blocks import Flags
from game.drawing.solid.faces import ProjectedBlocks


def occluding_quads(blocks: ProjectedBlocks, camera: Camera, position: complex, pixel: complex, reach: float) -> Points:
    """Quadrilaterals, one a row, in pixels, that cover every part of a block in front of a ball and near it on the screen.

    position: where the ball touches the ground; pixel, reach: centre and radius of a circle around the ball on the screen.
    """
    rows = np.flatnonzero(_near(blocks, pixel, reach))
    if not len(rows):
        return np.zeros((0, 4), dtype=np.complex128)
    feet = blocks.foot[rows]
    point = position * camera.turning
    nearest = _nearest(feet, point)
    ahead = camera.nearer(nearest, point - nearest) <= 0.0
    tops, bottoms = blocks.top[rows[ahead]], blocks.bottom[rows[ahead]]
    sides = [np.stack([tops[:, k], tops[:, k - 1], bottoms[:, k - 1], bottoms[:, k]], axis=1) for k in range(4)]
    return np.concatenate([tops, *sides])


def _near(blocks: ProjectedBlocks, pixel: complex, reach: float) -> Flags:
    """Which blocks have a bounding box on the screen that meets the circle's."""
    points = np.stack([*blocks.top.T, *blocks.bottom.T]) - pixel
    across = (points.real.min(axis=0) < reach) & (points.real.max(axis=0) > -reach)
    down = (points.imag.min(axis=0) < reach) & (points.imag.max(axis=0) > -reach)
    return np.asarray(across & down & (blocks.blocks.top > blocks.blocks.bottom))


def _nearest(feet: Points, point: complex) -> Points:
    """The point of each foot's outline that is nearest to a point."""
    along = np.roll(feet, -1, axis=1) - feet
    share = ((point - feet) * along.conjugate()).real / np.maximum(_squared_lengths(along), 1e-18)
    candidates = feet + np.clip(share, 0.0, 1.0) * along
    best = np.argmin(_squared_lengths(candidates - point), axis=1)
    return np.asarray(candidates[np.arange(len(candidates)), best])


def _squared_lengths(offsets: Points) -> Reals:
    """Squared lengths of complex numbers."""
    return np.asarray(offsets.real * offsets.real + offsets.imag * offsets.imag)
