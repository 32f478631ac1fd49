"""One brick on its own, as in the arena but on a plain card: a sample for the help."""

import math

import numpy as np
import pygame

from game.drawing.flat.sector_colours import PolarPixels, paint_slot
from game.drawing.palette import Theme
from game.drawing.raster.pixels import packed, pixels_of
from game.picture.display_list import DisplayList
from game.picture.slots.contents import wall_contents
from game.picture.slots.flat import FlatRing, add_content
from game.picture.slots.parts import SlotShape

_RADIUS, _HALF_WIDTH, _HALF_ANGLE, _TALLEST = 4.0, 0.45, 0.2, 6
"""Of the ring that the brick might stand in: lengths in world units, the angle in radians, and layers."""


def brick_sample(size: tuple[int, int], scale: float, layers: int, theme: Theme) -> pygame.Surface:
    """A stack of bricks, or what never breaks, in the middle of a card of the panel's colour.

    size: of the card, pixels; scale: pixels per world unit; layers: as in `physics.Arena`.
    """
    width, height = size
    theme = theme._replace(ground=theme.panel)
    ring = FlatRing(SlotShape(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, _TALLEST, 1.0 / scale), 1, scale, 0.0, (0.0, math.inf), theme)
    across = np.arange(width, dtype=np.float32)[None, :] + np.float32(0.5 - width / 2.0)
    up = np.float32(height / 2.0 - 0.5 + _RADIUS * scale) - np.arange(height, dtype=np.float32)[:, None]
    radius, angle = np.hypot(across, up).ravel(), (np.arctan2(up, across) - np.float32(math.pi / 2.0)).ravel()
    picture = np.repeat(np.array(theme.ground, dtype=np.float32)[:, None], width * height, axis=1)
    brick = DisplayList()
    (content,) = wall_contents((layers,), [])
    add_content(brick, ring, content, ring.sector(0j, 0.0))
    paint_slot(picture, brick, PolarPixels(radius, angle))
    card = pygame.Surface(size, 0, 32)
    memory = pixels_of(card).reshape(height, -1)
    memory[:, :width] = packed(card, picture.T).reshape(height, width)
    return card
