"""A ball's picture, and what is left of it behind something."""

import math
from typing import NamedTuple

import numpy as np
import pygame

from game.drawing.camera import Camera, Points
from game.drawing.palette import Theme, mixed
from game.drawing.solid.faces import LIGHT

_FINER = 4
_HEIGHT = math.radians(50.0)
"""Of the light above the ground."""


class Light(NamedTuple):
    """Where the light comes from, seen from the screen: a unit vector, in steps of an eighth."""

    right: float
    up: float
    out: float  # of the screen


def light_on(camera: Camera) -> Light:
    """The light that a ball shows: the one that blocks show, half way up the sky."""
    way, sine, cosine = LIGHT * camera.turning, math.sin(camera.tilt), math.cos(camera.tilt)
    level, high = math.cos(_HEIGHT), math.sin(_HEIGHT)
    parts = (way.real * level, way.imag * level * cosine + high * sine, high * cosine - way.imag * level * sine)
    return Light(*[round(part * 8.0) / 8.0 for part in parts])


def ball_picture(radius: float, across: float, down: float, light: Light, theme: Theme) -> pygame.Surface:
    """A shaded ball on a transparent square with an odd side, its centre (across, down) into the middle pixel."""
    reach = math.ceil(radius) + 2
    side = 2 * reach + 1
    pixels = np.arange(side) + 0.5 - reach
    right, up = (pixels - across)[:, None] / max(radius, 0.5), (down - pixels)[None, :] / max(radius, 0.5)
    away = np.hypot(right, up)
    out = np.sqrt(np.maximum(1.0 - away * away, 0.0))
    facing = right * light.right + up * light.up + out * light.out
    shade = np.clip(0.5 + 0.6 * facing, 0.0, 1.0)[:, :, None] ** 1.3
    shine = np.clip(2.0 * out * facing - light.out, 0.0, 1.0)[:, :, None] ** 24.0
    dark, white = (np.array(colour, dtype=np.float64) for colour in (mixed(theme.ball, (20, 30, 70), 0.55), (255, 255, 255)))
    rgb = dark + (np.array(theme.ball, dtype=np.float64) - dark) * shade
    rgb += (white - rgb) * 0.7 * shine
    picture = pygame.Surface((side, side), pygame.SRCALPHA)
    pygame.surfarray.pixels3d(picture)[:] = rgb.astype(np.uint8)
    pygame.surfarray.pixels_alpha(picture)[:] = (np.clip((1.0 - away) * radius + 0.5, 0.0, 1.0) * 255.0).astype(np.uint8)
    return picture


def without(picture: pygame.Surface, hidden: Points) -> pygame.Surface:
    """A picture without what quadrilaterals cover, in its own pixels, their edges anti-aliased."""
    width, height = picture.get_size()
    fine = pygame.Surface((width * _FINER, height * _FINER), 0, 32)
    fine.fill((255, 255, 255))
    for corners in np.floor(hidden.view(np.float64) * _FINER).astype(int).reshape(-1, 4, 2).tolist():
        pygame.draw.polygon(fine, (0, 0, 0), corners)
    left = picture.copy()
    share = pygame.surfarray.array3d(pygame.transform.smoothscale(fine, (width, height)))[:, :, 0]
    alpha = pygame.surfarray.pixels_alpha(left)
    alpha[:] = alpha * (share / 255.0)
    return left
