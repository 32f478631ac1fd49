"""Games to draw, and what to draw them on."""

import itertools
import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame

from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import DARK, LIGHT, without_depth
from game.drawing.text import Type
from game.input.view import FLAT, Viewpoint
from game.picture.slots.parts import SlotShape
from game.picture.solid.prisms import slot_division
from game.picture.solid.rings import SolidRing

PLAIN_DARK, PLAIN_LIGHT = without_depth(DARK), without_depth(LIGHT)
"""Where every surface has one colour, a pixel's colour tells what is there."""
TIPPED = [
    Viewpoint(1.0, 1.0, azimuth, math.radians(tilt))
    for azimuth, tilt in itertools.product((0.0, 0.9, 2.2, -2.7, -1.1), (15.0, 45.0, 62.0, 76.0))
]
"""From five sides, from nearly upright to nearly level."""


def camera_of(view, scene, size):
    """The camera through which a view shows a scene. size: of the surface, pixels."""
    return view.seen(layout(size, scene.ground_radius)).camera


def canvas_of(scene, size, view=FLAT, theme=PLAIN_DARK, camera=None):
    """A new surface for a scene, black. camera: instead of the view's."""
    return Canvas(pygame.Surface(size, 0, 32), camera or camera_of(view, scene, size), theme, Type(), 10.0)


def painted(scene, camera, size):
    """A scene on a new surface."""
    canvas = canvas_of(scene, size, camera=camera)
    Painter().paint(canvas, scene)
    return canvas.surface


def solid_ring(half_angle, slots, content, widest=0.2):
    """A ring of the solid view at radius 3. widest: half angle of its widest wedge."""
    shape = SlotShape(3.0, 0.4, half_angle, 4, 0.0)
    division = slot_division(shape, widest, 40.0, 0.0)
    return SolidRing((content,) * slots, shape, division, (), 0.45, DARK)
