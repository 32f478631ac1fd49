"""Light on the arena: what was struck shines on what is around it, and so do balls.

On dark grounds light is added. On light ones, where nothing can be added, its colour takes the others away.
"""

import math
from functools import lru_cache

import numpy as np
import pygame

from game.drawing.canvas import Canvas
from game.drawing.light_colour import light_colour
from game.drawing.palette import Colour, luminance, mixed
from game.scene import Scene

_STEPS = 10
"""Strengths that a light has pictures for."""
_BRIGHTNESS, _TINT = 0.45, 0.5
"""Share of its colour that a full light adds on dark grounds, and takes of the others on light ones."""
_SMALL = 96
"""Side of the picture that a light is drawn in and scaled up from, pixels."""
_SHARPNESS = 3.2
"""How fast a light falls off."""
_BALL_REACH, _BALL_STRENGTH, _BALL_HEAT = 4.2, 0.22, 0.28
"""A ball's light: its reach in radii of the ball, its strength, and what the longest row of bricks adds to it."""
_LEAST = 0.04
"""Lights weaker than this are not drawn."""


class GlowPictures:
    """Draws lights; reuses the memory that they are scaled up in, for new memory costs more than the scaling."""

    def __init__(self) -> None:
        """Start with no memory."""
        self._scaled = pygame.Surface((1, 1), 0, 32)

    def draw(self, canvas: Canvas, scene: Scene) -> None:
        """The lights of a scene and those of its balls."""
        theme = canvas.theme
        for light in scene.lights:
            self._draw(canvas, light.position, light.reach * scene.ground_radius, light_colour(light, theme), light.now)
        if scene.shining:
            warm = mixed(theme.trail, theme.accent, scene.heat)
            for ball in scene.balls:
                strength = _BALL_STRENGTH + _BALL_HEAT * scene.heat
                self._draw(canvas, ball.position, _BALL_REACH * ball.radius, warm, strength)

    def _draw(self, canvas: Canvas, position: complex, reach: float, colour: Colour, strength: float) -> None:
        """One light on the ground. reach: world units; strength: 0 to 1."""
        step = math.ceil(strength * _STEPS)
        if strength < _LEAST or canvas.theme.glow == 0.0:
            return
        camera = canvas.camera
        wide = max(round(reach * camera.scale_at(position)), 1)
        high = max(round(wide * math.cos(camera.tilt)), 1)
        dark = luminance(canvas.theme.ground) < 0.5
        picture = self._room(2 * wide, 2 * high)
        pygame.transform.smoothscale(_small_picture(step, colour, dark=dark), picture.size, picture)
        pixel = camera.project(position)
        flag = pygame.BLEND_RGB_ADD if dark else pygame.BLEND_RGB_MULT
        canvas.surface.blit(picture, (round(pixel.real) - wide, round(pixel.imag) - high), special_flags=flag)

    def _room(self, width: int, height: int) -> pygame.Surface:
        """A part of the memory, so many pixels wide and high."""
        whole = self._scaled
        if whole.width < width or whole.height < height:
            whole = self._scaled = pygame.Surface((max(whole.width, width), max(whole.height, height)), 0, 32)
        return whole.subsurface((0, 0, width, height))


@lru_cache(maxsize=256)
def _small_picture(step: int, colour: Colour, *, dark: bool) -> pygame.Surface:
    """A round light, small, as nothing of it is sharp. step: of its strength, up to _STEPS; dark: whether the ground is."""
    across = ((np.arange(_SMALL) + 0.5) * (2.0 / _SMALL) - 1.0).astype(np.float32)
    away = across[:, None] ** 2 + across[None, :] ** 2
    light = np.exp(-_SHARPNESS * away) * np.clip(1.0 - away, 0.0, 1.0) * np.float32(step / _STEPS)
    own = np.array(colour, dtype=np.float32)
    rgb = own * _BRIGHTNESS * light[..., None] if dark else 255.0 - (255.0 - own) * _TINT * light[..., None]
    small = pygame.Surface((_SMALL, _SMALL), 0, 32)
    pygame.surfarray.pixels3d(small)[:] = np.rint(rgb).astype(np.uint8)
    return small
