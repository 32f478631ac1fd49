"""Through what a scene is seen, for whatever makes a picture of it."""

from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.palette import Theme
from game.unlocks import PLAIN_BALL, PLAIN_TRAIL


class ArenaView(NamedTuple):
    """Camera and settings by which a scene is shown.

    unit: size of text, pixels. size: of the whole picture, pixels. trail, ball: names of the balls' trail and skin.
    """

    camera: Camera
    theme: Theme
    unit: float
    size: tuple[int, int]
    trail: str = PLAIN_TRAIL
    ball: str = PLAIN_BALL
