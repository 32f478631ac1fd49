"""Circles that run over the ground."""

import math

import numpy as np
import pygame

from game.camera import Camera
from game.effects import Wave
from game.effects.waves import Tone
from game.palette import Theme, mixed

_POINTS = 96
_WIDTH = 0.014
"""Of the ground's radius."""
_FAINTEST = 0.06
_AROUND = np.exp(1j * np.linspace(0.0, math.tau, _POINTS, endpoint=False))


def draw(surface: pygame.Surface, waves: tuple[Wave, ...], ground_radius: float, camera: Camera, theme: Theme) -> None:
    """The circles that are on their way, fainter and fainter."""
    colours = {Tone.START: theme.rim, Tone.GOOD: theme.accent, Tone.BAD: theme.danger}
    for wave in waves:
        strength = 1.0 - wave.share
        if wave.age < 0 or strength < _FAINTEST:
            continue
        lines = max(2, round(_WIDTH * ground_radius * camera.scale))
        for line in range(lines):
            edge = abs(2.0 * line / (lines - 1) - 1.0)  # 0 in the middle of the circle's line, 1 at its edges
            colour = mixed(theme.ground, colours[wave.tone], strength * (1.0 - 0.7 * edge))
            radius = wave.radius + (line - (lines - 1) / 2.0) / camera.scale
            circle = camera.projected(_AROUND * max(radius, 0.0), 0.0) - (0.5 + 0.5j)
            pygame.draw.aalines(surface, colour, True, circle.view(np.float64).reshape(-1, 2).tolist())
