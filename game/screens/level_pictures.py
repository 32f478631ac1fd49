"""Pictures of the levels, each drawn once per size and theme; no more than one a frame, so that no frame takes long."""

from collections import OrderedDict

import msgspec
import numpy as np
import pygame

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.effects import NOTHING
from game.levels import Level
from game.rules import PADDLES, Ruleset, new_game
from game.scene import scene_at, still

_FINER = 2
"""Rows and columns of the drawing per pixel of the picture."""
_RADIUS = 0.485
"""Of what is shown, in shares of the picture's side."""
_WHOLE_RADIUS = 0.45
"""Of the ground, where it is shown with the paddles: the rest is its glow."""
_AROUND, _LEAST = 1.3, 0.4
"""Shown is the wall with some ground around it, and of the paddles' track at least such a share; never more than the ground."""
_MOST = 160
"""Pictures cached."""


class LevelPictures:
    """Draws pictures of levels and caches them."""

    def __init__(self) -> None:
        """Start with none."""
        self._drawn: OrderedDict[tuple[object, ...], pygame.Surface] = OrderedDict()
        self._budget = 1
        self.waiting = False

    def next_frame(self) -> bool:
        """Allow one more picture to be drawn. Returns whether one was asked for in the last frame and had to wait."""
        waited, self.waiting, self._budget = self.waiting, False, 1
        return waited

    def picture(self, level: Level, side: int, theme: Theme, *, whole: bool = False) -> pygame.Surface | None:
        """A level's picture, `side` pixels square; None where it has to wait for the next frame. whole: the arena as a disc."""
        key = (msgspec.json.encode(level), side, theme, whole)  # faster than computing its hash
        if key in self._drawn:
            self._drawn.move_to_end(key)
            return self._drawn[key]
        if self._budget <= 0:
            self.waiting = True
            return None
        self._budget -= 1
        picture = thumbnail(level, side, theme, whole=whole)
        self._drawn[key] = _round(picture) if whole else picture
        if len(self._drawn) > _MOST:
            self._drawn.popitem(last=False)
        return self._drawn[key]


def thumbnail(level: Level, side: int, theme: Theme, *, whole: bool = False) -> pygame.Surface:
    """The level before its first serve on the panel's colour, `side` pixels square: its wall, or with the paddles as well."""
    side = max(side, 1)
    large = pygame.Surface((side * _FINER, side * _FINER))
    scene = scene_at(still(new_game((level,), 0, Ruleset())), 1.0, NOTHING)._replace(aim=None)
    bricks = [ring for index, ring in enumerate(scene.rings) if index not in (PADDLES, scene.shield)]
    wall = max([ring.outer_radius for ring in bricks], default=0.0)
    reach = min(max(wall * _AROUND, scene.rings[PADDLES].inner_radius * _LEAST), level.ground_radius)
    reach, radius = (level.ground_radius, _WHOLE_RADIUS) if whole else (reach, _RADIUS)
    camera = Camera(complex(side, side) * _FINER / 2.0, side * _FINER * radius / reach)
    Painter().paint(Canvas(large, camera, theme._replace(background=theme.panel), Type(), 1.0), scene)
    return pygame.transform.smoothscale(large, (side, side))


def _round(picture: pygame.Surface) -> pygame.Surface:
    """A square picture as the disc in it, whose edge fades away."""
    side = picture.get_width()
    across = (np.arange(side) + 0.5) / side - 0.5
    away = np.hypot(across[:, None], across[None, :])
    disc = pygame.Surface((side, side), pygame.SRCALPHA)
    disc.blit(picture, (0, 0))
    pygame.surfarray.pixels_alpha(disc)[:] = np.clip((0.5 - away) / (0.5 - _WHOLE_RADIUS), 0.0, 1.0) * 255.0
    return disc
