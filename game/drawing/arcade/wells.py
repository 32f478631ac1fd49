"""Gravity wells: rings that shrink into what pulls, and grow out of what pushes."""

import math

import numpy as np
import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import mixed
from game.drawing.raster.pixels import pairs
from game.drawing.raster.primitives import HALF_PIXEL, draw_dot
from game.scene import Scene, Well

_RINGS = 4
_RATE = 0.28
"""Rings per second that reach the middle."""
_ARMS, _SWEEP = 3, 2.0
"""Arcs of each ring, and how far they are turned from the edge to the middle, radians."""
_GAP = 0.35
"""Share of a ring that is left out between its arcs."""
_STRENGTH, _EDGE_STRENGTH = 0.75, 0.3
"""Share of the way from the ground's colour to the rings', in the middle and at the edge of the well's reach."""
_EYE = 0.07
"""Radius of the dot in the middle, in shares of the reach."""
_WIDTH = 0.022
"""Width of a line, in shares of the reach; at least a pixel."""
_STEPS = 20


def draw(canvas: Canvas, scene: Scene) -> None:
    """All wells of a level."""
    for well in scene.wells:
        _draw_well(canvas, scene, well)


def _draw_well(canvas: Canvas, scene: Scene, well: Well) -> None:
    """One well: a circle where its reach ends, arcs on their way, a dot in its middle."""
    theme, camera = canvas.theme, canvas.camera
    colour = theme.trail if well.strength > 0.0 else theme.danger
    moved = scene.clock * _RATE % 1.0
    for number in range(_RINGS):
        share = (number + (1.0 - moved if well.strength > 0.0 else moved)) / _RINGS
        shade = mixed(theme.ground, colour, _STRENGTH + (_EDGE_STRENGTH - _STRENGTH) * share)
        for arm in range(_ARMS):
            start = math.tau * arm / _ARMS + _SWEEP * (1.0 - share)
            angles = np.linspace(start, start + math.tau / _ARMS * (1.0 - _GAP), _STEPS)
            around = np.exp(1j * angles)
            width = max(_WIDTH * well.reach, 1.0 / camera.scale) / 2.0
            radius = max(share * well.reach, width)
            rim = np.concatenate([around * (radius + width), around[::-1] * max(radius - width, 0.0)])
            outline = camera.projected((well.position + rim) * camera.turning, 0.0)
            pygame.draw.polygon(canvas.surface, shade, pairs(outline))
            pygame.draw.aalines(canvas.surface, shade, True, pairs(outline - HALF_PIXEL))
    middle = camera.project(well.position)
    draw_dot(canvas.surface, middle, max(_EYE * well.reach * camera.scale_at(well.position), 2.0), colour)
