"""Shapes and labels onto a surface."""

import itertools
import math
from collections.abc import Sequence

import pygame

from game.drawing.text import Type
from game.lab.drawing.canvas import PaneCanvas
from game.lab.drawing.labels import placed_labels
from game.lab.drawing.marks import shapes_of
from game.lab.drawing.seen import is_near
from game.lab.drawing.shapes import ColourGrid, FilledPolygon, PixelShape, PlacedLabel, Polyline, Round
from game.lab.drawing.strokes import draw_dashed, draw_disc, draw_path, draw_polygon, rounded
from game.lab.kit.picture import Mark

_SEAM = 0.075
"""Width of the seam around words, in the size of their letters."""
_PLATE_EDGE, PLATE_OPACITY = 0.12, 190
"""Beside words on a plate, in the size of their letters; opacity, of 255."""
_AROUND = ((-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, 1), (-1, 1), (1, -1))
_SMOOTH = 8e3
"""Pixels: a circle of a larger radius is painted without anti-aliasing."""


def draw_marks(canvas: PaneCanvas, marks: Sequence[Mark], title: str = "", handles: Sequence[complex] = ()) -> None:
    """Every mark whose toggle is on: first all marks from back to front, then the labels, so that no mark covers them.

    title, handles: as of `placed_labels`.
    """
    before = canvas.surface.get_clip()
    canvas.surface.set_clip(canvas.area)
    paint_shapes(canvas.surface, shapes_of(canvas, marks))
    paint_labels(canvas.surface, canvas.type, placed_labels(canvas, marks, title, handles))
    canvas.surface.set_clip(before)


def paint_shapes(surface: pygame.Surface, shapes: Sequence[PixelShape]) -> None:
    """Shapes, from back to front."""
    for shape in shapes:
        match shape:
            case Polyline(pixels, colour, width, dash) if dash:
                draw_dashed(surface, pixels, colour, width, dash)
            case Polyline(pixels, colour, width):
                draw_path(surface, pixels, colour, width)
            case FilledPolygon(pixels, colour):
                draw_polygon(surface, colour, [(pixel.real, pixel.imag) for pixel in pixels])
                if len(pixels) == 3:  # of an arrow's head, whose edges no other line covers
                    corners = [(pixel.real - 0.5, pixel.imag - 0.5) for pixel in pixels]
                    pygame.draw.aalines(surface, colour, True, corners)
            case Round():
                _paint_round(surface, shape)
            case ColourGrid(corner, size):
                surface.blit(pygame.transform.smoothscale(cells_picture(shape), size), rounded(corner))


def cells_picture(shape: ColourGrid) -> pygame.Surface:
    """The cells of a field, a pixel each."""
    rows = len(shape.colours) // shape.columns
    return pygame.image.frombytes(bytes(itertools.chain.from_iterable(shape.colours)), (shape.columns, rows), "RGB")


def paint_labels(surface: pygame.Surface, type_: Type, labels: Sequence[PlacedLabel]) -> None:
    """Words with a seam around them."""
    for label in labels:
        if label.plate:
            _paint_plate(surface, label)
        seam = type_.rendered(label.text, label.size, label.seam)
        width = max(1, round(label.size * _SEAM))
        for reach in range(1, width + 1, 2):
            for dx, dy in _AROUND:
                surface.blit(seam, label.box.move(dx * reach, dy * reach))
        surface.blit(type_.rendered(label.text, label.size, label.colour), label.box)


def _paint_plate(surface: pygame.Surface, label: PlacedLabel) -> None:
    """A translucent plate behind words."""
    edge = round(label.size * _PLATE_EDGE)
    box = label.box.inflate(2 * edge, 0)
    plate = pygame.Surface(box.size, pygame.SRCALPHA)
    pygame.draw.rect(plate, (*label.seam, PLATE_OPACITY), plate.get_rect(), 0, edge * 2)
    surface.blit(plate, box)


def _paint_round(surface: pygame.Surface, shape: Round) -> None:
    """A circle or a disc."""
    centre, radius = shape.centre, shape.radius
    if not is_near(centre):
        return
    if shape.opacity < 1.0:
        _paint_translucent(surface, shape)
    elif shape.width == 0.0 and radius < _SMOOTH:
        draw_disc(surface, centre, radius, shape.colour)
    elif radius < _SMOOTH:
        width = max(round(shape.width), 1)
        pygame.draw.aacircle(surface, shape.colour, (centre.real - 0.5, centre.imag - 0.5), radius + width / 2.0, width)
    else:
        pygame.draw.circle(surface, shape.colour, (centre.real, centre.imag), radius + shape.width / 2.0, round(shape.width))


def _paint_translucent(surface: pygame.Surface, shape: Round) -> None:
    """A disc that can be seen through, as far as it is in sight."""
    box = pygame.Rect(0, 0, 2 * math.ceil(shape.radius) + 2, 2 * math.ceil(shape.radius) + 2)
    box.center = rounded(shape.centre)
    seen = box.clip(surface.get_clip())
    if seen.width > 0 and seen.height > 0:
        layer = pygame.Surface(seen.size, pygame.SRCALPHA)
        inside = shape.centre - complex(*seen.topleft)
        pygame.draw.circle(layer, (*shape.colour, round(255 * shape.opacity)), (inside.real, inside.imag), shape.radius)
        surface.blit(layer, seen)
