"""The pixels that a ring may colour, and the row of the ring's pictures in which each of them looks up its colour."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.raster.annulus import annulus_pixels


class BandKey(NamedTuple):
    """What the pixels of a band depend on.

    size: of the surface, pixels.
    stride: pixels from row to row in the surface's memory.
    centre: of the ring, pixels.
    radii: the least and the greatest distance of a pixel from the centre, pixels.
    low: radius at which the first row of the slots' pictures begins, pixels.
    fine: rows of these pictures per pixel.
    rows: the first and the last row, with spare ones on both sides for slots whose content is moved.
    columns: number of columns of these pictures, all around the ring.
    """

    size: tuple[int, int]
    stride: int
    centre: complex
    radii: tuple[float, float]
    low: float
    fine: int
    rows: tuple[int, int]
    columns: int


class BandPixels(NamedTuple):
    """The pixels of a band, column after column: those of neighbouring columns are one slice.

    pixels: for each its index in the surface's memory, and its row in the slots' pictures. Rows below 0 or beyond the last one
    are for pixels that only a moved content reaches.
    each: number of pixels of every column.
    first: index of the first pixel of every column, and at last the number of all pixels.
    """

    pixels: NDArray[np.int32]
    each: NDArray[np.int64]
    first: NDArray[np.int64]


def band_pixels(key: BandKey) -> BandPixels:
    """The pixels of a band."""
    found = annulus_pixels(key.size, key.stride, key.centre, *key.radii)
    column = np.minimum((found.angle * np.float32(key.columns / (2.0 * np.pi))).astype(np.uint16), key.columns - 1)
    order = np.argsort(column, kind="stable")
    count = np.bincount(column, minlength=key.columns)
    row = np.clip(np.floor((found.radius[order] - np.float32(key.low)) * np.float32(key.fine)), *key.rows)
    pixels = np.stack([found.pixel[order].astype(np.int32), row.astype(np.int32)])
    return BandPixels(pixels, count, np.append(0, np.cumsum(count)))
