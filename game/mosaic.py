"""Quadrilaterals filled one over the other, their edges anti-aliased, on whatever a surface shows.

They are drawn several times finer than the screen and scaled down, tile by tile: a tile fits into the processor's cache, and
one that shows the same as the last time is not drawn again.
"""

from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

Pixels = NDArray[np.int32]

_TILE = np.array([256, 96], dtype=np.int32)
"""Columns and rows of a tile, pixels."""


class _Part(NamedTuple):
    """What a tile shows."""

    box: list[int]  # left, top, width and height on the surface: as much of the tile as there is something
    colours: NDArray[np.uint32]
    corners: Pixels  # in the pixels of the finer drawing, from the box's corner


class _Held(NamedTuple):
    """A tile's picture, in the upper left corner of a surface, and what it depends on."""

    key: tuple[object, ...]
    picture: pygame.Surface


class Mosaic:
    """Remembers every tile's last picture."""

    def __init__(self) -> None:
        """Start with nothing remembered."""
        self.canvas = pygame.Surface((1, 1), pygame.SRCALPHA, 32)
        self._held: dict[int, _Held] = {}
        self._size = (0, 0)

    def draw(self, surface: pygame.Surface, corners: Pixels, colours: NDArray[np.uint32], finer: int) -> None:
        """Fill convex quadrilaterals in their order.

        corners: columns and rows of four a row, in a drawing that has `finer` of them per pixel of the surface; colours: as
        32-bit surfaces with alpha store them, multiplied by their alpha.
        """
        if self._size != surface.get_size():
            self._held.clear()
            self._size = surface.get_size()
        for number, part in _parts(corners, colours, finer, self._size):
            key = (finer, *part.box, part.colours.tobytes(), part.corners.tobytes())
            held = self._held.get(number)
            if held is None or held.key != key:
                picture = pygame.Surface(_TILE.tolist(), pygame.SRCALPHA, 32) if held is None else held.picture
                held = self._held[number] = _Held(key, picture)
                self._fill(part, finer, picture)
            left, top, width, height = part.box
            surface.blit(held.picture, (left, top), (0, 0, width, height), special_flags=pygame.BLEND_PREMULTIPLIED)

    def _fill(self, part: _Part, finer: int, picture: pygame.Surface) -> None:
        """Draw a tile. Three corners are filled faster than four; what is covered of a pixel becomes its alpha."""
        width, height = part.box[2] * finer, part.box[3] * finer
        canvas, fill = self.canvas, pygame.draw.polygon
        if canvas.get_width() < width or canvas.get_height() < height:
            canvas = self.canvas = pygame.Surface((_TILE * finer).tolist(), pygame.SRCALPHA, 32)
        fill(canvas, 0, ((0, 0), (width, 0), (width, height)))
        fill(canvas, 0, ((0, 0), (width, height), (0, height)))
        for colour, (a, b, c, d) in zip(part.colours.tolist(), part.corners.tolist(), strict=True):
            fill(canvas, colour, (a, b, c))
            fill(canvas, colour, (a, c, d))
        box = (0, 0, *part.box[2:])
        pygame.transform.smoothscale(canvas.subsurface((0, 0, width, height)), part.box[2:], picture.subsurface(box))


def _parts(corners: Pixels, colours: NDArray[np.uint32], finer: int, size: tuple[int, int]) -> list[tuple[int, _Part]]:
    """Every tile in which there is something, with its number."""
    corners = _cut_the_short_way(corners)
    a, b, c, d = (corners[:, k] for k in range(4))
    low, high = (better(better(a, b), better(c, d)) for better in (np.minimum, np.maximum))
    tile, end = _TILE * finer, np.array(size, dtype=np.int32) * finer
    across = int(-(-end[0] // tile[0]))
    first = np.maximum(low, 0) // tile
    count = np.minimum(high, end - 1) // tile - first + 1
    count[((low >= end) | (high < 0)).any(axis=1)] = 0
    each = count[:, 0] * count[:, 1]
    row = np.repeat(np.arange(len(each)), each)
    step = np.arange(len(row)) - np.repeat(np.cumsum(each) - each, each)
    number = (first[row, 1] + step // count[row, 0]) * across + first[row, 0] + step % count[row, 0]
    order = np.argsort(number, kind="stable")
    row, number = row[order], number[order]
    starts = np.flatnonzero(np.diff(number, prepend=-1))
    numbers = number[starts]
    origin = (np.stack([numbers % across, numbers // across], axis=1) * tile).astype(np.int32)
    begin = np.maximum(np.minimum.reduceat(low[row], starts), origin) // finer
    behind = np.minimum(np.maximum.reduceat(high[row], starts) + finer, np.minimum(origin + tile, end)) // finer
    ends = np.append(starts, len(row))
    shifted = corners[row] - np.repeat(begin * finer, np.diff(ends), axis=0)[:, None]
    boxes, cuts, coloured = np.concatenate([begin, behind - begin], axis=1).tolist(), ends.tolist(), colours[row]
    return [
        (number, _Part(box, coloured[a:b], shifted[a:b]))
        for number, box, a, b in zip(numbers.tolist(), boxes, cuts, cuts[1:], strict=False)
    ]


def _cut_the_short_way(corners: Pixels) -> Pixels:
    """The same quadrilaterals, begun so that a cut from the first corner to the third crosses fewer rows than the other one.

    The two triangles have fewer rows together, and rows are what filling them costs.
    """
    height = np.abs(corners[:, :2, 1] - corners[:, 2:, 1])
    return np.where((height[:, 1] < height[:, 0])[:, None, None], np.roll(corners, -1, axis=1), corners)


def in_pixels(points: NDArray[np.complex128], finer: int) -> Pixels:
    """Columns and rows of a drawing, along one more axis. points: pixels, x to the right and y down."""
    return np.floor(points.view(np.float64) * finer).astype(np.int32).reshape(*points.shape, 2)
