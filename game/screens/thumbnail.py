"""A small picture of a level."""

import pygame

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.effects import NOTHING
from game.levels import Level
from game.rules import new_game
from game.scene import scene_at, still

_FINER = 3
"""Rows and columns of the drawing per pixel of the picture."""
_RADIUS = 0.485
"""Of the ground, in shares of the picture's side."""


def thumbnail(level: Level, side: int, theme: Theme) -> pygame.Surface:
    """The level before its first serve on the panel's colour, `side` pixels square."""
    side = max(side, 1)
    large = pygame.Surface((side * _FINER, side * _FINER))
    scene = scene_at(still(new_game((level,), 0)), 1.0, NOTHING)._replace(aim=None)
    camera = Camera(complex(side, side) * _FINER / 2.0, side * _FINER * _RADIUS / level.ground_radius)
    Painter().paint(Canvas(large, camera, theme._replace(background=theme.panel), Type(), 1.0), scene)
    return pygame.transform.smoothscale(large, (side, side))
