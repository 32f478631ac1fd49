"""What stands between the eye and a ball.

A ball and a convex piece of a block that do not touch are parted by the vertical plane at right angles to the way from the
piece's nearest point to the ball: the piece hides the ball only if the eye is on the piece's side of it.
"""

import numpy as np

from game.drawing.camera import Camera
from game.drawing.solid.faces import Seen
from game.drawing.solid.prisms import Flags, Points, Reals


def hiding(things: Seen, camera: Camera, place: complex, pixel: complex, reach: float) -> Points:
    """Quadrilaterals, one a row, in pixels, that cover every part of a block in front of a ball and near it on the screen.

    place: where the ball touches the ground; pixel, reach: a circle around the ball on the screen.
    """
    rows = np.flatnonzero(_near(things, pixel, reach))
    if not len(rows):
        return np.zeros((0, 4), dtype=np.complex128)
    feet = things.foot[rows]
    point = place * camera.turning
    nearest = _nearest(feet, point)
    ahead = camera.nearer(nearest, point - nearest) <= 0.0
    tops, bottoms = things.top[rows[ahead]], things.bottom[rows[ahead]]
    sides = [np.stack([tops[:, k], tops[:, k - 1], bottoms[:, k - 1], bottoms[:, k]], axis=1) for k in range(4)]
    return np.concatenate([tops, *sides])


def _near(things: Seen, pixel: complex, reach: float) -> Flags:
    """Which blocks have a box on the screen that meets the circle's."""
    points = np.stack([*things.top.T, *things.bottom.T]) - pixel
    across = (points.real.min(axis=0) < reach) & (points.real.max(axis=0) > -reach)
    down = (points.imag.min(axis=0) < reach) & (points.imag.max(axis=0) > -reach)
    return np.asarray(across & down & (things.blocks.top > things.blocks.bottom))


def _nearest(pieces: Points, point: complex) -> Points:
    """The nearest point of each piece's outline."""
    along = np.roll(pieces, -1, axis=1) - pieces
    share = ((point - pieces) * along.conjugate()).real / np.maximum(_square(along), 1e-18)
    feet = pieces + np.clip(share, 0.0, 1.0) * along
    best = np.argmin(_square(feet - point), axis=1)
    return np.asarray(feet[np.arange(len(feet)), best])


def _square(ways: Points) -> Reals:
    """Squared lengths."""
    return np.asarray(ways.real * ways.real + ways.imag * ways.imag)
