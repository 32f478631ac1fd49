"""Paints flat lists of primitives on a surface, anti-aliased: the desktop's half of what a browser's canvas does.

Of the primitives (`game.picture.primitives` documents them) those are painted here that the desktop's pictures are made of.
"""

import math
from array import array
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import pygame

from game.drawing.palette import Colour
from game.drawing.raster.annulus import Floats
from game.drawing.raster.pixels import pairs
from game.drawing.raster.primitives import HALF_PIXEL, draw_box, draw_circle, draw_dot
from game.drawing.text import Type, blit_faded
from game.picture.display_list import DisplayList
from game.picture.primitives import Primitive, primitives, unpacked

_BEND = 0.02
"""Sine of the angle between two pieces of a band from which a disc rounds the joint."""
_FINER = 4
"""Rows and columns of a sprite's drawing per pixel."""
_MOST_SPRITES, _MOST_LIGHTS = 256, 6
_STRENGTHS = 22
"""Strengths that a light has pictures for, from none to all of its colour."""
_LARGEST, _STEP = 96, 8
"""Sides of the pictures that lights are drawn in and scaled up from, pixels, as nothing of a light is sharp: at most, and from
one to the next. They are never scaled down, which would leave white not quite white."""
_SHARPNESS = 3.2
"""How fast a light falls off."""
_INSETS = np.array([0.8, 1.0, 0.5]).reshape(3, 1, 1)
"""From a strip's borders to what is filled, to the lines that close its gaps, and to those that smooth it, pixels: the quickest
of those that were tried that leave no hole."""
_ANCHORS = {0.0: "midleft", 0.5: "center", 1.0: "midright"}
"""Points of a text's box, by how far along the text they are."""


class DisplayListPainter:
    """Paints lists. Caches sprites and the lights that were scaled up last, since most look the same for a few frames."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._sprites: dict[bytes, pygame.Surface] = {}
        self._lights: dict[tuple[object, ...], _ScaledLight] = {}  # least recently used first

    def paint(self, surface: pygame.Surface, letters: Type, picture: DisplayList) -> None:
        """Paint a list on a 32-bit surface. Raises ValueError for a primitive that only a canvas paints."""
        for code, packed, opacity, own in primitives(picture.numbers):
            colour = unpacked(packed)
            if code in _SHAPES:
                _SHAPES[code](surface, colour, own)
                continue
            match code:
                case Primitive.TEXT:
                    index, size, x, y, across, _bold, room = own
                    text, anchor = picture.texts[int(index)], _ANCHORS[across]
                    if room and (wide := letters.rendered(text, size, colour).get_width()) > room:
                        size *= room / wide
                    letters.write(surface, text, size, colour, complex(x, y), anchor, opacity=opacity)
                case Primitive.PLATE:
                    words = letters.rendered(picture.texts[int(own[0])], own[1], colour)
                    _paint_plate(surface, words, own, colour, opacity)
                case Primitive.GLOW:
                    self._paint_light(surface, colour, opacity, own)
                case Primitive.SPRITE:
                    sprite = self._sprite(own)
                    surface.blit(sprite, sprite.get_rect(center=(round(own[0]), round(own[1]))))
                case _:
                    raise ValueError(f"the desktop does not paint {Primitive(code).name}")

    def _sprite(self, own: "array[float]") -> pygame.Surface:
        """The picture of a sprite, drawn once."""
        key = own[2:].tobytes()
        if key not in self._sprites:
            if len(self._sprites) >= _MOST_SPRITES:
                self._sprites.clear()
            self._sprites[key] = _sprite(own[2], own[4:])
        return self._sprites[key]

    def _paint_light(self, surface: pygame.Surface, colour: Colour, strength: float, own: "array[float]") -> None:
        """An ellipse of light."""
        x, y, across, down, multiplies = own
        whole = pygame.Rect(0, 0, 2 * max(round(across), 1), 2 * max(round(down), 1))
        whole.center = round(x), round(y)
        side, step = max(min(*whole.size, _LARGEST) // _STEP * _STEP, 2), round(strength * _STRENGTHS + 0.499)
        small = _small_light(side, step, colour, multiplies=bool(multiplies))
        part, seen = _seen(whole, surface.get_clip(), small)
        if part.size != (0, 0):
            picture = self._scaled((side, step, colour, multiplies), small.picture, part, seen.size)
            surface.blit(picture, seen, special_flags=pygame.BLEND_RGB_MULT if multiplies else pygame.BLEND_RGB_ADD)

    def _scaled(
        self, look: tuple[object, ...], small: pygame.Surface, part: pygame.Rect, size: tuple[int, int]
    ) -> pygame.Surface:
        """A part of a small picture, scaled up to a size. look: what the small one depends on.

        The least recently used light gives its memory to a new one, since allocating memory takes longer than scaling.
        """
        key = (*look, *part, *size)
        found = self._lights.pop(key, None)
        if found is None:
            memory = pygame.Surface((1, 1), 0, 32)
            if len(self._lights) >= _MOST_LIGHTS:
                memory = self._lights.pop(next(iter(self._lights))).memory
            if memory.width < size[0] or memory.height < size[1]:
                memory = pygame.Surface((max(memory.width, size[0]), max(memory.height, size[1])), 0, 32)
            found = _ScaledLight(memory, memory.subsurface((0, 0, *size)))
            pygame.transform.smoothscale(small.subsurface(part), size, found.picture)
        self._lights[key] = found
        return found.picture


class _ScaledLight(NamedTuple):
    """A light at its size on the screen. memory: a surface that its picture is a part of."""

    memory: pygame.Surface
    picture: pygame.Surface


def _seen(whole: pygame.Rect, clip: pygame.Rect, small: "_SmallLight") -> tuple[pygame.Rect, pygame.Rect]:
    """The visible part of a small light, in its own pixels, and the box of that part on the surface once it is scaled up.

    whole: the box of the whole light on the surface.
    """
    side, shining = small.picture.width, small.shining
    across, down = whole.width / side, whole.height / side
    left, top = whole.left + shining.left * across, whole.top + shining.top * down
    box = pygame.Rect(left, top, math.ceil(shining.width * across) + 1, math.ceil(shining.height * down) + 1).clip(clip)
    if not box.size[0] * box.size[1]:
        return pygame.Rect(0, 0, 0, 0), pygame.Rect(0, 0, 0, 0)
    left, top = int((box.left - whole.left) / across), int((box.top - whole.top) / down)
    right, bottom = math.ceil((box.right - whole.left) / across), math.ceil((box.bottom - whole.top) / down)
    part = pygame.Rect(left, top, min(right, side) - left, min(bottom, side) - top)
    start = whole.left + round(left * across), whole.top + round(top * down)
    return part, pygame.Rect(*start, max(round(part.width * across), 1), max(round(part.height * down), 1))


def _corners(own: "array[float]") -> list[tuple[float, float]]:
    """The corners of a polygon, pixels."""
    return list(zip(own[1::2], own[2::2], strict=True))


def _paint_disc(surface: pygame.Surface, colour: Colour, own: "array[float]") -> None:
    """A disc."""
    draw_dot(surface, complex(own[0], own[1]), own[2], colour)


def _paint_circle(surface: pygame.Surface, colour: Colour, own: "array[float]") -> None:
    """The line of a circle."""
    draw_circle(surface, complex(own[0], own[1]), own[2] + own[3] / 2.0, own[3], colour)


def _paint_polygon(surface: pygame.Surface, colour: Colour, own: "array[float]") -> None:
    """A filled polygon."""
    corners = _corners(own)
    pygame.draw.polygon(surface, colour, corners)
    pygame.draw.aalines(surface, colour, True, [(x - 0.5, y - 0.5) for x, y in corners])


def _paint_strip(surface: pygame.Surface, colour: Colour, own: "array[float]") -> None:
    """What is between two lines, quadrilateral by quadrilateral, since a polygon with many corners is filled slowly."""
    quads, borders, edge = _strip_lines(own[1:].tobytes())
    for corners in quads:
        pygame.draw.polygon(surface, colour, corners)
    for border in borders:
        pygame.draw.lines(surface, colour, False, border)
    pygame.draw.aalines(surface, colour, True, edge)


@lru_cache(maxsize=64)
def _strip_lines(numbers: bytes) -> tuple[Any, Any, Any]:
    """The quadrilaterals that fill a strip, the lines that close its gaps, and the one that smooths its edge.

    Cached, because half of all strips stay the same from frame to frame, and computing them takes as long as filling them.
    """
    lines = np.frombuffer(numbers, dtype=np.float32).astype(np.float64).view(np.complex128).reshape(-1, 2).T
    across = lines[::-1] - lines
    filled, closing, smooth = lines + across * np.minimum(_INSETS / np.maximum(np.abs(across), 1e-9), 0.5)
    left, right = pairs(filled)
    quads = list(zip(left, left[1:], right[1:], right, strict=False))
    return quads, pairs(closing), pairs(np.concatenate([smooth[0], smooth[1, ::-1]]) - HALF_PIXEL)


def _paint_band(surface: pygame.Surface, _colour: Colour, own: "array[float]") -> None:
    """A band, piece by piece."""
    before, start, radius = 0j, complex(own[1], own[2]), own[3]
    for k in range(5, len(own), 4):
        end, end_radius = complex(own[k], own[k + 1]), own[k + 2]
        piece = end - start
        if piece:
            colour = unpacked(own[k + 3])
            if abs((piece * before.conjugate()).imag) >= _BEND * abs(piece) * abs(before):
                draw_dot(surface, start, radius, colour)
            _paint_piece(surface, colour, start, end, radius, end_radius)
            before = piece
        start, radius = end, end_radius


def _paint_piece(
    surface: pygame.Surface, colour: Colour, start: complex, end: complex, start_radius: float, end_radius: float
) -> None:
    """A straight piece of a band. The radii are half its widths at its ends."""
    aside = (end - start) / abs(end - start) * 1j
    left = start + aside * start_radius, end + aside * end_radius
    right = end - aside * end_radius, start - aside * start_radius
    pygame.draw.polygon(surface, colour, [(corner.real, corner.imag) for corner in (*left, *right)])
    for one, other in (left, right):
        pygame.draw.aaline(surface, colour, (one.real - 0.5, one.imag - 0.5), (other.real - 0.5, other.imag - 0.5))


def _paint_line(surface: pygame.Surface, colour: Colour, own: "array[float]") -> None:
    """A line without gaps through points."""
    points = [(x - 0.5, y - 0.5) for x, y in zip(own[3::2], own[4::2], strict=True)]
    for start, end in pairwise(points):
        pygame.draw.aaline(surface, colour, start, end, max(round(own[0]), 1))


def _paint_box(surface: pygame.Surface, colour: Colour, own: "array[float]") -> None:
    """A rectangle with round corners."""
    x, y, width, height, radius, edge, edge_colour = own
    box = pygame.Rect(round(x), round(y), max(round(width), 2), max(round(height), 2))
    draw_box(surface, box, radius, colour, unpacked(edge_colour) if edge else None, edge)


_SHAPES: dict[int, Callable[[pygame.Surface, Colour, "array[float]"], None]] = {
    Primitive.DISC.value: _paint_disc,
    Primitive.CIRCLE.value: _paint_circle,
    Primitive.POLYGON.value: _paint_polygon,
    Primitive.LINE.value: _paint_line,
    Primitive.STRIP.value: _paint_strip,
    Primitive.BAND.value: _paint_band,
    Primitive.BOX.value: _paint_box,
}
"""What paints the primitives that consist of their own numbers alone."""


def _paint_plate(surface: pygame.Surface, words: pygame.Surface, own: "array[float]", colour: Colour, opacity: float) -> None:
    """A plate behind words."""
    _index, _size, x, y, across, down, edge, edge_colour = own
    box = words.get_rect(center=(round(x), round(y))).inflate(round(2.0 * across), round(2.0 * down))
    plate = _plate(box.size, colour, unpacked(edge_colour), edge)
    blit_faded(surface, plate, box, opacity)


@lru_cache(maxsize=64)
def _plate(size: tuple[int, int], colour: Colour, edge_colour: Colour, edge: float) -> pygame.Surface:
    """A plate with round ends on a transparent surface. size, edge: pixels."""
    plate = pygame.Surface(size, pygame.SRCALPHA)
    plate.fill((*edge_colour, 0))
    draw_box(plate, plate.get_rect(), size[1] / 2.0, colour, edge_colour, edge)
    return plate


def _sprite(reach: float, numbers: "array[float]") -> pygame.Surface:
    """Polygons on a transparent square, drawn finer and scaled down. Its transparent pixels have the first one's colour."""
    side = 2 * round(reach)
    middle = side * _FINER / 2.0
    picture = pygame.Surface((side * _FINER, side * _FINER), pygame.SRCALPHA)
    picture.fill((*unpacked(numbers[1]), 0))
    for _code, packed, _opacity, own in primitives(numbers):
        corners = [(middle + x * _FINER, middle + y * _FINER) for x, y in _corners(own)]
        pygame.draw.polygon(picture, unpacked(packed), corners)
    return pygame.transform.smoothscale(picture, (side, side))


class _SmallLight(NamedTuple):
    """The square picture that a light is scaled up from. shining: the part of it that changes what is below."""

    picture: pygame.Surface
    shining: pygame.Rect


@lru_cache(maxsize=256)
def _small_light(side: int, step: int, colour: Colour, *, multiplies: bool) -> _SmallLight:
    """A round light. step: of its strength, up to _STRENGTHS; multiplies: whether it is multiplied with what is below."""
    light = _fall_off(side) * np.float32(step / _STRENGTHS)
    own = np.array(colour, dtype=np.float32)[:, None, None]
    rgb = np.rint(255.0 - (255.0 - own) * light if multiplies else own * light)
    picture = pygame.Surface((side, side), 0, 32)
    pygame.surfarray.pixels3d(picture)[:] = np.moveaxis(rgb, 0, 2)
    rows = np.flatnonzero((rgb[:, side // 2] != (255.0 if multiplies else 0.0)).any(axis=0))
    first, behind = (int(rows[0]), int(rows[-1]) + 1) if len(rows) else (0, 0)
    return _SmallLight(picture, pygame.Rect(first, first, behind - first, behind - first))


@lru_cache(maxsize=16)
def _fall_off(side: int) -> Floats:
    """The strength of a light in every pixel of a square, 1 in the middle and 0 on the circle in it."""
    across = ((np.arange(side) + 0.5) * (2.0 / side) - 1.0).astype(np.float32)
    away = across[:, None] ** 2 + across[None, :] ** 2
    return np.asarray(np.exp(-_SHARPNESS * away) * np.clip(1.0 - away, 0.0, 1.0), dtype=np.float32)
