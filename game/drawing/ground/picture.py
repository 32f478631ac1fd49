"""The ground with its rim, its pattern and the paddles' track as any camera sees them, anti-aliased.

Around the centre the colours are smooth: discs, one for every colour that a screen can show. Lines are circles of the ground: a
row of pixels sees a straight line of the ground, parallel to the screen, and where it meets a circle is a square root.
"""

import math
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.ground.shades import GroundDisc, coloured_marks, discs
from game.drawing.palette import Colour
from game.drawing.raster.annulus import Floats, columns_between
from game.drawing.raster.pixels import packed, pairs, pixels_of, unpacked
from game.drawing.raster.quads import QuadRaster, fine_pixels
from game.picture.display_list import DisplayList
from game.picture.ground.lists import ground_list
from game.picture.ground.measures import Ground
from game.picture.primitives import Primitive, primitives
from game.picture.primitives import unpacked as unpacked_colour

_FRINGE = 3.0
"""Pixels on both sides of a line that are looked at."""
_EDGE_PIECES, _EDGE_FINER = 180, 2
"""Quadrilaterals that the disc's side is cut into, and rows and columns of their drawing per pixel."""
_DISC_CORNERS, _DISC_STEPS = 128, 2048
"""Corners of a disc of one colour, and distances that are looked at for where a colour changes."""
_MARKS_FINER, _MANY_PIXELS = 2, 5_000_000
"""Rows and columns per pixel of the drawing of the marks on the ground; on surfaces with so many pixels one is fine enough."""


class _CirclePixels(NamedTuple):
    """The pixels around a circle of the ground.

    pixel: its index in the surface's memory, row after row.
    radius: of the ground's point at the pixel's middle, world units.
    scale: pixels per world unit there, away from the circle's centre.
    """

    pixel: NDArray[np.int64]
    radius: Floats
    scale: Floats


def ground_picture(canvas: Canvas, ground: Ground) -> pygame.Surface:
    """A picture of the ground without its pattern, as large as a canvas: from every azimuth the same."""
    camera = canvas.camera
    parts = ground_list(ground, canvas.theme, camera.scale)
    picture = _smooth_picture(canvas, parts)
    for code, packed_colour, _, own in primitives(parts.numbers):
        colour = unpacked_colour(packed_colour)
        match code:
            case Primitive.GROUND_SIDE:
                _draw_side(picture, camera, own[0], own[1], colour)
            case Primitive.GROUND_CIRCLE:
                _draw_line(picture, camera, discs(parts)[-1], own[0], own[1], colour)
    return picture


def draw_pattern(canvas: Canvas, ground: Ground) -> None:
    """The ground's pattern and the marks at its rim, over its picture."""
    corners, colours = coloured_marks(ground, canvas.theme)
    raster = QuadRaster()
    finer = _MARKS_FINER if canvas.size[0] * canvas.size[1] < _MANY_PIXELS else 1
    pixels = canvas.camera.projected(corners * canvas.camera.turning, 0.0)
    raster.draw(canvas.surface, fine_pixels(pixels, finer), packed(raster.canvas, colours), finer)


def _smooth_picture(canvas: Canvas, ground: DisplayList) -> pygame.Surface:
    """The ground and what is around it, without lines: large ones are drawn half as large and scaled up, nothing is sharp."""
    camera, (width, height) = canvas.camera, canvas.size
    half = width * height > _MANY_PIXELS
    small = camera._replace(centre=camera.centre / 2.0, scale=camera.scale / 2.0) if half else camera
    picture = pygame.Surface(((width + 1) // 2, (height + 1) // 2) if half else canvas.size, 0, canvas.surface)
    (_, background, *_), around, within = next(primitives(ground.numbers)), *discs(ground)
    picture.fill(unpacked_colour(background))
    _draw_disc(picture, small, around, 1.0)
    _draw_disc(picture, small, within, 1.0 - _fringe(small, within.outer) / 2.0 / within.outer)
    return pygame.transform.smoothscale(picture, canvas.size) if half else picture


def _draw_disc(picture: pygame.Surface, camera: Camera, disc: GroundDisc, size: float) -> None:
    """A disc as one disc for every colour that a screen can show, the largest first. size: a factor of their radii."""
    corners = np.exp(1j * np.linspace(0.0, math.tau, _DISC_CORNERS, endpoint=False))
    radii = np.linspace(disc.inner, disc.outer, _DISC_STEPS + 1)
    colours = np.rint(disc.at(radii)).astype(np.int64)
    last = np.flatnonzero(np.append((colours[1:] != colours[:-1]).any(axis=1), True))[::-1]
    for radius, colour in zip(radii[last].tolist(), colours[last].tolist(), strict=True):
        pygame.draw.polygon(picture, colour, pairs(camera.projected(corners * (radius * size), 0.0)))


def _draw_side(picture: pygame.Surface, camera: Camera, radius: float, depth: float, colour: Colour) -> None:
    """The side of the disc that the ground is, where it is turned to the eye."""
    around = np.exp(1j * np.linspace(0.0, math.tau, _EDGE_PIECES + 1))
    shown = camera.nearer(around[:-1] * radius, around[:-1]) > 0.0
    top, bottom = (camera.projected(around * radius, height) for height in (0.0, -depth))
    strips = np.stack([top[:-1], top[1:], bottom[1:], bottom[:-1]], axis=1)[shown]
    raster = QuadRaster()
    colours = packed(raster.canvas, np.repeat(np.array([colour], dtype=np.float32), len(strips), axis=0))
    raster.draw(picture, fine_pixels(strips, _EDGE_FINER), colours, _EDGE_FINER)


def _fringe(camera: Camera, radius: float) -> float:
    """World units that _FRINGE pixels span where the ground is seen most aslant."""
    sine, cosine = math.sin(camera.tilt), math.cos(camera.tilt)
    return min(_FRINGE / camera.scale * (1.0 + camera.closeness * radius * sine) ** 2 / cosine, radius / 2.0)


def _draw_line(picture: pygame.Surface, camera: Camera, disc: GroundDisc, inner: float, width: float, colour: Colour) -> None:
    """A circular line and what is near it. disc: of the ground, which may end where the line begins."""
    fringe = _fringe(camera, disc.outer)
    pixels = _pixels_between(picture, camera, max(inner - fringe, 0.0), inner + width + fringe)
    if not len(pixels.pixel):
        return
    there = pixels_of(picture)
    within = disc.at(pixels.radius)
    outside = unpacked(picture, there[pixels.pixel]) if inner + width > disc.outer else within
    past_inner = np.clip((pixels.radius - inner) * pixels.scale + 0.5, 0.0, 1.0)[:, None]
    past_outer = np.clip((pixels.radius - inner - width) * pixels.scale + 0.5, 0.0, 1.0)[:, None]
    drawn = within + (np.array(colour, dtype=np.float32) - within) * past_inner
    drawn += (outside - drawn) * past_outer
    there[pixels.pixel] = packed(picture, drawn)


def _pixels_between(picture: pygame.Surface, camera: Camera, inner: float, outer: float) -> _CirclePixels:
    """The pixels that see the ground between two radii, world units."""
    width, height = picture.get_size()
    sine, cosine, near = math.sin(camera.tilt), math.cos(camera.tilt), camera.closeness
    rows = np.arange(height, dtype=np.int64)
    up = (camera.centre.imag - rows - 0.5) / camera.scale
    slope = cosine - up * near * sine
    seen = (slope > 1e-3) & (np.abs(up) <= outer * np.maximum(slope, 0.0))
    rows, up, slope = rows[seen], up[seen], slope[seen]
    away = up / slope
    wide = 1.0 + near * sine * away
    hole, reach = (np.sqrt(np.maximum(radius * radius - away * away, 0.0)) / wide * camera.scale for radius in (inner, outer))
    xs, ys = columns_between(rows, camera.centre.real, hole, reach, width)
    index = ys - rows[0] if len(rows) else ys
    right = (xs + 0.5 - camera.centre.real) / camera.scale
    away, wide, deep = away[index], wide[index], cosine / slope[index] ** 2
    across = right * wide
    radius = np.maximum(np.hypot(across, away), 1e-9)
    steep = np.hypot(across * wide, across * right * near * sine * deep + away * deep) / radius
    stride = picture.get_pitch() // 4
    scale = camera.scale / np.maximum(steep, 1e-9)
    return _CirclePixels(ys * stride + xs, radius.astype(np.float32), scale.astype(np.float32))
