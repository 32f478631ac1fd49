"""A ball's picture, its shadow, and what is left of it behind something."""

import math

import numpy as np
import pygame

from game.camera import Points
from game.palette import Theme, mixed

_FINER = 4


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
