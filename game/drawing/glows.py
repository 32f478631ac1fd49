"""Light on the arena: what was struck shines on what is around it, and so do balls.

On dark grounds light is added. On light ones, where nothing can be added, its colour takes the others away.
"""

import math
from collections import OrderedDict
from typing import NamedTuple

import numpy as np
import pygame

from game.drawing.canvas import Canvas
from game.drawing.light_colour import light_colour
from game.drawing.palette import Colour, luminance, mixed
from game.scene import Scene

_STEPS = 10
"""Strengths that a light has pictures for."""
_SIZE_STEPS = 6
"""Sizes between one and its double that a light has pictures for."""
_MOST_PIXELS = 16_000_000
"""Of all pictures cached: 64 MB."""
_BRIGHTNESS, _TINT = 0.45, 0.5
"""Share of its colour that a full light adds on dark grounds, and takes of the others on light ones."""
_SMALL = 96
"""Side of the picture that a light is drawn in, pixels."""
_SHARPNESS = 3.2
"""How fast a light falls off."""
_BALL_REACH, _BALL_STRENGTH, _BALL_HEAT = 4.2, 0.22, 0.28
"""A ball's light: its reach in radii of the ball, its strength, and what the longest row of bricks adds to it."""
_LEAST = 0.04
"""Lights weaker than this are not drawn."""


class _GlowKey(NamedTuple):
    """What a light's picture depends on.

    wide, high: half axes of the ellipse, pixels. step: of its strength, of which there are _STEPS. dark: whether the ground is.
    """

    wide: int
    high: int
    step: int
    colour: Colour
    dark: bool


class GlowPictures:
    """Draws lights; caches their pictures."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._pictures: OrderedDict[_GlowKey, pygame.Surface] = OrderedDict()
        self._pixels = 0

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
        wide = _stepped(reach * camera.scale_at(position))
        high = _stepped(wide * math.cos(camera.tilt))
        dark = luminance(canvas.theme.ground) < 0.5
        picture = self._picture(_GlowKey(wide, high, step, colour, dark))
        pixel = camera.project(position)
        flag = pygame.BLEND_RGB_ADD if dark else pygame.BLEND_RGB_MULT
        canvas.surface.blit(picture, (round(pixel.real) - wide, round(pixel.imag) - high), special_flags=flag)

    def _picture(self, key: _GlowKey) -> pygame.Surface:
        """The picture of a light; those that were not needed for the longest time make room."""
        if key in self._pictures:
            self._pictures.move_to_end(key)
            return self._pictures[key]
        picture = self._pictures[key] = _picture(key)
        self._pixels += picture.width * picture.height
        while self._pixels > _MOST_PIXELS and len(self._pictures) > 1:
            _, gone = self._pictures.popitem(last=False)
            self._pixels -= gone.width * gone.height
        return picture


def _stepped(pixels: float) -> int:
    """A size rounded so that lights of nearly the same size share a picture."""
    step = round(math.log2(max(pixels, 1.0)) * _SIZE_STEPS)
    return max(round(math.exp2(step / _SIZE_STEPS)), 1)


def _picture(key: _GlowKey) -> pygame.Surface:
    """An ellipse of light: drawn small, as nothing of it is sharp, and scaled up."""
    across = ((np.arange(_SMALL) + 0.5) * (2.0 / _SMALL) - 1.0).astype(np.float32)
    away = across[:, None] ** 2 + across[None, :] ** 2
    light = np.exp(-_SHARPNESS * away) * np.clip(1.0 - away, 0.0, 1.0) * np.float32(key.step / _STEPS)
    own = np.array(key.colour, dtype=np.float32)
    rgb = own * _BRIGHTNESS * light[..., None] if key.dark else 255.0 - (255.0 - own) * _TINT * light[..., None]
    small = pygame.Surface((_SMALL, _SMALL), 0, 32)
    pygame.surfarray.pixels3d(small)[:] = np.rint(rgb).astype(np.uint8)
    return pygame.transform.smoothscale(small, (2 * key.wide, 2 * key.high))
