"""Small signs that need no words: pause, help, settings, back."""

import math
from functools import lru_cache

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour
from game.drawing.raster.primitives import draw_dot

_THIN = 0.13
"""Width of a stroke, in sides of the box."""
_REACH, _FINER = 0.2, 4
"""Of a cross: half its width, in sides of the box; and how much larger a sign is drawn."""


def draw_cross(canvas: Canvas, box: pygame.Rect, colour: Colour) -> None:
    """A cross: it closes what it stands on."""
    picture = _cross(max(box.width, 1), colour)
    canvas.surface.blit(picture, picture.get_rect(center=box.center))


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
    picture = _lock(max(box.width, 1), colour)
    canvas.surface.blit(picture, picture.get_rect(center=box.center))


@lru_cache(maxsize=32)
def _lock(side: int, colour: Colour) -> pygame.Surface:
    """A padlock, drawn finer and scaled down."""
    large = _clear(side, colour)
    fine, width = side * _FINER, side * _FINER * 0.08
    middle, bow, top = fine / 2.0, fine * 0.15, fine * 0.4
    body = pygame.Rect(round(middle - fine * 0.24), round(fine * 0.48), round(fine * 0.48), round(fine * 0.36))
    pygame.draw.rect(large, colour, body, border_radius=round(width))
    pygame.draw.circle(large, colour, (middle, top), bow + width / 2.0, round(width), True, True, False, False)
    for x in (middle - bow - width / 2.0, middle + bow - width / 2.0):
        pygame.draw.rect(large, colour, (round(x), round(top) - 1, round(width), body.top - round(top) + 2))
    return pygame.transform.smoothscale(large, (side, side))


def _clear(side: int, colour: Colour) -> pygame.Surface:
    """A surface to draw a sign on that is scaled down to `side` pixels: nothing of a colour."""
    large = pygame.Surface((side * _FINER, side * _FINER), pygame.SRCALPHA)
    large.fill((*colour[:3], 0))
    return large


@lru_cache(maxsize=32)
def _cross(side: int, colour: Colour) -> pygame.Surface:
    """A cross of two strokes with round ends, drawn finer and scaled down."""
    fine, large = side * _FINER, _clear(side, colour)
    middle, width = complex(fine, fine) / 2.0, fine * _THIN / 2.0
    for towards in (1 + 1j, 1 - 1j):
        across, reach = towards / abs(towards) * 1j * width, towards * fine * _REACH
        corners = (middle - reach + across, middle + reach + across, middle + reach - across, middle - reach - across)
        pygame.draw.polygon(large, colour, [(corner.real, corner.imag) for corner in corners])
        for end in (middle - reach, middle + reach):
            pygame.draw.circle(large, colour, (end.real, end.imag), width)
    return pygame.transform.smoothscale(large, (side, side))
