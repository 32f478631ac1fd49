"""Pictures of everything that stands in a ring's slots, in polar coordinates, so that they serve at any angle of the ring."""

import math
from array import array
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.canvas import Canvas
from game.drawing.flat.band_pixels import BandKey
from game.drawing.flat.sector_colours import PolarPixels, paint_slot
from game.drawing.ground.shades import discs
from game.drawing.raster.annulus import Floats
from game.drawing.raster.pixels import packed
from game.picture.display_list import DisplayList
from game.picture.ground.lists import ground_list
from game.picture.ground.measures import Ground, ground_of
from game.picture.primitives import Primitive, primitives
from game.picture.slots.contents import SlotContent
from game.picture.slots.flat import FlatRing, add_content, add_shadow, flat_rings
from game.scene import Scene

_FINE = 4
"""Rows and columns of a slot's picture per pixel of the screen; in large rings half as many are enough."""
_LARGE = 500.0
"""Pixels; outer radius from which a ring is large."""
_MOST_COLUMNS = 1 << 16
"""Columns of all slots' pictures of a ring together."""
_BORDER = 1.0
"""Pixels beyond the ring's faces that its border may colour."""
BLANK = 0
"""Stands for a column in which nothing stands."""


class AtlasKey(NamedTuple):
    """What the pictures of a ring's slots depend on.

    size: of the surface, pixels.
    stride: pixels from row to row in the surface's memory.
    centre: of the ring, pixels.
    ring: from above.
    ground: what the slots are on.
    lane: least and greatest radius at which the ring colours pixels, world units.
    room: how far the content of a slot may be moved, inwards and outwards, world units.
    """

    size: tuple[int, int]
    stride: int
    centre: complex
    ring: FlatRing
    ground: Ground
    lane: tuple[float, float]
    room: tuple[float, float]


def atlas_key(canvas: Canvas, scene: Scene, k: int) -> AtlasKey:
    """The key of a ring on the backdrop: no pixel belongs to two rings."""
    camera, own = canvas.camera, scene.rings[k]
    ring = flat_rings(scene, camera.scale, canvas.theme)[k]
    border, (inwards, outwards) = _BORDER / camera.scale, ring.lane
    low = max((inwards + own.inner_radius) / 2.0, own.inner_radius - border)
    high = max((own.outer_radius + outwards) / 2.0, outwards - border)
    stride = canvas.surface.get_pitch() // 4
    return AtlasKey(canvas.size, stride, camera.centre, ring, ground_of(scene), (low, high), (0.0, 0.0))


class SlotAtlas:
    """The pictures of all contents that a ring's slots have shown.

    The colours are stored column after column. A column has the colours of all radii at one angle of one content, with spare
    rows for contents that are moved. 0 means that nothing stands there.
    """

    def __init__(self, key: AtlasKey) -> None:
        """Start without pictures."""
        scale, slot, slots = key.ring.scale, key.ring.shape, key.ring.slots
        self._ring, self._room, self._ground = key.ring, key.room, ground_list(key.ground, key.ring.theme, scale)
        outer = (slot.outer_radius + key.ring.shadow) * scale
        fine = _FINE if outer < _LARGE else _FINE // 2
        pitch = math.tau / slots
        self._columns = max(min(math.ceil(fine * outer * pitch), _MOST_COLUMNS // slots), 1)
        self._columns_around = self._columns * slots
        low, high = max(slot.inner_radius * scale - _BORDER, 0.0), outer + _BORDER
        rows = max(math.ceil((high - low) * fine), 1)
        self._fine = fine
        self._radii = (low + (np.arange(rows, dtype=np.float32) + 0.5) / fine).astype(np.float32)
        self._angles = (((np.arange(self._columns) + 0.5) / self._columns - 0.5) * pitch).astype(np.float32)
        self._half_pitch = pitch / 2.0
        inwards, outwards = (math.ceil(room * scale) for room in key.room)
        self._spare = fine * (inwards + outwards) + 1 if outwards else 0
        within = (max(low, key.lane[0] * scale), min(high, key.lane[1] * scale))
        self.band = BandKey(key.size, key.stride, key.centre, within, low, fine, (0, rows - 1), self._columns_around)
        """Of the pixels that show the ring."""
        wide = (max(low - inwards, 0.0), high + outwards)
        self.wide_band = self.band._replace(radii=wide, rows=(-fine * inwards, rows - 1 + fine * outwards))
        """Of those that show it while something is moved as far as there is room."""
        self._columns_of: dict[SlotContent, NDArray[np.int64]] = {}
        self._filled = 1  # columns in use, the first of them blank; the arrays are larger, and doubled when they are full
        self._atlas = np.zeros((1, rows + 2 * self._spare), dtype=np.uint32)
        self._contents: tuple[SlotContent, ...] = ()
        self._column_at = np.zeros(0, dtype=np.int64)

    @property
    def colours(self) -> NDArray[np.uint32]:
        """All colours, one column after the other."""
        return self._atlas.ravel()

    def columns(
        self, surface: pygame.Surface, phase: float, contents: tuple[SlotContent, ...], out: dict[int, float] | None = None
    ) -> NDArray[np.int64]:
        """For each column around the ring the index of its first row among `colours`; BLANK where nothing stands.

        surface: in whose format colours are stored. phase: middle angle of slot 0, radians; contents: of every slot. out: by
        slot, how far its content is moved outwards, world units, as far as there is room.
        """
        if out:
            around = self._arranged(surface, contents, out)
        else:
            if contents != self._contents:
                self._column_at, self._contents = self._arranged(surface, contents, {}), contents
            around = self._column_at
        turn = round((self._half_pitch - phase) / math.tau * self._columns_around) % self._columns_around
        return around[turn : turn + self._columns_around]

    def _arranged(self, surface: pygame.Surface, contents: tuple[SlotContent, ...], out: dict[int, float]) -> NDArray[np.int64]:
        """The index of each column's first row, from slot 0 on; twice around the ring, which saves a modulo."""
        for content in dict.fromkeys(contents):
            if content not in self._columns_of:
                self._columns_of[content] = self._added(surface, content)
        around = [self._columns_of[content] for content in contents]
        for slot, by in out.items():
            around[slot] = np.where(around[slot] == BLANK, BLANK, around[slot] - self._rows_of(by))
        return np.concatenate(around + around)

    def _rows_of(self, out: float) -> int:
        """The number of rows by which a slot's content is moved. out: world units."""
        inwards, outwards = self._room
        return round(min(max(out, -inwards), outwards) * self._ring.scale * self._fine)

    def _added(self, surface: pygame.Surface, content: SlotContent) -> NDArray[np.int64]:
        """Paint another content into the atlas; returns the index of the first row of each of its columns."""
        slot, ring, sector = DisplayList(), self._ring, self._ring.sector(0j, 0.0)
        for add in (add_shadow, add_content):
            add(slot, ring, content, sector)
        angles, column = np.unique(self._grouped(slot), return_inverse=True)
        bare = discs(self._ground)[-1].at(self._radii / np.float32(ring.scale)).T[:, :, None]
        picture = np.repeat(bare, len(angles), axis=2)
        paint_slot(picture, slot, PolarPixels(self._radii[:, None], angles[None, :]))
        colours = packed(surface, np.moveaxis(picture, 0, 2))
        colours = np.where(colours == packed(surface, np.moveaxis(bare, 0, 2)), 0, np.maximum(colours, 1)).T
        return self._first_rows(colours)[column]

    def _first_rows(self, colours: NDArray[np.uint32]) -> NDArray[np.int64]:
        """Add columns of colours; returns the indices of their first rows. Equal neighbours, and all blank ones, share one."""
        blank = ~colours.any(axis=1)
        differs = np.append(True, (colours[1:] != colours[:-1]).any(axis=1)) & ~blank
        first, self._filled = self._filled, self._filled + int(differs.sum())
        if self._filled > len(self._atlas):
            self._atlas = np.concatenate([self._atlas, np.zeros((self._filled, self._atlas.shape[1]), dtype=np.uint32)])
        self._atlas[first : self._filled, self._spare : self._spare + len(self._radii)] = colours[differs]
        number = first + np.cumsum(differs) - 1
        return np.where(blank, BLANK, number * self._atlas.shape[1] + self._spare)

    def _grouped(self, content: DisplayList) -> Floats:
        """The columns' angles; all that look the same, far from the slot's ends and from marks on it, have one angle."""
        slot, scale = self._ring.shape, self._ring.scale
        inner = max(slot.inner_radius * scale, 1.0)
        flat = slot.half_angle - math.asin(min((slot.half_width * scale + 1.0) / inner, 1.0))
        gap = slot.half_angle + (1.0 + self._ring.shadow * scale) / inner
        far, angles = np.abs(self._angles), self._angles
        plain = far < flat
        for _x, _y, _angle, radius, one, _outer, other, half_width in _bars(content):
            start, end = sorted((one, other))
            beside = half_width / radius + 2.0 / inner
            plain &= (angles < start - beside) | (angles > end + beside)
        if plain.any():
            angles = np.where(plain, angles[plain.argmax()], angles)
        return np.where(far > gap, np.float32(gap), angles).astype(np.float32)


def _bars(content: DisplayList) -> list["array[float]"]:
    """The numbers of all bars in a list."""
    return [own for code, _colour, _opacity, own in primitives(content.numbers) if code == Primitive.BAR]
