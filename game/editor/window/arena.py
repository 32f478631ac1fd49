"""The arena of the editor: the level as it will be played, the chosen ring and the slots under the pointer outlined."""

import math

import pygame

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import Colour
from game.editor.session import EditorSession
from game.editor.symmetry import images
from game.effects import NOTHING
from game.levels import Level, RingSpec
from game.rules import new_game
from game.scene import scene_at, still

_ARC_DEGREES = 3.0
"""An arc is drawn as a line with a corner at least so often."""
_CHOSEN_WIDTH, _SLOT_WIDTH, _CURSOR_WIDTH = 0.12, 0.2, 0.4
"""Of outlines, in units of text."""


def slot_at(level: Level, point: complex) -> tuple[int, int] | None:
    """Ring and slot whose part of the turn a point of the world is in; None where there is no ring."""
    distance, angle = abs(point), math.degrees(math.atan2(point.imag, point.real))
    for index, ring in enumerate(level.rings):
        if abs(distance - ring.radius) <= ring.half_width:
            return index, round((angle - ring.phase) * ring.count / 360.0) % ring.count
    return None


def draw_arena(canvas: Canvas, painter: Painter, level: Level) -> None:
    """The level before its first serve. Raises ValueError for a level that the physics does not take."""
    scene = scene_at(still(new_game((level,), 0)), 1.0, NOTHING)._replace(aim=None)
    painter.paint(canvas, scene)


def draw_outlines(canvas: Canvas, session: EditorSession, at: tuple[int, int] | None, colour: Colour) -> None:
    """The chosen ring's edges, and in a colour the slots that a stroke would paint. at: ring and slot of it; None for none."""
    rings = session.document.level.rings
    chosen = rings[session.ring]
    for radius in (chosen.radius - chosen.half_width, chosen.radius + chosen.half_width):
        _draw_circle(canvas, radius, canvas.theme.faint, _CHOSEN_WIDTH)
    if at is not None:
        ring, middle = at
        for slot in images(rings[ring], middle, session.symmetry):
            _draw_slot(canvas, rings[ring], slot, _CURSOR_WIDTH if slot == middle else _SLOT_WIDTH, colour)


def _draw_circle(canvas: Canvas, radius: float, colour: Colour, width: float) -> None:
    """A circle about the centre. radius: world units."""
    pixels = [_pixel(canvas.camera, radius, angle * _ARC_DEGREES) for angle in range(round(360.0 / _ARC_DEGREES))]
    pygame.draw.aalines(canvas.surface, colour, closed=True, points=pixels)
    if canvas.unit * width >= 2.0:
        pygame.draw.lines(canvas.surface, colour, True, pixels, round(canvas.unit * width))


def _draw_slot(canvas: Canvas, ring: RingSpec, slot: int, width: float, colour: Colour) -> None:
    """The outline of a slot's brick, whether or not there is one. width: of the line, units of text."""
    middle = ring.phase + slot * 360.0 / ring.count
    steps = max(math.ceil(2.0 * ring.half_angle / _ARC_DEGREES), 1)
    angles = [middle - ring.half_angle + 2.0 * ring.half_angle * step / steps for step in range(steps + 1)]
    outer = [_pixel(canvas.camera, ring.radius + ring.half_width, angle) for angle in angles]
    inner = [_pixel(canvas.camera, ring.radius - ring.half_width, angle) for angle in reversed(angles)]
    line = max(round(canvas.unit * width), 1)
    pygame.draw.lines(canvas.surface, colour, True, [*outer, *inner], line)


def _pixel(camera: Camera, radius: float, degrees: float) -> tuple[float, float]:
    """The pixel of a point in polar coordinates."""
    angle = math.radians(degrees)
    pixel = camera.project(complex(radius * math.cos(angle), radius * math.sin(angle)))
    return pixel.real, pixel.imag
