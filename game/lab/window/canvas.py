"""What a pane of the world is drawn on and with, and the strokes of a mark in it."""

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.drawing.camera import Camera
from game.drawing.palette import Colour, Theme
from game.drawing.text import Type
from game.lab.kit.picture import Stroke, Toggle
from game.lab.kit.scene import ViewBox
from game.lab.window.strokes import draw_dashed, draw_path, is_near, rounded

_PIXELS_PER_CHORD = 3.0
_MOST_CHORDS = 720
_WIDTHS = {Stroke.SOLID: 0.1, Stroke.THICK: 0.2, Stroke.DASHED: 0.1}
"""Of lines, in units."""
_DASH = 0.5
"""Length of a dash, in units."""
_LETTERS = 0.95
"""Size of words in the world, in units."""
_LARGE = 8e3
"""Pixels: of a circle with a larger radius only the part in sight is drawn, as an arc."""


class PaneCanvas(NamedTuple):
    """Where and how one pane is drawn.

    area: the pane's part of the surface. unit: size of body text, pixels. shown: the toggles that are on.
    """

    surface: pygame.Surface
    area: pygame.Rect
    camera: Camera
    theme: Theme
    type: Type
    unit: float
    shown: frozenset[Toggle]


def camera_for(box: ViewBox, area: pygame.Rect) -> Camera:
    """The camera that shows a part of the world in the middle of an area, as large as fits."""
    scale = max(min(area.width / (2.0 * box.half.real), area.height / (2.0 * box.half.imag)), 1e-3)
    return Camera(complex(*area.center) - box.centre.conjugate() * scale, scale)


def draw_stroke(canvas: PaneCanvas, pixels: Sequence[complex], colour: Colour, stroke: Stroke) -> None:
    """A line through pixels."""
    width = canvas.unit * _WIDTHS[stroke]
    if stroke is Stroke.DASHED:
        draw_dashed(canvas.surface, pixels, colour, width, canvas.unit * _DASH)
    else:
        draw_path(canvas.surface, pixels, colour, width)


def draw_circle(canvas: PaneCanvas, centre: complex, radius: float, colour: Colour, stroke: Stroke) -> None:
    """The line of a circle. centre, radius: world units."""
    pixels, middle = radius * canvas.camera.scale, canvas.camera.project(centre)
    if stroke is Stroke.DASHED or not (is_near(middle) and pixels < _LARGE):
        draw_stroke(canvas, arc_pixels(canvas.camera, centre, radius, 0.0, math.tau), colour, stroke)
        return
    width = max(round(canvas.unit * _WIDTHS[stroke]), 1)
    pygame.draw.aacircle(canvas.surface, colour, (middle.real - 0.5, middle.imag - 0.5), pixels + width / 2.0, width)


def arc_pixels(camera: Camera, centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    """Pixels along an arc, close enough to look round. centre, radius: world units; start, sweep: radians."""
    chords = min(max(math.ceil(abs(sweep) * radius * camera.scale / _PIXELS_PER_CHORD), 8), _MOST_CHORDS)
    return [camera.project(centre + cmath.rect(radius, start + sweep * k / chords)) for k in range(chords + 1)]


def write_words(
    canvas: PaneCanvas, pixel: complex, text: str, colour: Colour, anchor: str = "center", taken: Sequence[pygame.Rect] = ()
) -> pygame.Rect | None:
    """Words with a seam in the ground's colour, moved into the pane where they stand out of it; none far outside of it.

    anchor: the point of the words' box that is at the pixel, as in pygame.Rect. taken: boxes of other words, which are not
    covered if there is room beside them. Returns the words' own box.
    """
    size = canvas.unit * _LETTERS
    if not canvas.area.inflate(4 * canvas.unit, 4 * canvas.unit).collidepoint(pixel.real, pixel.imag):
        return None
    line = canvas.type.rendered(text, size, colour)
    box = _free_box(line.get_rect(**{anchor: rounded(pixel)}), canvas.area.inflate(-4, -4), taken)
    seam = canvas.type.rendered(text, size, canvas.theme.ground)
    width = max(1, round(canvas.unit * 0.09))
    for dx, dy in ((-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, 1), (-1, 1), (1, -1)):
        canvas.surface.blit(seam, box.move(dx * width, dy * width))
    canvas.surface.blit(line, box)
    return box


def _free_box(box: pygame.Rect, area: pygame.Rect, taken: Sequence[pygame.Rect]) -> pygame.Rect:
    """The box inside the area, moved up, down or aside to where it covers no other, if there is such a position near."""
    high, wide = box.height, box.width
    moves = [(dx * wide, dy * high) for dx, dy in ((0, 0), (0, -1), (0, 1), (1, 0), (-1, 0), (0, -2), (0, 2), (2, 0), (-2, 0))]
    boxes = [box.move(move).clamp(area) for move in moves]
    return next((one for one in boxes if one.collidelist(list(taken)) == -1), boxes[0])
