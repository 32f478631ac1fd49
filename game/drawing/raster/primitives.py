"""Small anti-aliased shapes on a surface."""

import math

import pygame

from game.drawing.palette import Colour

HALF_PIXEL = 0.5 + 0.5j
"""Lines count pixels from their centres, polygons from their corners."""


def draw_dot(surface: pygame.Surface, pixel: complex, radius: float, colour: Colour) -> None:
    """A small anti-aliased disc around a pixel. radius: pixels."""
    pygame.draw.aacircle(surface, colour, _nearest(pixel), radius)


def draw_circle(surface: pygame.Surface, pixel: complex, radius: float, width: float, colour: Colour) -> None:
    """A small anti-aliased circle around a pixel. radius: of its outer edge; width: of its line, at least 1. In pixels."""
    pygame.draw.aacircle(surface, colour, _nearest(pixel), radius, max(round(width), 1))


def _nearest(pixel: complex) -> tuple[int, int]:
    """Column and row of the pixel whose centre is nearest: circles are around the centre of one."""
    return math.floor(pixel.real), math.floor(pixel.imag)


def draw_box(
    surface: pygame.Surface, box: pygame.Rect, radius: float, fill: Colour, edge: Colour | None = None, width: float = 0.0
) -> None:
    """A filled rectangle with round, anti-aliased corners. radius: of these; width: of the edge, at least 1. All in pixels."""
    if edge is None:
        _fill_box(surface, box, radius, fill)
        return
    line = max(1, round(width))
    _fill_box(surface, box, radius, edge)
    _fill_box(surface, box.inflate(-2 * line, -2 * line), radius - line, fill)


def _fill_box(surface: pygame.Surface, box: pygame.Rect, radius: float, colour: Colour) -> None:
    """Three rectangles, one over the other, and a disc in every corner."""
    corner = max(min(round(radius), (box.width - 1) // 2, (box.height - 1) // 2), 0)
    pygame.draw.rect(surface, colour, box.inflate(0, -2 * corner))
    if corner:
        for top in (box.top, box.bottom - corner):
            pygame.draw.rect(surface, colour, (box.left + corner, top, box.width - 2 * corner, corner))
        for x in (box.left + corner, box.right - 1 - corner):
            for y in (box.top + corner, box.bottom - 1 - corner):
                pygame.draw.aacircle(surface, colour, (x, y), corner)  # of the pixels x - corner to x + corner
