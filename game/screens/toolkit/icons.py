"""Small signs that need no words: pause, help, settings, back."""

import math

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour
from game.drawing.raster.primitives import draw_dot

_THIN = 0.13
"""Width of a stroke, in sides of the box."""


def draw_cross(canvas: Canvas, box: pygame.Rect, colour: Colour) -> None:
    """A cross: it closes what it stands on."""
    reach, middle = box.width * 0.22, complex(*box.center)
    _stroke(canvas, middle - reach * (1 + 1j), middle + reach * (1 + 1j), box.width, colour)
    _stroke(canvas, middle + reach * (-1 + 1j), middle + reach * (1 - 1j), box.width, colour)


def draw_bars(canvas: Canvas, box: pygame.Rect, colour: Colour) -> None:
    """Two bars: pause."""
    for side in (-1.0, 1.0):
        bar = pygame.Rect(0, 0, max(round(box.width * 0.14), 2), round(box.height * 0.46))
        bar.center = (round(box.centerx + side * box.width * 0.14), box.centery)
        pygame.draw.rect(canvas.surface, colour, bar, border_radius=max(round(box.width * 0.04), 1))


def draw_question(canvas: Canvas, box: pygame.Rect, colour: Colour) -> None:
    """A question mark: help."""
    canvas.write("?", box.height / canvas.unit * 0.95, colour, complex(box.centerx, box.centery + box.height * 0.04), "center")


def draw_gear(canvas: Canvas, box: pygame.Rect, colour: Colour) -> None:
    """A toothed wheel: settings."""
    middle, radius = complex(*box.center), box.width * 0.2
    points = []
    for tooth in range(8):
        for turn, reach in ((-0.32, 1.0), (-0.2, 1.45), (0.2, 1.45), (0.32, 1.0)):
            angle = math.tau * (tooth + turn) / 8.0
            pixel = middle + radius * reach * complex(math.cos(angle), math.sin(angle))
            points.append((pixel.real, pixel.imag))
    pygame.draw.polygon(canvas.surface, colour, points)
    draw_dot(canvas.surface, middle, radius * 0.5, canvas.theme.panel)


def draw_lock(canvas: Canvas, box: pygame.Rect, colour: Colour) -> None:
    """A padlock: not open yet."""
    body = pygame.Rect(0, 0, round(box.width * 0.5), round(box.height * 0.38))
    body.midtop = (box.centerx, round(box.centery - box.height * 0.02))
    bow = pygame.Rect(0, 0, round(box.width * 0.32), round(box.height * 0.42))
    bow.midbottom = (box.centerx, body.top + round(box.height * 0.16))
    width = max(round(box.width * 0.07), 1)
    pygame.draw.arc(canvas.surface, colour, bow, 0.0, math.pi, width)
    for side in (bow.left, bow.right - width):
        pygame.draw.rect(canvas.surface, colour, (side, bow.centery - 1, width, body.top - bow.centery + 2))
    pygame.draw.rect(canvas.surface, colour, body, border_radius=max(width, 1))


def _stroke(canvas: Canvas, start: complex, end: complex, side: int, colour: Colour) -> None:
    """A straight stroke with round ends."""
    width = side * _THIN / 2.0
    across = (end - start) / abs(end - start) * 1j * width
    corners = (start + across, end + across, end - across, start - across)
    pygame.draw.polygon(canvas.surface, colour, [(corner.real, corner.imag) for corner in corners])
    pygame.draw.aaline(canvas.surface, colour, (corners[0].real, corners[0].imag), (corners[1].real, corners[1].imag))
    pygame.draw.aaline(canvas.surface, colour, (corners[2].real, corners[2].imag), (corners[3].real, corners[3].imag))
