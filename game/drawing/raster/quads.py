"""Quadrilaterals filled one over the other, their edges anti-aliased, on whatever a surface shows.

They are drawn several times finer than the screen and scaled down, tile by tile: a tile fits into the processor's cache, and
one that shows the same as the last time is not drawn again.
"""

from struct import Struct
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.raster.pixels import packed

FinePixels = NDArray[np.complex64]
"""Columns and rows of a finer drawing: whole numbers, but filling takes floats faster than integers."""

_TILE = np.array([320, 100], dtype=np.int32)
"""Columns and rows of a tile, pixels: the quickest of those that were tried. Larger tiles leave the processor's cache, and with
smaller ones more quadrilaterals lie in two tiles."""
_CORNER = Struct("2f")
"""Column and row."""


class _Quads(NamedTuple):
    """The quadrilaterals that a tile shows.

    box: left, top, width and height of what they cover of the tile, pixels of the surface.
    colours: one of each.
    corners: four of each, as `_CORNER`, in columns and rows of the finer drawing from the box's corner.
    """

    box: list[int]
    colours: list[int]
    corners: bytes


class _Tile(NamedTuple):
    """A tile's picture, and what it depends on.

    finer: rows and columns of the drawing per pixel.
    quads: what it shows.
    picture: in the upper left corner of this surface, as large as their box.
    """

    finer: int
    quads: _Quads
    picture: pygame.Surface


class QuadRaster:
    """Fills quadrilaterals on surfaces; caches every tile's last picture."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self.canvas = pygame.Surface((1, 1), pygame.SRCALPHA, 32)
        self._flattened = self.canvas
        self._tiles: dict[int, _Tile] = {}
        self._size = (0, 0)

    def draw(
        self,
        surface: pygame.Surface,
        corners: FinePixels,
        colours: NDArray[np.uint32],
        finer: int,
        offset: tuple[int, int] = (0, 0),
    ) -> None:
        """Fill convex quadrilaterals in their order.

        corners: four a row, in a drawing with `finer` columns and rows per pixel of the surface; colours: as 32-bit surfaces
        with alpha store them, multiplied by their alpha. offset: pixels by which all is farther to the right and down.
        """
        if self._size != surface.get_size():
            self._tiles.clear()
            self._size = surface.get_size()
        for number, quads in _by_tile(corners, colours, finer, self._size):
            tile = self._tiles.get(number)
            if tile is None or tile[:2] != (finer, quads):
                picture = pygame.Surface(_TILE.tolist(), pygame.SRCALPHA, 32) if tile is None else tile.picture
                tile = self._tiles[number] = _Tile(finer, quads, picture)
                self._fill(quads, finer, picture)
            left, top, width, height = quads.box
            pixel = left + offset[0], top + offset[1]
            surface.blit(tile.picture, pixel, (0, 0, width, height), special_flags=pygame.BLEND_PREMULTIPLIED)

    def _fill(self, quads: _Quads, finer: int, picture: pygame.Surface) -> None:
        """Draw a tile; what is covered of a pixel becomes its alpha.

        Three corners are filled faster than four, and rows first, then columns, are scaled down faster than both at once.
        """
        width, height = quads.box[2:]
        right, bottom = width * finer, height * finer
        if finer > 1 and not self.canvas.get_rect().contains((0, 0, right, bottom)):
            self.canvas = pygame.Surface((_TILE * finer).tolist(), pygame.SRCALPHA, 32)
            self._flattened = pygame.Surface((finer * int(_TILE[0]), int(_TILE[1])), pygame.SRCALPHA, 32)
        canvas, fill = picture if finer == 1 else self.canvas, pygame.draw.polygon
        fill(canvas, 0, ((0, 0), (right, 0), (right, bottom)))  # Surface.fill leaves the processor's cache empty
        fill(canvas, 0, ((0, 0), (right, bottom), (0, bottom)))
        corner = _CORNER.iter_unpack(quads.corners)
        for colour, a, b, c, d in zip(quads.colours, corner, corner, corner, corner, strict=True):
            fill(canvas, colour, (a, b, c))
            fill(canvas, colour, (a, c, d))
        if finer == 1:
            return
        flattened = self._flattened.subsurface((0, 0, right, height))
        pygame.transform.smoothscale(canvas.subsurface((0, 0, right, bottom)), flattened.size, flattened)
        pygame.transform.smoothscale(flattened, (width, height), picture.subsurface((0, 0, width, height)))


def fill_quads(surface: pygame.Surface, corners: FinePixels, colours: NDArray[np.float32]) -> None:
    """Fill convex quadrilaterals on a 32-bit surface in their order, their edges not smoothed.

    corners: four a row, pixels; colours: red, green and blue, 0 to 255, of each.
    """
    begun = _begun_for_short_cuts(corners, np.ascontiguousarray(corners.imag.T))
    points, fill = _CORNER.iter_unpack(begun.tobytes()), pygame.draw.polygon
    for colour, a, b, c, d in zip(packed(surface, colours).tolist(), points, points, points, points, strict=True):
        fill(surface, colour, (a, b, c))
        fill(surface, colour, (a, c, d))


def _by_tile(corners: FinePixels, colours: NDArray[np.uint32], finer: int, size: tuple[int, int]) -> list[tuple[int, _Quads]]:
    """The quadrilaterals of every tile that shows some, with the tile's number."""
    apart = np.ascontiguousarray(corners.view(np.float32).reshape(-1, 4, 2).transpose(2, 1, 0))  # columns and rows first
    low, high = apart.min(axis=1).astype(np.int32), apart.max(axis=1).astype(np.int32)
    tile, end = _TILE[:, None] * finer, np.array(size, dtype=np.int32)[:, None] * finer
    across = int(-(-end[0, 0] // tile[0, 0]))
    first = np.maximum(low, 0) // tile
    count = np.minimum(high, end - 1) // tile - first + 1
    each = np.where(((low < end) & (high >= 0)).all(axis=0), count[0] * count[1], 0)
    row = np.repeat(np.arange(len(each)), each)
    step = np.arange(len(row)) - np.repeat(np.cumsum(each) - each, each)
    down, aside = np.divmod(step, count[0, row])
    number = (first[1, row] + down) * across + first[0, row] + aside
    order = np.argsort(number, kind="stable")
    row, number = row[order], number[order]
    starts = np.flatnonzero(np.diff(number, prepend=-1))
    numbers = number[starts]
    origin = (np.stack([numbers % across, numbers // across]) * tile).astype(np.int32)
    begin = np.maximum(np.minimum.reduceat(low[:, row], starts, axis=1), origin) // finer
    behind = np.minimum(np.maximum.reduceat(high[:, row], starts, axis=1) + finer, np.minimum(origin + tile, end)) // finer
    cuts = [*starts.tolist(), len(row)]
    corner = ((begin[0] + 1j * begin[1]) * finer).astype(np.complex64)
    shifted = _begun_for_short_cuts(corners, apart[1]).take(row, axis=0) - np.repeat(corner, np.diff(cuts))[:, None]
    boxes, shades = np.concatenate([begin, behind - begin]).T.tolist(), colours[row].tolist()
    memory, size_of_one = shifted.tobytes(), 4 * _CORNER.size
    return [
        (number, _Quads(box, shades[a:b], memory[a * size_of_one : b * size_of_one]))
        for number, box, a, b in zip(numbers.tolist(), boxes, cuts, cuts[1:], strict=False)
    ]


def _begun_for_short_cuts(corners: FinePixels, rows: NDArray[np.float32]) -> FinePixels:
    """The same quadrilaterals, each begun at the corner whose diagonal crosses fewer rows.

    The raster cuts them in two along the diagonal from the first corner to the third. The fewer rows that crosses, the fewer
    the two triangles have together, and rows are what filling costs. rows: of the corners, first to fourth.
    """
    height = np.abs(rows[:2] - rows[2:])
    begun = corners.copy()
    other = np.flatnonzero(height[1] < height[0])
    begun[other] = corners[other][:, [1, 2, 3, 0]]
    return begun


def fine_pixels(points: NDArray[np.complex128], finer: int) -> FinePixels:
    """Columns and rows of a drawing. points: pixels, x to the right and y down."""
    return np.floor(points.view(np.float64) * finer).astype(np.float32).view(np.complex64)
