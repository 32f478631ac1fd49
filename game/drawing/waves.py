"""Circles that run over the ground, as any camera sees them."""

import math

import numpy as np
import pygame

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, mixed
from game.drawing.raster.arrays import Points
from game.drawing.raster.pixels import pairs
from game.drawing.raster.primitives import HALF_PIXEL
from game.effects.waves import WaveTone
from game.scene import Scene

_WIDTH = 0.014
"""Width of a new circle's line, in shares of the ground's radius."""
_THINNING = 0.6
"""Share of its width that the line loses by the end."""
_LEAST_HALF_WIDTH = 0.5
"""Pixels."""
_FAINTEST = 0.06
"""Strength below which a circle is not drawn: 1 new to 0 gone."""
_AROUND = np.exp(1j * np.linspace(0.0, math.tau, 121))


def draw(canvas: Canvas, scene: Scene) -> None:
    """The circles that are running, fainter and fainter."""
    theme, camera = canvas.theme, canvas.camera
    colours = {WaveTone.START: theme.rim, WaveTone.GOOD: theme.accent, WaveTone.BAD: theme.danger}
    for wave in scene.waves:
        strength = 1.0 - wave.share
        if wave.age < 0 or strength < _FAINTEST:
            continue
        colour = mixed(theme.ground, colours[wave.tone], strength)
        half_width = 0.5 * _WIDTH * scene.ground_radius * (1.0 - _THINNING * wave.share)
        _draw_circle(canvas.surface, camera, wave.radius, max(half_width, _LEAST_HALF_WIDTH / camera.scale), colour)


def _draw_circle(surface: pygame.Surface, camera: Camera, radius: float, half_width: float, colour: Colour) -> None:
    """A circle about the centre: filled up to a pixel from its edges, and lines from there to the edges, which smooth them."""
    pixel = 1.0 / camera.scale
    if half_width > pixel:
        outer, inner = _circle(radius + half_width - pixel, camera), _circle(radius - half_width + pixel, camera)
        pygame.draw.polygon(surface, colour, pairs(np.concatenate([outer, inner[::-1]])))
    for inset in (1.2 * pixel, 0.5 * pixel):
        for edge in (radius + max(half_width - inset, 0.0), radius - max(half_width - inset, 0.0)):
            pygame.draw.aalines(surface, colour, False, pairs(_circle(edge, camera) - HALF_PIXEL))


def _circle(radius: float, camera: Camera) -> Points:
    """A circle of the ground, pixels."""
    return camera.projected(_AROUND * max(radius, 0.0), 0.0)
