"""What the ground is, and how large what is drawn on it is: the same for every painter."""

from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.ground.patterns import PLAIN

THICKNESS = 0.03
"""Of the disc that the ground is, in shares of its radius."""
EDGE_SHADE = 0.6
"""The side of the disc has this share of the way from the rim's colour to the background's."""
_RIM, _LEAST_RIM = 0.07, 2.0
"""Width of the rim: world units, and pixels."""
_TRACK, _TRACK_PIXELS = 0.03, 1.0
"""The paddles' track is so many world units wide, and so many pixels more."""


class Ground(NamedTuple):
    """What the ground is.

    radius: world units.
    track: radius of the circle that the paddles run on; None for none.
    pattern: its name.
    """

    radius: float
    track: float | None = None
    pattern: str = PLAIN


def rim_width(camera: Camera) -> float:
    """Width of the rim, which begins where the ground ends, world units."""
    return max(_RIM, _LEAST_RIM / camera.scale)


def track_width(camera: Camera) -> float:
    """Width of the paddles' track, world units."""
    return _TRACK + _TRACK_PIXELS / camera.scale
