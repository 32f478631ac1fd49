"""Small anti-aliased shapes on a surface."""

import numpy as np
import pygame

from game.drawing.camera import Camera, Points
from game.drawing.palette import Colour, Theme

_HALF_PIXEL = 0.5 + 0.5j
"""Lines count pixels from their centres, polygons from their corners."""


def draw_arrow(surface: pygame.Surface, camera: Camera, origin: complex, way: complex, theme: Theme, reach: float) -> None:
    """Where the serve will go: a line of dots that ends in an arrow's head. origin, reach: world units; way: unit."""
    for dot in np.linspace(0.5, reach - 0.55, 6):
        point = origin + way * float(dot)
        draw_dot(surface, camera.project(point), max(1.5, 0.055 * camera.scale_at(point)), theme.accent)
    head = camera.projected((origin + _arrow(reach, 0.2) * way) * camera.turning, 0.0)
    pygame.draw.polygon(surface, theme.accent, _pairs(head))
    pygame.draw.aalines(surface, theme.accent, True, _pairs(head - _HALF_PIXEL))


def draw_dot(surface: pygame.Surface, place: complex, radius: float, colour: Colour) -> None:
    """A small anti-aliased disc around a pixel."""
    pygame.draw.aacircle(surface, colour, (place.real - 0.5, place.imag - 0.5), radius)


def draw_box(
    surface: pygame.Surface, box: pygame.Rect, radius: float, fill: Colour, edge: Colour | None = None, width: float = 0.0
) -> None:
    """A filled rectangle with round, anti-aliased corners. width: pixels, of its edge, at least one."""
    if edge is None:
        _fill_box(surface, box, radius, fill)
        return
    line = max(1, round(width))
    _fill_box(surface, box, radius, edge)
    _fill_box(surface, box.inflate(-2 * line, -2 * line), radius - line, fill)


def _fill_box(surface: pygame.Surface, box: pygame.Rect, radius: float, colour: Colour) -> None:
    """Two crossed rectangles and a disc in every corner."""
    corner = max(min(round(radius), (box.width - 1) // 2, (box.height - 1) // 2), 0)
    pygame.draw.rect(surface, colour, box.inflate(-2 * corner, 0))
    pygame.draw.rect(surface, colour, box.inflate(0, -2 * corner))
    if corner:
        for x in (box.left + corner, box.right - 1 - corner):
            for y in (box.top + corner, box.bottom - 1 - corner):
                pygame.draw.aacircle(surface, colour, (x, y), corner)  # of the pixels x - corner to x + corner


def _arrow(length: float, width: float) -> Points:
    """An arrow's head along angle 0, its tip at `length`."""
    return np.array([length, length - 1.7 * width + 1j * width, length - 1.25 * width, length - 1.7 * width - 1j * width])


def _pairs(points: Points) -> list[list[float]]:
    """Points as pygame takes them."""
    return points.view(np.float64).reshape(-1, 2).tolist()
