"""A ball's picture, its shadow, and what is left of it behind something."""

import math

import numpy as np
import pygame

from game.camera import Camera, Points
from game.palette import Theme, mixed
from game.solids import LIGHT
from physics import Ball

_FINER = 4
_SHADOW = ((1.0, 0.3), (0.8, 0.35))
"""Discs that make a shadow: radius, in balls', and strength."""
_SLANT = 0.7
"""Length of a shadow over what casts it, once the camera is tipped enough to show it."""


def ball_picture(radius: float, across: float, down: float, theme: Theme) -> pygame.Surface:
    """A shaded ball on a transparent square with an odd side, its centre (across, down) into the middle pixel."""
    reach = math.ceil(radius) + 2
    side = 2 * reach + 1
    pixels = np.arange(side) + 0.5 - reach
    away = np.hypot(pixels[:, None] - across, pixels[None, :] - down)
    lit = np.hypot(pixels[:, None] - across + 0.3 * radius, pixels[None, :] - down + 0.35 * radius)
    cover = np.clip(radius + 0.5 - away, 0.0, 1.0)
    shade = np.clip(lit / (1.6 * max(radius, 0.5)), 0.0, 1.0)[:, :, None] ** 1.5
    dark = np.array(mixed(theme.ball, theme.rim, 0.75), dtype=np.float64)
    light = np.array(theme.ball, dtype=np.float64)
    picture = pygame.Surface((side, side), pygame.SRCALPHA)
    rgb = (light * (1.0 - shade) + dark * shade).astype(np.uint8)
    pygame.surfarray.pixels3d(picture)[:] = rgb
    pygame.surfarray.pixels_alpha(picture)[:] = (cover * 255.0).astype(np.uint8)
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


def draw_shadow(surface: pygame.Surface, ball: Ball, camera: Camera, theme: Theme) -> None:
    """A ball's shadow on the ground: right below it from straight above, beside it where that can be seen."""
    middle = ball.position - LIGHT * _SLANT * ball.radius * math.sin(camera.tilt)
    around = np.exp(1j * np.linspace(0.0, math.tau, 24, endpoint=False)) * ball.radius
    for size, strength in _SHADOW:
        outline = camera.projected((middle + around * size) * camera.turning, 0.0)
        low = complex(math.floor(outline.real.min()) - 1, math.floor(outline.imag.min()) - 1)
        width = math.ceil(outline.real.max() - low.real) + 2
        height = math.ceil(outline.imag.max() - low.imag) + 2
        disc = pygame.Surface((width * _FINER, height * _FINER), pygame.SRCALPHA)
        shade = mixed(theme.ground, (0, 0, 0), 0.9)
        disc.fill((*shade, 0))
        corners = ((outline - low) * _FINER).view(np.float64).reshape(-1, 2).tolist()
        pygame.draw.polygon(disc, (*shade, round(255 * strength)), corners)
        surface.blit(pygame.transform.smoothscale(disc, (width, height)), (int(low.real), int(low.imag)))
