"""The arrows that show where balls that wait will go."""

import numpy as np
import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.arrays import Points
from game.drawing.raster.pixels import pairs
from game.drawing.raster.primitives import HALF_PIXEL, draw_dot
from game.scene import Aim, Scene

_REACH = 2.4
"""World units from the ball's middle to the arrow's tip."""
_DOTS = np.linspace(0.5, _REACH - 0.55, 6)
"""World units from the ball's middle to each dot of the line."""
_DOT_RADIUS, _LEAST_DOT_RADIUS = 0.055, 1.5
"""World units, and pixels."""
_HEAD_WIDTH = 0.2
"""World units; half the width of the arrow's head."""


def draw(canvas: Canvas, scene: Scene) -> None:
    """A line of dots that ends in an arrow's head for every ball that waits to be let go."""
    for aim in (*scene.held_aims, *([] if scene.aim is None else [scene.aim])):
        _draw_arrow(canvas, aim)


def _draw_arrow(canvas: Canvas, aim: Aim) -> None:
    """Where one ball will go."""
    surface, camera, colour = canvas.surface, canvas.camera, canvas.theme.accent
    origin, direction = aim
    for distance in _DOTS:
        point = origin + direction * float(distance)
        draw_dot(surface, camera.project(point), max(_LEAST_DOT_RADIUS, _DOT_RADIUS * camera.scale_at(point)), colour)
    head = camera.projected((origin + _head(_REACH, _HEAD_WIDTH) * direction) * camera.turning, 0.0)
    pygame.draw.polygon(surface, colour, pairs(head))
    pygame.draw.aalines(surface, colour, True, pairs(head - HALF_PIXEL))


def _head(tip: float, width: float) -> Points:
    """The corners of an arrow's head that points along angle 0, its tip at radius `tip`."""
    return np.array([tip, tip - 1.7 * width + 1j * width, tip - 1.25 * width, tip - 1.7 * width - 1j * width])
