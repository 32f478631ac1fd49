"""Which of many blocks hides which: an order to draw them in, from back to front, that is right from every angle.

All blocks stand on the ground, so one hides another exactly if a ray along the ground, away from the point below the eye,
meets its foot first. Blocks of one ring are parted by lines through the centre: the one nearer in angle to the eye is in
front. Two rings are parted by a circle: what a ray meets of the outer ring before the circle is in front of the inner ring,
what it meets after, behind. So the far parts of the rings come first, from the outermost inwards, then the near parts, from
the innermost outwards. Blocks are not quite the convex wedges this asks for; `widest` says how narrow is narrow enough.
"""

import math

import numpy as np

from game.drawing.camera import Camera
from game.drawing.solid.prisms import Blocks, Integers, Reals

_WIDEST, _NARROWEST = math.radians(12.0), math.radians(2.0)


def widest(inner: float, below: float) -> float:
    """Half angle up to which the blocks of a ring do not reach below a tangent of the next ring towards the centre.

    inner: radius of their inner faces; below: of the outer faces of that next ring, 0 if there is none.
    """
    return min(max(math.acos(min(below / inner, 1.0)), _NARROWEST), _WIDEST)


def back_to_front(blocks: Blocks, turn: Reals, parting: Reals, rank: Integers, camera: Camera) -> Integers:
    """Numbers of the blocks in the order to draw them. Of one slot, all that are lower come first: the eye is above them.

    turn: angle of each one's ring on the screen; parting: radius of a circle between that ring and the next towards the
    centre; rank: of the ring, counted from the centre, 1 and up.
    """
    ends = np.sin(blocks.middles + turn[:, None])
    towards = -np.minimum(ends[:, 0], ends[:, 1])  # the eye's bearing is -90 degrees
    slot = -np.sin(blocks.slot_middle + turn)
    near = math.sin(camera.tilt) * towards > camera.closeness * parting
    return np.lexsort((towards, blocks.level, blocks.slot, slot, np.where(near, rank, -rank)))
