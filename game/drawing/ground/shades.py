"""The ground's colours for many pixels at once."""

from functools import lru_cache

import numpy as np

from game.drawing.ground.colours import ground_shade, mark_shade
from game.drawing.ground.patterns import marks
from game.drawing.palette import Theme
from game.drawing.raster.annulus import Floats
from game.drawing.raster.arrays import Points

_SHARES = np.linspace(0.0, 1.25, 2561)
"""Distances that the colours are computed for, in ground radii; those between them lie between."""


def ground_colours(theme: Theme, shares: Floats) -> Floats:
    """Red, green and blue of the ground, 0 to 255, along one more axis. shares: distances from the centre, in ground radii."""
    return np.stack([np.interp(shares, _SHARES, channel) for channel in _table(theme)], axis=-1).astype(np.float32)


@lru_cache(maxsize=8)
def coloured_marks(pattern: str, theme: Theme) -> tuple[Points, Floats]:
    """The corners of a pattern's marks, four a row, in ground radii, and the colour of each mark."""
    drawn = marks(pattern)
    colours = [mark_shade(theme, abs(sum(mark.corners)) / 4.0, mark.strength) for mark in drawn]
    return np.array([mark.corners for mark in drawn]), np.array(colours, dtype=np.float32)


@lru_cache(maxsize=8)
def _table(theme: Theme) -> Floats:
    """The three channels of the ground's colours."""
    return np.array([ground_shade(theme, share) for share in _SHARES.tolist()], dtype=np.float32).T
