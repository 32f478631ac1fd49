"""Balls as discs filled with a texture. Their skins are the desktop's: `game.drawing.balls.shading` computes both."""

import cmath
import math

from game.drawing.balls.shading import shaded
from game.drawing.camera import Camera
from game.drawing.light import ScreenLight, ball_light
from game.drawing.palette import Colour, Theme
from game.maths import NUMBERS
from game.picture.display_list import DisplayList
from physics import Ball

_SIDE = 28
"""Rows and columns of a texture."""
_MOST = 32
"""Number of textures that a painter stores."""
_LEAST_RADIUS = 1.5
"""Pixels."""
_AROUND = tuple([cmath.rect(1.0, -math.tau * k / 24) for k in range(24)])


class BallTextures:
    """Adds textures of balls to lists, and remembers which ones the painter has."""

    def __init__(self) -> None:
        """Start without textures."""
        self._numbers: dict[tuple[str, Theme, ScreenLight], int] = {}

    def texture(self, out: DisplayList, camera: Camera, theme: Theme, skin: str) -> int:
        """The number of the texture for balls; the texture is added to the list if the painter does not have it."""
        key = skin, theme, ball_light(camera)
        number = self._numbers.get(key)
        if number is None:
            if len(self._numbers) >= _MOST:
                self._numbers.clear()
            number = self._numbers[key] = len(self._numbers)
            out.texture(number, _SIDE, _colours(*key))
        return number


def add_ball(out: DisplayList, ball: Ball, camera: Camera, texture: int) -> None:
    """Add a ball. It lies on the ground, so the height of its centre is its radius."""
    pixel = camera.project(ball.position, ball.radius)
    radius = max(ball.radius * camera.scale_at(ball.position, ball.radius), _LEAST_RADIUS)
    out.textured(pixel, radius, texture)


def ball_outline(ball: Ball) -> list[complex]:
    """Corners, clockwise, of a ball from above. Its shadow has this outline, and falls as from the height of its centre."""
    return [ball.position + ball.radius * point for point in _AROUND]


def _colours(skin: str, theme: Theme, light: ScreenLight) -> list[Colour]:
    """The colours of a texture, row by row from the top. Beyond the ball's edge the colours of the edge go on."""
    found = []
    across = [(2.0 * k + 1.0) / _SIDE - 1.0 for k in range(_SIDE)]
    for up in reversed(across):
        for right in across:
            inward = 1.0 / max(math.hypot(right, up), 1.0)
            red, green, blue = shaded(NUMBERS, skin, theme, light, right * inward, up * inward)
            found.append((round(red), round(green), round(blue)))
    return found
