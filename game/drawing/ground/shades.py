"""The colours of the ground's discs and marks as arrays, from `game.picture.ground`'s lists."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.drawing.palette import Theme
from game.drawing.raster.annulus import Floats
from game.drawing.raster.arrays import Points, Reals
from game.picture.display_list import DisplayList
from game.picture.ground.lists import pattern_list
from game.picture.ground.measures import Ground
from game.picture.primitives import Primitive, primitives, unpacked


class GroundDisc(NamedTuple):
    """A disc about the arena's centre.

    inner, outer: radii between which its colours are given, world units.
    colours: red, green and blue, 0 to 255, at equal distances from the inner radius to the outer one, a row for each.
    """

    inner: float
    outer: float
    colours: Reals

    def at(self, radii: "Floats | Reals") -> Floats:
        """Red, green and blue at distances from the centre, world units, along one more axis."""
        given = np.linspace(self.inner, self.outer, len(self.colours))
        return np.stack([np.interp(radii, given, channel) for channel in self.colours.T], axis=-1).astype(np.float32)


@lru_cache(maxsize=8)
def discs(ground: DisplayList) -> tuple[GroundDisc, ...]:
    """The discs of a ground, in their order: what is around it, and it."""
    found = [own for code, _, _, own in primitives(ground.numbers) if code == Primitive.GROUND_DISC]
    return tuple([GroundDisc(own[0], own[1], np.array(own[3:], dtype=np.float64).reshape(-1, 3)) for own in found])


@lru_cache(maxsize=8)
def coloured_marks(ground: Ground, theme: Theme) -> tuple[Points, Floats]:
    """The corners of a pattern's marks, four a row, world units, and the colour of each mark."""
    drawn = [(packed, own) for _, packed, _, own in primitives(pattern_list(ground, theme).numbers)]
    corners = np.array([own[1:] for _, own in drawn], dtype=np.float64).view(np.complex128)
    return corners, np.array([unpacked(packed) for packed, _ in drawn], dtype=np.float32)
