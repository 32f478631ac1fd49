"""Comparison b at every tick: does pymunk find the ball in material where the game says that it flies?"""

import math
from typing import NamedTuple

from tools.crosscheck.pymunk_model.ring_model import Part, RingModel

_LOOK = 0.5
"""World units beyond the ball in which pymunk is asked for the nearest shape. Its answer then serves for several ticks."""


class Pose(NamedTuple):
    """A ball in a ring's frame, and the room pymunk found around it."""

    place: complex
    room: float  # no living shape of the ring is nearer to the ball's rim than this; < 0: overlaps by that much
    part: Part | None  # the nearest shape's; None where there is none near


UNKNOWN = Pose(0j, -math.inf, None)
"""Before pymunk was asked, or after material has come to life."""


def room_around(model: RingModel, place: complex, ball_radius: float, last: Pose, wanted: float) -> Pose:
    """What pymunk last found around a ball, if that still leaves the room wanted here; else what it finds here.

    In the ring's frame its shapes stand still, and the distance to them changes by no more than the ball moves: room found
    at one place proves the absence of touch at all places less than that away. So pymunk's word at every tick costs a query
    only where the ball is near something.
    """
    if last.room - abs(place - last.place) >= wanted:
        return last
    found = model.nearest(place, ball_radius + _LOOK)
    if found is None:
        return Pose(place, _LOOK, None)
    return Pose(place, found[1] - ball_radius, found[0].part)
