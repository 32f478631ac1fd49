"""Games to draw, and what to draw them on."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame

from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.palette import DARK, LIGHT, without_depth
from game.drawing.text import Type
from game.input.view import FLAT

PLAIN_DARK, PLAIN_LIGHT = without_depth(DARK), without_depth(LIGHT)
"""Where every surface has one colour, a pixel's colour tells what is there."""


def camera_of(view, scene, size):
    """The camera through which a view shows a scene. size: of the surface, pixels."""
    return view.seen(layout(size, scene.ground_radius)).camera


def canvas_of(scene, size, view=FLAT, theme=PLAIN_DARK, camera=None):
    """A new surface for a scene, black. camera: instead of the view's."""
    return Canvas(pygame.Surface(size, 0, 32), camera or camera_of(view, scene, size), theme, Type(), 10.0)
