"""How much room does pymunk find around a ball?"""

import math
from typing import NamedTuple

from tools.crosscheck.pymunk_model.ring_model import Part, RingModel

_LOOK = 0.5
"""World units beyond the ball in which pymunk is asked for the nearest shape. Its answer then serves for several ticks."""


class Room(NamedTuple):
    """The room that pymunk found around a ball.

    position: of the ball in the ring's frame. room: world units; no living shape of the ring is nearer to the ball's rim than
    this; negative for a ball in material. part: of the nearest shape, None where none is near.
    """

    position: complex
    room: float
    part: Part | None


UNKNOWN = Room(0j, -math.inf, None)
"""Before pymunk was asked, or after material has come to life."""


def room_around(model: RingModel, position: complex, ball_radius: float, last: Room, wanted: float) -> Room:
    """What pymunk last found around a ball, if that still leaves the room wanted here; else what it finds here.

    In the ring's frame its shapes stand still, and the distance to them changes by no more than the ball moves: room found
    at one position proves the absence of touch at all positions less than that away. So pymunk's word at every tick costs a
    query only where the ball is near something.
    """
    if last.room - abs(position - last.position) >= wanted:
        return last
    found = model.nearest_exact(position, ball_radius + _LOOK)
    if found is None:
        return Room(position, _LOOK, None)
    return Room(position, found[1] - ball_radius, found[0].part)
