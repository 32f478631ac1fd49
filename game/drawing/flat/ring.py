"""A ring on the screen at any angle: every pixel of its band looks up its colour by radius and by angle from the ring.

A turning ring costs two look-ups a pixel, however many bricks it has, and its edges stay as smooth as if drawn for that angle.
"""

import math
from typing import Any, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.flat.annulus_pixels import Floats, band
from game.drawing.flat.sector_colours import Kind, Look, Sector, colours
from game.drawing.palette import Theme
from physics import Ring

_FINE = 4
"""Rows and columns of a slot's picture per pixel of the screen; half as many where pixels are small."""
_LARGE = 500.0
_MOST_COLUMNS = 1 << 16
_BORDER = 1.0
"""Pixels beyond the ring's faces that its border may colour."""


class Shape(NamedTuple):
    """What a ring's picture depends on, apart from its angle and what stands in its slots."""

    size: tuple[int, int]
    stride: int  # pixels from row to row in the surface's memory
    camera: Camera
    radius: float
    half_width: float
    half_angle: float
    slots: int
    terrace: float  # world units
    theme: Theme


def shape_of(surface: pygame.Surface, camera: Camera, ring: Ring, terrace: float, theme: Theme) -> Shape:
    """The shape of a ring on a 32-bit surface."""
    stride = surface.get_pitch() // 4
    return Shape(surface.get_size(), stride, camera, ring.radius, ring.half_width, ring.half_angle, ring.count, terrace, theme)


class RingPicture:
    """One ring, ready to be drawn."""

    def __init__(self, shape: Shape) -> None:
        """Find the ring's pixels."""
        scale = shape.camera.scale
        inner, outer = (shape.radius - shape.half_width) * scale, (shape.radius + shape.half_width) * scale
        fine = _FINE if outer < _LARGE else _FINE // 2
        pitch = math.tau / shape.slots
        self._theme = shape.theme
        self._sector = Sector(inner, outer, shape.half_angle, shape.terrace * scale, scale)
        self._columns = max(min(math.ceil(fine * outer * pitch), _MOST_COLUMNS // shape.slots), 1)
        self._around = self._columns * shape.slots
        low = max(inner - _BORDER, 0.0)
        rows = max(math.ceil((outer + _BORDER - low) * fine), 1)
        self._radii = (low + (np.arange(rows, dtype=np.float32) + 0.5) / fine).astype(np.float32)
        self._angles = (((np.arange(self._columns) + 0.5) / self._columns - 0.5) * pitch).astype(np.float32)
        self._alike = _alike(self._angles, self._sector)
        self._half_pitch = pitch / 2.0
        pixels = band(shape.size, shape.stride, shape.camera.centre, low, outer + _BORDER)
        self._index = pixels.place
        self._row = np.minimum(((pixels.radius - low) * fine).astype(np.int32), rows - 1)
        self._turn = np.minimum((pixels.angle * (self._around / math.tau)).astype(np.int32), self._around - 1)
        self._found: dict[Look, NDArray[np.int32]] = {}  # per look and column of a slot: where it is in the atlas
        self._atlas = np.zeros((0, rows), dtype=np.uint32)
        self._looks: tuple[Look, ...] = ()
        self._slots = np.zeros(0, dtype=np.int32)

    def draw(self, surface: pygame.Surface, phase: float, looks: tuple[Look, ...]) -> None:
        """Draw the ring. phase: middle angle of slot 0, radians; looks: of every slot."""
        if not len(self._index):
            return
        if looks != self._looks:
            self._arrange(surface, looks)
        shift = round((self._half_pitch - phase) / math.tau * self._around) % self._around
        place = self._slots.take(self._turn + np.int32(shift))
        place += self._row
        pixels_of(surface)[self._index] = self._atlas.ravel().take(place)

    def _arrange(self, surface: pygame.Surface, looks: tuple[Look, ...]) -> None:
        """Note where in the atlas each angle from slot 0 finds its column, twice around to save a modulo."""
        for look in dict.fromkeys(looks):
            if look not in self._found:
                self._found[look] = self._added(surface, look)
        around = [self._found[look] for look in looks]
        self._slots = np.concatenate(around + around)
        self._looks = looks

    def _added(self, surface: pygame.Surface, look: Look) -> NDArray[np.int32]:
        """Paint one more look; per column of a slot, its place in the atlas."""
        angles, column = np.unique(self._angles if _marked(look) else self._alike, return_inverse=True)
        picture = colours(look, self._sector, self._radii, angles, self._theme)
        first = len(self._atlas)
        self._atlas = np.concatenate([self._atlas, packed(surface, picture).T])
        return ((first + column) * len(self._radii)).astype(np.int32)


def _marked(look: Look) -> bool:
    """Whether there is something on its top that not only the radius tells."""
    return look.kind is Kind.STEEL or (look.kind is Kind.BRICKS and look.layers > 1)


def _alike(angles: Floats, sector: Sector) -> Floats:
    """The angles, those replaced by one that look alike: far from a sector's ends only the radius counts."""
    middle = (sector.outer - sector.inner) / 2.0 + 1.0
    flat = sector.half_angle - math.asin(min(middle / max(sector.inner, 1e-9), 1.0))
    gap = sector.half_angle + 1.0 / max(sector.inner, 1.0)
    far = np.abs(angles)
    if flat > 0.0:
        angles = np.where(far < flat, np.float32(0.0), angles)
    return np.where(far > gap, np.float32(gap), angles).astype(np.float32)


def pixels_of(surface: pygame.Surface) -> NDArray[np.uint32]:
    """A 32-bit surface's pixels, row after row. The surface is locked for as long as the array lives."""
    buffer: Any = surface.get_buffer()
    return np.frombuffer(buffer, dtype=np.uint32)


def packed(surface: pygame.Surface, picture: NDArray[np.float32]) -> NDArray[np.uint32]:
    """Colours, red, green and blue along the last axis, as a 32-bit surface stores them."""
    channels = np.rint(picture).astype(np.uint32)
    red, green, blue, _ = (np.uint32(shift) for shift in surface.get_shifts())
    opaque = np.uint32(surface.get_masks()[3] & 0xFFFFFFFF)
    stored = channels[..., 0] << red | channels[..., 1] << green | channels[..., 2] << blue | opaque
    return np.asarray(stored, dtype=np.uint32)


def unpacked(surface: pygame.Surface, pixels: NDArray[np.uint32]) -> NDArray[np.float32]:
    """Red, green and blue, along one more axis, of pixels as a 32-bit surface stores them."""
    return np.stack([pixels >> np.uint32(shift) & np.uint32(255) for shift in surface.get_shifts()[:3]], axis=-1).astype(
        np.float32
    )
