"""Light on the arena: what was struck shines on what is around it, and so do balls.

On dark grounds light is added. On light ones, where nothing can be added, its colour takes the others away.
"""

import math

import numpy as np
import pygame

from game.drawing.arcade.signs import power_colour
from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, Theme, layer_colour, luminance, mixed
from game.effects import Light, LightSource
from game.scene import Scene

_STEPS = 10
"""Strengths that a light has pictures for."""
_SIZE_STEPS = 6
"""Sizes between one and its double that a light has pictures for."""
_MOST_PICTURES = 160
_BRIGHTNESS, _TINT = 0.45, 0.5
"""Share of its colour that a full light adds on dark grounds, and takes of the others on light ones."""
_SHARPNESS = 3.2
"""How fast a light falls off."""
_BALL_REACH, _BALL_STRENGTH, _BALL_HEAT = 4.2, 0.22, 0.28
"""A ball's light: its reach in radii of the ball, its strength, and what the longest row of bricks adds to it."""
_LEAST = 0.04
"""Lights weaker than this are not drawn."""


class GlowPictures:
    """Draws lights; caches their pictures."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._pictures: dict[tuple[int, int, int, Colour, bool], pygame.Surface] = {}

    def draw(self, canvas: Canvas, scene: Scene) -> None:
        """The lights of a scene and those of its balls."""
        theme = canvas.theme
        for light in scene.lights:
            self._draw(canvas, light.position, light.reach * scene.ground_radius, _colour(light, theme), light.now)
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
        key = (wide, high, step, colour, dark)
        if key not in self._pictures:
            if len(self._pictures) >= _MOST_PICTURES:
                self._pictures.clear()
            self._pictures[key] = _picture(wide, high, step / _STEPS, colour, dark=dark)
        pixel = camera.project(position)
        flag = pygame.BLEND_RGB_ADD if dark else pygame.BLEND_RGB_MULT
        canvas.surface.blit(self._pictures[key], (round(pixel.real) - wide, round(pixel.imag) - high), special_flags=flag)


def _colour(light: Light, theme: Theme) -> Colour:
    """The colour of a light."""
    if light.source is LightSource.BRICK:
        return layer_colour(theme, light.layer)
    if light.power is not None:
        return power_colour(light.power, theme)
    plain = {LightSource.PADDLE: theme.paddle_top, LightSource.STEEL: theme.steel, LightSource.BAD: theme.danger}
    return plain.get(light.source, theme.accent)


def _stepped(pixels: float) -> int:
    """A size rounded so that lights of nearly the same size share a picture."""
    step = round(math.log2(max(pixels, 1.0)) * _SIZE_STEPS)
    return max(round(math.exp2(step / _SIZE_STEPS)), 1)


def _picture(wide: int, high: int, strength: float, colour: Colour, *, dark: bool) -> pygame.Surface:
    """An ellipse of light. wide, high: its half axes, pixels."""
    across = ((np.arange(2 * wide) + 0.5) / wide - 1.0).astype(np.float32)[:, None]
    down = ((np.arange(2 * high) + 0.5) / high - 1.0).astype(np.float32)[None, :]
    away = across * across + down * down
    light = np.exp(-_SHARPNESS * away) * np.clip(1.0 - away, 0.0, 1.0) * np.float32(strength)
    own = np.array(colour, dtype=np.float32)
    rgb = own * _BRIGHTNESS * light[..., None] if dark else 255.0 - (255.0 - own) * _TINT * light[..., None]
    picture = pygame.Surface((2 * wide, 2 * high), 0, 32)
    pygame.surfarray.pixels3d(picture)[:] = np.rint(rgb).astype(np.uint8)
    return picture
