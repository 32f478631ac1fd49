"""A ring on the screen at any angle: every pixel of its band looks up its colour by radius and by angle from the ring.

Its edges are as smooth as if they were drawn for that angle, and the cost does not depend on the number of bricks. On the
cached backdrop only the changed pixels are looked up again: after a small turn most pixels inside of a brick keep their colour.
"""

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.canvas import Canvas
from game.drawing.flat.band_pixels import BandPixels, band_pixels
from game.drawing.flat.slot_atlas import BLANK, SlotAtlas
from game.drawing.raster.pixels import pixels_of
from game.picture.slots.contents import SlotContent


class BackdropRing:
    """A ring on a backdrop, with the columns that the backdrop shows at present."""

    def __init__(self, atlas: SlotAtlas, ground: pygame.Surface) -> None:
        """Find its pixels. atlas: pictures of its slots; ground: the backdrop without rings."""
        self._atlas, self._band = atlas, band_pixels(atlas.band)
        bare = pixels_of(ground).take(self._band.pixels[0])
        self._pixels = np.concatenate([self._band.pixels, bare.view(np.int32)[None]])  # one array: looked up together
        self._shown = np.full(len(self._band.each), -1, dtype=np.int64)

    def draw(self, backdrop: pygame.Surface, phase: float, contents: tuple[SlotContent, ...]) -> None:
        """Draw the columns that have changed. phase, contents: as in `SlotAtlas.columns`."""
        columns = self._atlas.columns(backdrop, phase, contents)
        changed = columns != self._shown
        if not changed.any():
            return
        self._shown = columns
        pixel, row, ground = _of_columns(self._pixels, self._band, changed)
        colours = _looked_up(self._atlas, columns, self._band, changed, row)
        np.copyto(colours, ground.view(np.uint32), where=colours == 0)
        pixels_of(backdrop)[pixel.astype(np.int64)] = colours


def draw_over(canvas: Canvas, band: BandPixels, atlas: SlotAtlas, columns: NDArray[np.int64]) -> None:
    """Draw a ring over what a canvas shows already. columns: as `SlotAtlas.columns` returns them."""
    there = columns != BLANK
    if not there.any():
        return
    pixel, row = _of_columns(band.pixels, band, there)
    colours = _looked_up(atlas, columns, band, there, row)
    drawn = np.flatnonzero(colours)
    across, down = canvas.offset
    shift = down * (canvas.surface.get_pitch() // 4) + across
    pixels_of(canvas.surface)[pixel.take(drawn).astype(np.int64) + shift] = colours.take(drawn)


def _of_columns(pixels: NDArray[np.int32], band: BandPixels, wanted: NDArray[np.bool_]) -> NDArray[np.int32]:
    """The data of the pixels of some columns of a band. pixels: the data of all pixels; wanted: whether, for each column."""
    steps = np.flatnonzero(wanted[1:] != wanted[:-1]) + 1
    first = [0] if wanted[0] else []
    ends = [*first, *band.first[steps].tolist(), *([pixels.shape[1]] if wanted[-1] else [])]
    return np.concatenate([pixels[:, start:end] for start, end in zip(ends[::2], ends[1::2], strict=True)], axis=1)


def _looked_up(
    atlas: SlotAtlas, columns: NDArray[np.int64], band: BandPixels, wanted: NDArray[np.bool_], row: NDArray[np.int32]
) -> NDArray[np.uint32]:
    """The colours of some columns' pixels, 0 where nothing stands. row: row of each pixel in the atlas."""
    index = np.repeat(columns[wanted], band.each[wanted])
    index += row
    return atlas.colours.take(index)
