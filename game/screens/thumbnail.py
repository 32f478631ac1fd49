"""A small picture of a level."""

import pygame

from game.drawing.camera import Camera
from game.drawing.painter import Painter
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.effects import Effects
from game.levels import Level
from game.rules import new_game
from game.scene import scene_at, still

_FINER = 3


def thumbnail(level: Level, side: int, theme: Theme) -> pygame.Surface:
    """The level before its first serve, `side` pixels square, drawn finer and scaled down."""
    side = max(side, 1)
    large = pygame.Surface((side * _FINER, side * _FINER))
    scene = scene_at(still(new_game((level,), 0)), 1.0, Effects())._replace(aim=None)
    theme = theme._replace(background=theme.panel)
    camera = Camera(complex(side, side) * _FINER / 2.0, side * _FINER * 0.485 / level.ground_radius)
    Painter(theme).paint(large, scene, camera, Type(), 1.0)
    return pygame.transform.smoothscale(large, (side, side))
