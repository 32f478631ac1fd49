"""A ring on the screen at any angle: every pixel of its band looks up its colour by radius and by angle from the ring.

A turning ring costs two look-ups a pixel, however many bricks it has, and its edges stay as smooth as if drawn for that angle.
"""

import math
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.flat.sector_colours import paint_circle, paint_parts
from game.drawing.ground import track_width
from game.drawing.palette import Theme
from game.drawing.raster.annulus import Floats, annulus_pixels
from game.drawing.raster.pixels import packed, pixels_of
from game.drawing.slots.contents import ContentKind, SlotContent
from game.drawing.slots.parts import Bar, SlotShape, parts, slot_shape
from physics import Ring

_FINE = 4
"""Rows and columns of a slot's picture per pixel of the screen; in large rings half as many are enough."""
_LARGE = 500.0
"""Pixels; outer radius from which a ring is large."""
_MOST_COLUMNS = 1 << 16
"""Columns of all slots' pictures of a ring together."""
_BORDER = 1.0
"""Pixels beyond the ring's faces that its border may colour."""
_ON_TRACK = frozenset({ContentKind.PADDLE, ContentKind.RECOILING})
"""Slots of the paddles' ring, which show the track."""


class RingKey(NamedTuple):
    """What a ring's picture depends on, apart from its angle and its contents.

    size: of the surface, pixels.
    stride: pixels from row to row in the surface's memory.
    camera: a flat one.
    slot: the shape of the ring's slots.
    slots: how many there are.
    theme: the colours.
    """

    size: tuple[int, int]
    stride: int
    camera: Camera
    slot: SlotShape
    slots: int
    theme: Theme


def ring_key(canvas: Canvas, ring: Ring, tallest: int) -> RingKey:
    """The key of a ring on a 32-bit surface. tallest: layers of the highest stack that may ever stand there."""
    stride, slot = canvas.surface.get_pitch() // 4, slot_shape(ring, tallest, 1.0 / canvas.camera.scale)
    return RingKey(canvas.size, stride, canvas.camera, slot, ring.count, canvas.theme)


class RingPicture:
    """One ring, ready to be drawn.

    The pictures of all contents that its slots have shown stand in an atlas, column after column: a column has the colours
    of all radii at one angle of one content.
    """

    def __init__(self, key: RingKey) -> None:
        """Find the ring's pixels."""
        scale, slot = key.camera.scale, key.slot
        outer = slot.outer_radius * scale
        fine = _FINE if outer < _LARGE else _FINE // 2
        pitch = math.tau / key.slots
        self._theme, self._slot, self._scale = key.theme, slot, scale
        self._columns = max(min(math.ceil(fine * outer * pitch), _MOST_COLUMNS // key.slots), 1)
        self._columns_around = self._columns * key.slots
        low = max(slot.inner_radius * scale - _BORDER, 0.0)
        rows = max(math.ceil((outer + _BORDER - low) * fine), 1)
        self._radii = (low + (np.arange(rows, dtype=np.float32) + 0.5) / fine).astype(np.float32)
        self._angles = (((np.arange(self._columns) + 0.5) / self._columns - 0.5) * pitch).astype(np.float32)
        self._half_pitch = pitch / 2.0
        pixels = annulus_pixels(key.size, key.stride, key.camera.centre, low, outer + _BORDER)
        self._pixel_index = pixels.pixel
        self._pixel_row = np.minimum(((pixels.radius - low) * fine).astype(np.int32), rows - 1)
        column = (pixels.angle * (self._columns_around / math.tau)).astype(np.int32)
        self._pixel_column = np.minimum(column, self._columns_around - 1)
        self._columns_of: dict[SlotContent, NDArray[np.int32]] = {}
        self._atlas = np.zeros((0, rows), dtype=np.uint32)
        self._contents: tuple[SlotContent, ...] = ()
        self._column_at = np.zeros(0, dtype=np.int32)

    def draw(self, surface: pygame.Surface, phase: float, contents: tuple[SlotContent, ...]) -> None:
        """Draw the ring. phase: middle angle of slot 0, radians; contents: of every slot."""
        if not len(self._pixel_index):
            return
        if contents != self._contents:
            self._arrange(surface, contents)
        shift = round((self._half_pitch - phase) / math.tau * self._columns_around) % self._columns_around
        index = self._column_at.take(self._pixel_column + np.int32(shift))
        index += self._pixel_row
        pixels_of(surface)[self._pixel_index] = self._atlas.ravel().take(index)

    def _arrange(self, surface: pygame.Surface, contents: tuple[SlotContent, ...]) -> None:
        """Note where in the atlas each column around the ring begins, from slot 0 on; twice around, which saves a modulo."""
        for content in dict.fromkeys(contents):
            if content not in self._columns_of:
                self._columns_of[content] = self._added(surface, content)
        around = [self._columns_of[content] for content in contents]
        self._column_at = np.concatenate(around + around)
        self._contents = contents

    def _added(self, surface: pygame.Surface, content: SlotContent) -> NDArray[np.int32]:
        """Paint one more content into the atlas, and return where in it each column of a slot begins."""
        pile = parts(content, self._slot, 0.0, self._theme)
        marked = any([isinstance(part, Bar) for part in pile])
        angles = self._angles if marked else _grouped(self._angles, self._slot, self._scale)
        angles, column = np.unique(angles, return_inverse=True)
        picture = np.empty((len(self._radii), len(angles), 3), dtype=np.float32)
        picture[:] = self._theme.ground
        if content.kind in _ON_TRACK:
            width, middle = track_width(self._scale) * self._scale, self._slot.radius * self._scale
            paint_circle(picture, width, middle, self._radii[:, None], self._theme.ground_line)
        paint_parts(picture, pile, self._slot, self._scale, self._radii[:, None], angles[None, :])
        first = len(self._atlas)
        self._atlas = np.concatenate([self._atlas, packed(surface, picture).T])
        return ((first + column) * len(self._radii)).astype(np.int32)


def _grouped(angles: Floats, slot: SlotShape, scale: float) -> Floats:
    """The angles, those at which a slot looks the same replaced by one: far from a sector's ends only the radius counts."""
    inner = slot.inner_radius * scale
    middle = slot.half_width * scale + 1.0
    flat = slot.half_angle - math.asin(min(middle / max(inner, 1e-9), 1.0))
    gap = slot.half_angle + 1.0 / max(inner, 1.0)
    far = np.abs(angles)
    if flat > 0.0:
        angles = np.where(far < flat, np.float32(0.0), angles)
    return np.where(far > gap, np.float32(gap), angles).astype(np.float32)
