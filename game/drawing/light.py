"""Where the light comes from: one direction for blocks, shadows, shards and balls."""

import math
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.palette import Theme

LIGHT = complex(math.cos(math.radians(125.0)), math.sin(math.radians(125.0)))
"""Direction towards the light, along the ground of the world; it also falls from above, full on every top."""
SHADOW_SLANT = 0.7
"""Length of a shadow over the height of what casts it, once the camera is tipped enough to show it."""
_DIMMEST, _BRIGHTEST = 0.42, 0.78
"""Shares of its colour that a side shows when it is turned from the light, and towards it, where a theme's shade is 1."""
_BALL_LIGHT_HEIGHT = math.radians(50.0)
"""Angle of the light that balls show, above the ground."""
_STEPS = 8.0
"""A ball's light is rounded to this part of a unit: balls that look nearly the same share a picture."""


class ScreenLight(NamedTuple):
    """The direction towards the light as the screen has it: a unit vector, rounded.

    right, up: along the screen.
    out: out of the screen, towards the player.
    """

    right: float
    up: float
    out: float


def side_shares(theme: Theme) -> tuple[float, float]:
    """Shares of its colour that a side of a block shows when it is turned from the light, and towards it.

    In between it is the cosine of the angle between them that counts.
    """
    return 1.0 - theme.shade * (1.0 - _DIMMEST), 1.0 - theme.shade * (1.0 - _BRIGHTEST)


def shadow_offset(camera: Camera) -> complex:
    """How far a shadow is from the point that casts it, for each unit of the point's height, along the ground."""
    return -LIGHT * SHADOW_SLANT * math.sin(camera.tilt)


def ball_light(camera: Camera) -> ScreenLight:
    """The light that a ball shows to a camera."""
    towards, sine, cosine = LIGHT * camera.turning, math.sin(camera.tilt), math.cos(camera.tilt)
    level, high = math.cos(_BALL_LIGHT_HEIGHT), math.sin(_BALL_LIGHT_HEIGHT)
    parts = (
        towards.real * level,
        towards.imag * level * cosine + high * sine,
        high * cosine - towards.imag * level * sine,
    )
    return ScreenLight(*[round(part * _STEPS) / _STEPS for part in parts])
