"""Circles that run over the ground."""

import math

import numpy as np
import pygame

from game.drawing.camera import Camera, Points
from game.drawing.palette import Colour, Theme, mixed
from game.effects import Wave
from game.effects.waves import Tone

_POINTS = 121
_WIDTH = 0.014
"""Of the ground's radius."""
_LEAST = 0.5
"""Pixels, half of a circle's width."""
_FAINTEST = 0.06
_AROUND = np.exp(1j * np.linspace(0.0, math.tau, _POINTS))


def draw(surface: pygame.Surface, waves: tuple[Wave, ...], ground_radius: float, camera: Camera, theme: Theme) -> None:
    """The circles that are on their way, fainter and fainter."""
    colours = {Tone.START: theme.rim, Tone.GOOD: theme.accent, Tone.BAD: theme.danger}
    for wave in waves:
        strength = 1.0 - wave.share
        if wave.age < 0 or strength < _FAINTEST:
            continue
        colour = mixed(theme.ground, colours[wave.tone], strength)
        half = max(0.5 * _WIDTH * ground_radius * (1.0 - 0.6 * wave.share), _LEAST / camera.scale)
        _draw_circle(surface, wave.radius, half, colour, camera)


def _draw_circle(surface: pygame.Surface, radius: float, half: float, colour: Colour, camera: Camera) -> None:
    """A circle about the centre: filled up to a pixel from its edges, and lines from there to the edges, which smooth them."""
    pixel = 1.0 / camera.scale
    if half > pixel:
        outer, inner = _circle(radius + half - pixel, camera), _circle(radius - half + pixel, camera)
        pygame.draw.polygon(surface, colour, _pairs(np.concatenate([outer, inner[::-1]])))
    for inset in (1.2 * pixel, 0.5 * pixel):
        for edge in (radius + max(half - inset, 0.0), radius - max(half - inset, 0.0)):
            pygame.draw.aalines(surface, colour, False, _pairs(_circle(edge, camera) - (0.5 + 0.5j)))


def _circle(radius: float, camera: Camera) -> Points:
    """A circle of the ground, pixels."""
    return camera.projected(_AROUND * max(radius, 0.0), 0.0)


def _pairs(points: Points) -> list[list[float]]:
    """Points as pygame takes them."""
    return points.view(np.float64).reshape(-1, 2).tolist()
