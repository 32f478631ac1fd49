"""The pixels between two circles, in polar coordinates about the circles' centre."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]


class AnnulusPixels(NamedTuple):
    """Every pixel of a surface whose middle lies between two circles.

    pixel: its index in the surface's memory, row after row.
    radius: of its middle, pixels.
    angle: of its middle, radians, counter-clockwise as in the world, in [0, 2 pi).
    """

    pixel: NDArray[np.int64]
    radius: Floats
    angle: Floats


def annulus_pixels(size: tuple[int, int], stride: int, centre: complex, inner: float, outer: float) -> AnnulusPixels:
    """The pixels whose middles lie between two radii. size, centre, radii: pixels; stride: pixels from row to row in memory."""
    width, height = size
    first = max(int(np.floor(centre.imag - outer)), 0)
    rows = np.arange(first, min(int(np.ceil(centre.imag + outer)) + 1, height), dtype=np.int64)
    rows = rows[np.abs(rows + 0.5 - centre.imag) <= outer]
    if not len(rows):
        return AnnulusPixels(np.zeros(0, np.int64), np.zeros(0, np.float32), np.zeros(0, np.float32))
    down = rows + 0.5 - centre.imag
    reach = np.sqrt(np.maximum(outer * outer - down * down, 0.0))
    hole = np.sqrt(np.maximum(inner * inner - down * down, 0.0))
    xs, ys = columns_between(rows, centre.real, hole, reach, width)
    across, up = xs + 0.5 - centre.real, centre.imag - ys - 0.5
    angle = np.arctan2(up, across).astype(np.float32)
    angle[angle < 0.0] += np.float32(2.0 * np.pi)
    return AnnulusPixels(ys * stride + xs, np.hypot(across, up).astype(np.float32), angle)


def columns_between(
    rows: NDArray[np.int64], middle: float, hole: NDArray[np.float64], reach: NDArray[np.float64], width: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Columns and rows of the pixels that are, in each row, at least `hole` and at most `reach` from a column, once each."""
    left, right = _spans(middle - reach, middle - hole, width), _spans(middle + hole, middle + reach, width)
    right = (np.maximum(right[0], left[1]), right[1])  # without a hole in the row the two would share a pixel
    ys = np.concatenate([np.repeat(rows, _lengths(span)) for span in (left, right)])
    return np.concatenate([_columns(span) for span in (left, right)]), ys


_Span = tuple[NDArray[np.int64], NDArray[np.int64]]
"""Per row, the first column and the one behind the last."""


def _spans(begin: NDArray[np.float64], end: NDArray[np.float64], width: int) -> _Span:
    """The columns whose middles lie, in each row, between two positions."""
    first = np.clip(np.ceil(begin - 0.5), 0, width).astype(np.int64)
    behind = np.clip(np.floor(end - 0.5) + 1, 0, width).astype(np.int64)
    return first, np.maximum(behind, first)


def _lengths(span: _Span) -> NDArray[np.int64]:
    """Pixels per row."""
    return np.asarray(np.maximum(span[1] - span[0], 0), dtype=np.int64)


def _columns(span: _Span) -> NDArray[np.int64]:
    """The columns of all rows, one row after the other."""
    lengths = _lengths(span)
    offsets = np.repeat(np.cumsum(lengths) - lengths, lengths)
    return np.arange(int(lengths.sum()), dtype=np.int64) - offsets + np.repeat(span[0], lengths)
