"""What the ground is, and how large what is drawn on it is: the same for every painter."""

from typing import NamedTuple

from game.picture.ground.patterns import PLAIN
from game.rules import PADDLES
from game.scene import Scene

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


def ground_of(scene: Scene) -> Ground:
    """The ground of a scene."""
    return Ground(scene.ground_radius, scene.rings[PADDLES].radius, scene.ground)


def rim_width(scale: float) -> float:
    """Width of the rim, which begins where the ground ends, world units. scale: pixels per world unit, here and below."""
    return max(_RIM, _LEAST_RIM / scale)


def track_width(scale: float) -> float:
    """Width of the paddles' track, world units."""
    return _TRACK + _TRACK_PIXELS / scale
