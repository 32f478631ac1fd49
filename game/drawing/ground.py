"""The ground with its rim and the paddles' track as any camera sees them: circles of the ground, anti-aliased.

A row of pixels sees a straight line of the ground, parallel to the screen: where it meets a circle is a square root.
"""

import math
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.flat.annulus_pixels import Floats, between
from game.drawing.flat.ring import packed, pixels_of, unpacked
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.solid.quad_raster import Mosaic, in_pixels

_FRINGE = 3.0
"""Pixels around a line that are looked at."""
_RIM, _LEAST_RIM = 0.07, 2.0
"""Width of the rim: world units, and pixels."""
_THICKNESS, _EDGE_SHADE = 0.03, 0.6
"""Of the disc, in shares of its radius; and how far the colour of its side is on its way from the rim's to the background's."""
_SIDES, _FINER = 180, 2
_TRACK, _LEAST_TRACK = 0.03, 1.0


class _Band(NamedTuple):
    """The pixels around a circle of the ground."""

    place: NDArray[np.int64]  # into the surface's pixels, row after row
    radius: Floats  # of the ground's point at the pixel's middle, world units
    scale: Floats  # pixels per world unit there, away from the circle's centre


def ground_picture(
    surface: pygame.Surface, radius: float, camera: Camera, theme: Theme, track: float | None = None
) -> pygame.Surface:
    """A picture of the ground alone, as large as a 32-bit surface. track: radius of the circle that the paddles run on."""
    picture = pygame.Surface(surface.get_size(), 0, surface)
    picture.fill(theme.background)
    rim = max(_LEAST_RIM / camera.scale, _RIM)
    _draw_edge(picture, camera, radius + rim, theme)
    fringe = _fringe(camera, radius)
    around = np.exp(1j * np.linspace(0.0, math.tau, 128, endpoint=False))
    disc = camera.projected(around * max(radius - fringe / 2.0, 0.0), 0.0)
    pygame.draw.polygon(picture, theme.ground, disc.view(np.float64).reshape(-1, 2).tolist())
    _draw(picture, camera, (radius, rim, fringe), (theme.ground, theme.rim, None))
    if track is not None:
        width = _TRACK + _LEAST_TRACK / camera.scale
        _draw(picture, camera, (track - width / 2.0, width, fringe), (theme.ground, theme.ground_line, theme.ground))
    return picture


def _draw_edge(picture: pygame.Surface, camera: Camera, radius: float, theme: Theme) -> None:
    """The side of the disc that the ground is, where it is turned to the eye."""
    around = np.exp(1j * np.linspace(0.0, math.tau, _SIDES + 1))
    shown = camera.nearer(around[:-1] * radius, around[:-1]) > -0.1
    top, bottom = (camera.projected(around * radius, height * radius) for height in (0.0, -_THICKNESS))
    strips = np.stack([top[:-1], top[1:], bottom[1:], bottom[:-1]], axis=1)[shown]
    colour = np.array(mixed(theme.rim, theme.background, _EDGE_SHADE), dtype=np.float32)
    mosaic = Mosaic()
    mosaic.draw(picture, in_pixels(strips, _FINER), packed(mosaic.canvas, np.repeat(colour[None], len(strips), axis=0)), _FINER)


def _fringe(camera: Camera, radius: float) -> float:
    """World units that some pixels span where the ground's are flattest."""
    sine, cosine = math.sin(camera.tilt), math.cos(camera.tilt)
    return min(_FRINGE / camera.scale * (1.0 + camera.closeness * radius * sine) ** 2 / cosine, radius / 2.0)


def _draw(
    picture: pygame.Surface, camera: Camera, line: tuple[float, float, float], colours: tuple[Colour, Colour, Colour | None]
) -> None:
    """A circular line. line: its inner radius, width, fringe, world units; colours: within, of the line, outside.

    Outside it may also leave what is there.
    """
    inner, width, fringe = line
    pixels = _around(picture, camera, max(inner - fringe, 0.0), inner + width + fringe)
    if not len(pixels.place):
        return
    there = pixels_of(picture)
    within, drawn_line = (np.array(colour, dtype=np.float32) for colour in colours[:2])
    outside = unpacked(picture, there[pixels.place]) if colours[2] is None else np.array(colours[2], dtype=np.float32)
    past_inner = np.clip((pixels.radius - inner) * pixels.scale + 0.5, 0.0, 1.0)[:, None]
    past_outer = np.clip((pixels.radius - inner - width) * pixels.scale + 0.5, 0.0, 1.0)[:, None]
    drawn = within + (drawn_line - within) * past_inner
    drawn += (outside - drawn) * past_outer
    there[pixels.place] = packed(picture, drawn)


def _around(picture: pygame.Surface, camera: Camera, inner: float, outer: float) -> _Band:
    """The pixels that see the ground between two radii."""
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
    xs, ys = between(rows, camera.centre.real, hole, reach, width)
    index = ys - rows[0] if len(rows) else ys
    right, away, wide, deep = (
        (xs + 0.5 - camera.centre.real) / camera.scale,
        away[index],
        wide[index],
        cosine / slope[index] ** 2,
    )
    across = right * wide
    radius = np.maximum(np.hypot(across, away), 1e-9)
    steep = np.hypot(across * wide, across * right * near * sine * deep + away * deep) / radius
    stride = picture.get_pitch() // 4
    return _Band(ys * stride + xs, radius.astype(np.float32), (camera.scale / np.maximum(steep, 1e-9)).astype(np.float32))
