"""Anti-aliased lines and circles at any size, far zooms included. Everything here is in pixels; y grows downwards."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.palette import Colour
from game.lab.drawing.seen import FAR, is_near

_CURVE = 9
"""A line through so many points is drawn as a curve."""
_BESIDE, _WIDE = 0.5, 2.5
"""Pixels: from one thin line of a wide one to the next, so that no gap shows; half of the width of one with a polygon."""


def rounded(pixel: complex) -> tuple[int, int]:
    """A pixel as whole numbers."""
    return round(pixel.real), round(pixel.imag)


def draw_disc(surface: pygame.Surface, centre: complex, radius: float, colour: Colour) -> None:
    """A filled disc."""
    if is_near(centre) and radius < FAR:
        pygame.draw.aacircle(surface, colour, (centre.real - 0.5, centre.imag - 0.5), max(radius, 0.5))


def draw_polygon(surface: pygame.Surface, colour: Colour, corners: Sequence[Sequence[float]]) -> None:
    """A filled polygon. Far above and below what is seen it is cut off first: pygame goes through every row of a polygon."""
    seen = surface.get_clip().inflate(0, 2)
    rows = [corner[1] for corner in corners]
    if min(rows) < seen.top:
        corners = _cut(corners, seen.top, 1)
    if max(rows) > seen.bottom:
        corners = _cut(corners, seen.bottom, -1)
    if len(corners) > 2:
        pygame.draw.polygon(surface, colour, corners)


def draw_path(surface: pygame.Surface, pixels: Sequence[complex], colour: Colour, width: float) -> None:
    """A solid line through points: a smooth curve where they are many, else straight pieces."""
    if len(pixels) >= _CURVE:
        _draw_curve(surface, pixels, colour, width)
        return
    for start, end in pairwise(pixels):
        draw_segment(surface, start, end, colour, width)


def draw_dashed(surface: pygame.Surface, pixels: Sequence[complex], colour: Colour, width: float, dash: float) -> None:
    """A dashed line through points. dash: length of a dash, and of a gap."""
    for start, end in _dashes(pixels, dash, surface.get_clip()):
        draw_segment(surface, start, end, colour, width)


def draw_segment(surface: pygame.Surface, start: complex, end: complex, colour: Colour, width: float) -> None:
    """A straight line of some width: thin lines beside each other, and a polygon between them where it is wide.

    The polygon has no smooth edge, so it ends a pixel within the line's.
    """
    if not (is_near(start) and is_near(end)):
        return
    half = 0.5 + 0.5j
    start, end = start - half, end - half
    if width <= 1.5 or start == end:
        pygame.draw.aaline(surface, colour, (start.real, start.imag), (end.real, end.imag))
        return
    side, length = (end - start) / abs(end - start) * 1j, (width - 1.0) / 2.0
    if length > _WIDE:
        inner = side * (length - 1.0)
        corners = [start + inner + half, end + inner + half, end - inner + half, start - inner + half]
        draw_polygon(surface, colour, [(corner.real, corner.imag) for corner in corners])
    for offset in _offsets(length):
        a, b = start + side * offset, end + side * offset
        pygame.draw.aaline(surface, colour, (a.real, a.imag), (b.real, b.imag))


def _offsets(half: float) -> list[float]:
    """How far thin lines lie from the middle of a line that is wider by twice so much."""
    if half > _WIDE:
        return [half, half - _BESIDE, _BESIDE - half, -half]
    count = math.ceil(2.0 * half / _BESIDE)
    return [half * (2.0 * k / count - 1.0) for k in range(count + 1)] if count else [0.0]


def _draw_curve(surface: pygame.Surface, pixels: Sequence[complex], colour: Colour, width: float) -> None:
    """A smooth line of many short pieces; see `draw_segment`."""
    points = np.array(pixels, dtype=np.complex128) - (0.5 + 0.5j)
    if not (np.abs(points.real).max() < FAR and np.abs(points.imag).max() < FAR):
        return
    along = np.gradient(points)
    side = 1j * along / np.maximum(np.abs(along), 1e-9)
    half = max(width - 1.0, 0.0) / 2.0
    if half > _WIDE:
        inner, corner = side * (half - 1.0), 0.5 + 0.5j  # polygons count pixels from their corners
        draw_polygon(surface, colour, _pairs(points + inner + corner) + _pairs(points - inner + corner)[::-1])
    for offset in _offsets(half):
        pygame.draw.aalines(surface, colour, False, _pairs(points + side * offset))


def _cut(corners: Sequence[Sequence[float]], row: int, sign: int) -> list[Sequence[float]]:
    """The part of a polygon below a row, with sign 1, or above it, with sign -1."""
    kept: list[Sequence[float]] = []
    for (x, y), (next_x, next_y) in pairwise([*corners, *corners[:1]]):
        if sign * (y - row) >= 0.0:
            kept.append((x, y))
        if (y < row < next_y) or (next_y < row < y):
            kept.append((x + (next_x - x) * (row - y) / (next_y - y), row))
    return kept


def _pairs(points: NDArray[np.complex128]) -> list[list[float]]:
    """Points as pygame takes them."""
    return np.ascontiguousarray(points).view(np.float64).reshape(-1, 2).tolist()


def _dashes(pixels: Sequence[complex], length: float, area: pygame.Rect) -> list[tuple[complex, complex]]:
    """Start and end of each dash of a line through points, of those that are seen in an area."""
    dashes: list[tuple[complex, complex]] = []
    done = 0.0
    room = area.inflate(round(4 * length), round(4 * length))
    for start, end in pairwise(pixels):
        total = abs(end - start)
        if total == 0.0 or not room.clipline(rounded(start), rounded(end)):
            done += total
            continue
        along = (end - start) / total
        first, last = _seen_part(start, along, total, room)
        k = math.floor((done + first) / (2.0 * length))
        while (begin := 2.0 * length * k - done) < last:
            a, b = max(begin, 0.0), min(begin + length, total)
            if b > a:
                dashes.append((start + along * a, start + along * b))
            k += 1
        done += total
    return dashes


def _seen_part(start: complex, along: complex, total: float, room: pygame.Rect) -> tuple[float, float]:
    """From where to where on a line it can be seen. along: its direction. total: its length."""
    middle = (complex(*room.center) - start) * along.conjugate()
    around = math.hypot(room.width, room.height) / 2.0
    return max(middle.real - around, 0.0), min(middle.real + around, total)
