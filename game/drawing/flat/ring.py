"""A ring on the screen at any angle: every pixel of its band looks up its colour by radius and by angle from the ring.

A turning ring costs two look-ups a pixel, however many bricks it has, and its edges stay as smooth as if drawn for that angle.
The light of this view stands over the centre: what stands in a slot throws its shadow outwards, so it turns with the ring.
"""

import math
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.flat.sector_colours import PolarPixels, Shadow, paint_light, paint_parts, paint_shadow
from game.drawing.ground.shades import ground_colours
from game.drawing.palette import Theme
from game.drawing.raster.annulus import Floats, annulus_pixels
from game.drawing.raster.pixels import packed, pixels_of
from game.drawing.slots.contents import ContentKind, SlotContent
from game.drawing.slots.parts import Bar, Part, SlotShape, height, parts, slot_shape
from physics import Ring

_FINE = 4
"""Rows and columns of a slot's picture per pixel of the screen; in large rings half as many are enough."""
_LARGE = 500.0
"""Pixels; outer radius from which a ring is large."""
_MOST_COLUMNS = 1 << 16
"""Columns of all slots' pictures of a ring together."""
_BORDER = 1.0
"""Pixels beyond the ring's faces that its border may colour."""
_SHADOW = 0.018
"""Length of the longest shadow, in shares of the ground's radius."""
_WEDGES = 256
"""Pieces of a circle that pixels are kept in, so that those where nothing stands cost nothing."""
_WEDGE = math.tau / _WEDGES
"""Radians."""
_AT_ONCE = 16384
"""Pixels drawn at once: memory for more would be asked of the system anew every time."""
_LOW_SHADOW, _SHADOW_PER_LAYER = 0.7, 0.1
"""Share of it that everything throws, and how much more with every layer of its height."""
_FLAT_KINDS = frozenset({ContentKind.EMPTY, ContentKind.GHOST})
"""What has no height, and so no shadow."""


class RingKey(NamedTuple):
    """What a ring's picture depends on, apart from its angle and its contents.

    size: of the surface, pixels.
    stride: pixels from row to row in the surface's memory.
    camera: a flat one.
    slot: the shape of the ring's slots.
    slots: how many there are.
    ground_radius: world units.
    shadow: length of the longest shadow of what stands there, world units.
    room: how far what stands there may be moved, inwards and outwards, world units.
    theme: the colours.
    """

    size: tuple[int, int]
    stride: int
    camera: Camera
    slot: SlotShape
    slots: int
    ground_radius: float
    shadow: float
    room: tuple[float, float]
    theme: Theme


class _BandPixels(NamedTuple):
    """The pixels between two radii, wedge after wedge.

    pixel: its index in the surface's memory. row, column: where in the atlas their radii, and around the ring their angles are.
    wedge_ends: numbers of the first pixels of all wedges, and behind the last.
    """

    pixel: NDArray[np.int64]
    row: NDArray[np.int32]
    column: NDArray[np.int32]
    wedge_ends: NDArray[np.int64]


def ring_key(
    canvas: Canvas, ring: Ring, tallest: int, ground_radius: float, lane: float, room: tuple[float, float] = (0.0, 0.0)
) -> RingKey:
    """The key of a ring on a 32-bit surface. tallest: layers of the highest stack that may ever stand there.

    lane: from the ring to the next one outwards, world units; no shadow goes beyond, so that rings share no pixels. room: as in
    `RingKey`.
    """
    stride, slot = canvas.surface.get_pitch() // 4, slot_shape(ring, tallest, 1.0 / canvas.camera.scale)
    shadow = min(_SHADOW * ground_radius, max(lane - least_lane(canvas.camera.scale), 0.0))
    return RingKey(canvas.size, stride, canvas.camera, slot, ring.count, ground_radius, shadow, room, canvas.theme)


def least_lane(scale: float) -> float:
    """World units between two rings that share no pixels. scale: pixels per world unit."""
    return (2.0 * _BORDER + 1.0) / scale


def shift_of(canvas: Canvas) -> int:
    """How far a canvas' offset moves pixels in the surface's memory."""
    across, down = canvas.offset
    return down * (canvas.surface.get_pitch() // 4) + across


class RingPicture:
    """One ring, ready to be drawn.

    The pictures of all contents that its slots have shown stand in an atlas, column after column: a column has the colours
    of all radii at one angle of one content, and spare rows for contents that are moved. A 0 leaves what is drawn already.
    """

    def __init__(self, key: RingKey) -> None:
        """Find the ring's pixels."""
        scale, slot = key.camera.scale, key.slot
        self._shadow, self._room = key.shadow, key.room
        outer = (slot.outer_radius + self._shadow) * scale
        fine = _FINE if outer < _LARGE else _FINE // 2
        pitch = math.tau / key.slots
        self._theme, self._slot, self._scale, self._ground_radius = key.theme, slot, scale, key.ground_radius
        self._columns = max(min(math.ceil(fine * outer * pitch), _MOST_COLUMNS // key.slots), 1)
        self._columns_around = self._columns * key.slots
        low = max(slot.inner_radius * scale - _BORDER, 0.0)
        rows = max(math.ceil((outer + _BORDER - low) * fine), 1)
        self._low, self._fine = low, fine
        self._radii = (low + (np.arange(rows, dtype=np.float32) + 0.5) / fine).astype(np.float32)
        self._angles = (((np.arange(self._columns) + 0.5) / self._columns - 0.5) * pitch).astype(np.float32)
        self._half_pitch = pitch / 2.0
        self._reach = slot.half_angle + (self._shadow * scale + 2.0) / max(slot.inner_radius * scale, 1.0) + _WEDGE
        inwards, outwards = (math.ceil(room * scale) for room in key.room)
        self._spare = fine * (inwards + outwards) + 1 if outwards else 0
        self._pixels = self._pixels_between(key, low, outer + _BORDER)
        self._wide = self._pixels
        if self._spare:
            self._wide = self._pixels_between(key, max(low - inwards, 0.0), outer + _BORDER + outwards)
        self._columns_of: dict[SlotContent, NDArray[np.int32]] = {}
        self._filled = 0  # columns of the atlas so far; it grows by leaps
        self._atlas = np.zeros((0, rows + 2 * self._spare), dtype=np.uint32)
        self._contents: tuple[SlotContent, ...] = ()
        self._column_at = np.zeros(0, dtype=np.int32)

    def draw(
        self,
        surface: pygame.Surface,
        phase: float,
        contents: tuple[SlotContent, ...],
        ground: pygame.Surface | None = None,
        before: tuple[SlotContent, ...] = (),
        shift: int = 0,
    ) -> None:
        """Draw the ring. phase: middle angle of slot 0, radians; contents: of every slot.

        ground: a surface like the other, which shows where nothing stands; without it what is drawn already stays. before:
        with a ground, the contents that the surface shows so far: only slots with others are drawn. shift: as `shift_of` says.
        """
        if contents != self._contents:
            self._column_at, self._contents = self._arranged(surface, contents, {}), contents
        under = pixels_of(surface if ground is None else ground)
        if ground is None:
            wanted, reach = [content.kind is not ContentKind.EMPTY for content in contents], self._reach
        else:
            wanted = [before[slot : slot + 1] != (content,) for slot, content in enumerate(contents)]
            reach = self._half_pitch + _WEDGE
        self._look_up(pixels_of(surface), under, self._pixels, (self._column_at, phase, wanted, reach), shift)

    def draw_moved(
        self, surface: pygame.Surface, phase: float, contents: tuple[SlotContent, ...], out: dict[int, float], shift: int = 0
    ) -> None:
        """Draw some slots alone, each moved outwards by so many world units, as far as there is room; the rest as above."""
        wanted, memory = [slot in out for slot in range(len(contents))], pixels_of(surface)
        column_at = self._arranged(surface, contents, out)
        self._look_up(memory, memory, self._wide, (column_at, phase, wanted, self._reach), shift)

    def _look_up(
        self,
        memory: NDArray[np.uint32],
        under: NDArray[np.uint32],
        pixels: _BandPixels,
        how: tuple[NDArray[np.int32], float, list[bool], float],
        shift: int,
    ) -> None:
        """Give pixels their colours, or where nothing stands those of another surface. how: as `_pixels_near` takes them."""
        around, phase, wanted, reach = how
        turn = round((self._half_pitch - phase) / math.tau * self._columns_around) % self._columns_around
        column_at, atlas = around[turn:], self._atlas.ravel()
        for some in self._pixels_near(pixels.wedge_ends, phase, np.array(wanted), reach):
            index = column_at.take(pixels.column[some])
            index += pixels.row[some]
            colours, pixel = atlas.take(index), pixels.pixel[some] + shift
            bare = np.flatnonzero(colours == 0)
            colours[bare] = under.take(pixel.take(bare))
            memory[pixel] = colours

    def _pixels_between(self, key: RingKey, low: float, high: float) -> _BandPixels:
        """The pixels between two radii, pixels."""
        found = annulus_pixels(key.size, key.stride, key.camera.centre, low, high)
        wedge = np.minimum((found.angle * np.float32(_WEDGES / math.tau)).astype(np.uint16), _WEDGES - 1)
        order = np.argsort(wedge, kind="stable")
        row = ((found.radius[order] - self._low) * self._fine + self._spare).astype(np.int32)
        column = (found.angle[order] * (self._columns_around / math.tau)).astype(np.int32)
        return _BandPixels(
            found.pixel[order],
            np.clip(row, 0, len(self._radii) + 2 * self._spare - 1),
            np.minimum(column, self._columns_around - 1),
            np.append(0, np.cumsum(np.bincount(wedge, minlength=_WEDGES))),
        )

    def _pixels_near(self, wedge_ends: NDArray[np.int64], phase: float, wanted: NDArray[np.bool_], reach: float) -> list[slice]:
        """The pixels of the wedges in which slots are wanted, in pieces. reach: radians on both sides of a slot's middle."""
        ends = [(0, int(wedge_ends[-1]))]
        if len(wanted) <= _WEDGES // 2:  # slots that are narrower than a wedge could be overlooked
            turns = (np.arange(_WEDGES + 1) * _WEDGE - phase) / (2.0 * self._half_pitch)
            slot = np.rint(turns)
            off = np.abs(turns - slot) * (2.0 * self._half_pitch)
            there = wanted[slot.astype(np.int64) % len(wanted)] & (off < reach)
            steps = np.flatnonzero(np.diff(there[:-1] | there[1:], prepend=False, append=False))
            ends = [(int(wedge_ends[a]), int(wedge_ends[b])) for a, b in zip(steps[::2], steps[1::2], strict=True)]
        return [slice(first, min(first + _AT_ONCE, end)) for start, end in ends for first in range(start, end, _AT_ONCE)]

    def _arranged(self, surface: pygame.Surface, contents: tuple[SlotContent, ...], out: dict[int, float]) -> NDArray[np.int32]:
        """Where in the atlas each column around the ring begins, from slot 0 on; twice around, which saves a modulo.

        out: of slots that are moved outwards, world units: their columns begin so much later.
        """
        for content in dict.fromkeys(contents):
            if content not in self._columns_of:
                self._columns_of[content] = self._added(surface, content)
        around = [self._columns_of[content] - self._rows_of(out.get(slot, 0.0)) for slot, content in enumerate(contents)]
        return np.concatenate(around + around)

    def _rows_of(self, out: float) -> int:
        """Rows of the atlas that a slot is moved by."""
        inwards, outwards = self._room
        return round(min(max(out, -inwards), outwards) * self._scale * self._fine)

    def _added(self, surface: pygame.Surface, content: SlotContent) -> NDArray[np.int32]:
        """Paint one more content into the atlas, and return where in it each column of a slot begins."""
        pile, theme = parts(content, self._slot, 0.0, self._theme), self._theme
        angles, column = np.unique(self._grouped(pile), return_inverse=True)
        pixels = PolarPixels(self._scale, self._radii[:, None], angles[None, :])
        bare = ground_colours(theme, self._radii / np.float32(self._scale * self._ground_radius)).T[:, :, None]
        picture = np.repeat(bare, len(angles), axis=2)
        solid = content.kind not in _FLAT_KINDS and theme.relief > 0.0
        if solid:
            reach = self._shadow * min(_LOW_SHADOW + _SHADOW_PER_LAYER * height(content), 1.0)
            paint_shadow(picture, self._slot, pixels, Shadow(reach, self._half_pitch, theme.shadow * theme.relief))
        paint_parts(picture, pile, self._slot, pixels)
        if solid:
            paint_light(picture, self._slot, pixels, theme.relief)
        colours = packed(surface, np.moveaxis(picture, 0, 2))
        colours = np.where(colours == packed(surface, np.moveaxis(bare, 0, 2)), 0, np.maximum(colours, 1))
        first, self._filled = self._filled, self._filled + len(angles)
        if self._filled > len(self._atlas):
            self._atlas = np.concatenate([self._atlas, np.zeros((self._filled, self._atlas.shape[1]), dtype=np.uint32)])
        self._atlas[first : self._filled, self._spare : self._spare + len(self._radii)] = colours.T
        return ((first + column) * self._atlas.shape[1]).astype(np.int32)

    def _grouped(self, pile: tuple[Part, ...]) -> Floats:
        """The columns' angles, one for all that look the same: far from the slot's ends and from what is painted on it."""
        slot, scale = self._slot, self._scale
        inner = max(slot.inner_radius * scale, 1.0)
        flat = slot.half_angle - math.asin(min((slot.half_width * scale + 1.0) / inner, 1.0))
        gap = slot.half_angle + (1.0 + self._shadow * scale) / inner
        far, angles = np.abs(self._angles), self._angles
        plain = far < flat
        for bar in [part for part in pile if isinstance(part, Bar)]:
            start, end = sorted((bar.inner[1], bar.outer[1]))
            beside = bar.half_width / bar.inner[0] + 2.0 / inner
            plain &= (angles < start - beside) | (angles > end + beside)
        if plain.any():
            angles = np.where(plain, angles[plain.argmax()], angles)
        return np.where(far > gap, np.float32(gap), angles).astype(np.float32)
