"""The arena of the editor: the level as it will be played, the chosen ring and the slots under the pointer outlined."""

import math

import pygame

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import Colour
from game.drawing.raster.primitives import draw_circle
from game.editor.session import EditorSession
from game.editor.symmetry import images
from game.editor.wells import position_of
from game.effects import NOTHING
from game.levels import Level, RingSpec
from game.rules import Ruleset, new_game
from game.scene import scene_at, still

_ARC_DEGREES = 3.0
"""An arc is drawn as a line with a corner at least so often."""
_PLAIN_WIDTH, _SLOT_WIDTH, _CURSOR_WIDTH = 0.12, 0.16, 0.26
"""Of outlines, in units of text."""
_HANDLE = 0.6
"""Radius of a circle around a gravity well's middle, in units of text."""


def draw_arena(canvas: Canvas, painter: Painter, level: Level) -> None:
    """The level before its first serve. Raises ValueError for a level that the physics does not take."""
    scene = scene_at(still(new_game((level,), 0, Ruleset())), 1.0, NOTHING)._replace(aim=None)
    painter.paint(canvas, scene)


def draw_outlines(canvas: Canvas, session: EditorSession, at: tuple[int, int], colour: Colour) -> None:
    """Outline the slots that a stroke would paint. at: ring and slot of the stroke."""
    number, middle = at
    ring = session.document.level.rings[number]
    for slot in images(ring, middle, session.symmetry):
        _draw_slot(canvas, ring, slot, _CURSOR_WIDTH if slot == middle else _SLOT_WIDTH, colour)


def draw_ring(canvas: Canvas, ring: RingSpec, colour: Colour, width: float) -> None:
    """Draw a ring's edges. width: of the line, units of text."""
    for radius in (ring.radius - ring.half_width, ring.radius + ring.half_width):
        _draw_circle(canvas, radius, colour, width)


def draw_wells(canvas: Canvas, session: EditorSession, pointed: int | None, colour: Colour) -> None:
    """Draw the rims of all gravity wells, the chosen one's in `colour`. pointed: index of the well under the mouse."""
    for index, well in enumerate(session.document.level.wells):
        chosen, middle = index == session.well, position_of(well)
        shown, width = (colour, _SLOT_WIDTH) if chosen or index == pointed else (canvas.theme.faint, _PLAIN_WIDTH)
        for radius in (well.reach, canvas.unit * _HANDLE / canvas.camera.scale):
            _draw_circle(canvas, radius, shown, width, middle)


def _draw_circle(canvas: Canvas, radius: float, colour: Colour, width: float, middle: complex = 0j) -> None:
    """Draw a circle. radius, middle: world units; width: of the line, units of text."""
    line = max(canvas.unit * width, 1.0)
    pixels = canvas.camera.scale * radius + line / 2.0
    draw_circle(canvas.surface, canvas.camera.project(middle), max(pixels, 1.0), line, colour)


def _draw_slot(canvas: Canvas, ring: RingSpec, slot: int, width: float, colour: Colour) -> None:
    """The outline of a slot's brick, whether or not there is one. width: of the line, units of text."""
    middle = ring.phase + slot * 360.0 / ring.count
    steps = max(math.ceil(2.0 * ring.half_angle / _ARC_DEGREES), 1)
    angles = [middle - ring.half_angle + 2.0 * ring.half_angle * step / steps for step in range(steps + 1)]
    outer = [_pixel(canvas.camera, ring.radius + ring.half_width, angle) for angle in angles]
    inner = [_pixel(canvas.camera, ring.radius - ring.half_width, angle) for angle in reversed(angles)]
    line = max(round(canvas.unit * width), 1)
    pygame.draw.lines(canvas.surface, canvas.theme.background, True, [*outer, *inner], line + 2 * max(round(line / 2), 1))
    pygame.draw.lines(canvas.surface, colour, True, [*outer, *inner], line)


def _pixel(camera: Camera, radius: float, degrees: float) -> tuple[float, float]:
    """The pixel of a point in polar coordinates."""
    angle = math.radians(degrees)
    pixel = camera.project(complex(radius * math.cos(angle), radius * math.sin(angle)))
    return pixel.real, pixel.imag
