"""The colour of the ground and of what is around it, by the distance from the centre: a light middle, a glowing rim."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.drawing.palette import Colour, Theme
from game.drawing.raster.annulus import Floats

_INNER_GLOW, _INNER_REACH = 0.16, 0.035
"""Of the rim's light on the ground: its strength at the rim, and the distance in which it fades to 1/e, in ground radii."""
_OUTER_GLOW, _OUTER_REACH = 0.30, 0.09
"""The same of the light around the ground."""
_FARTHEST = 1.6
"""Ground radii from the centre to where there is no glow any more."""
_STEPS = 2048
"""Distances that are looked at for where a colour changes."""


class Disc(NamedTuple):
    """A disc of one colour; the smaller ones lie upon the larger ones.

    share: its radius, in ground radii.
    """

    share: float
    colour: Colour


def ground_colours(theme: Theme, shares: Floats) -> Floats:
    """Red, green and blue of the ground, 0 to 255, along one more axis. shares: distances from the centre, in ground radii."""
    shares = np.asarray(shares, dtype=np.float32)
    light = np.float32(1.0) + np.float32(theme.vignette) * (np.float32(0.5) - shares * shares)
    glow = np.float32(_INNER_GLOW * theme.glow) * np.exp((np.minimum(shares, 1.0) - 1.0) / np.float32(_INNER_REACH))
    return _towards(np.array(theme.ground, dtype=np.float32) * light[..., None], theme.rim, glow)


def around_colours(theme: Theme, shares: Floats) -> Floats:
    """The same beyond the rim, where shares are above 1."""
    shares = np.asarray(shares, dtype=np.float32)
    fading = (np.float32(_FARTHEST) - shares) / np.float32(_FARTHEST - 1.0)
    glow = np.float32(_OUTER_GLOW * theme.glow) * np.exp((1.0 - shares) / np.float32(_OUTER_REACH)) * np.clip(fading, 0.0, 1.0)
    background = np.broadcast_to(np.array(theme.background, dtype=np.float32), (*shares.shape, 3))
    return _towards(background, theme.rim, glow)


@lru_cache(maxsize=8)
def discs_of_ground(theme: Theme) -> tuple[Disc, ...]:
    """Discs, the largest first, that together show the ground's colours as exactly as a screen can."""
    shares = np.linspace(0.0, 1.0, _STEPS, dtype=np.float32)
    return _discs(shares, ground_colours(theme, shares))


@lru_cache(maxsize=8)
def discs_around(theme: Theme) -> tuple[Disc, ...]:
    """The same for what is around the ground."""
    shares = np.linspace(1.0, _FARTHEST, _STEPS, dtype=np.float32)
    return _discs(shares, around_colours(theme, shares))


def _discs(shares: Floats, colours: Floats) -> tuple[Disc, ...]:
    """A disc for every stretch of distances that share a colour."""
    whole = np.rint(colours).astype(np.int64)
    ends = np.append(np.flatnonzero((whole[1:] != whole[:-1]).any(axis=1)), len(whole) - 1)
    return tuple([Disc(float(shares[end]), _colour(whole[end].tolist())) for end in ends[::-1]])


def _towards(colours: Floats, other: Colour, share: Floats) -> Floats:
    """Colours some shares of the way to another colour."""
    return np.clip(colours + (np.array(other, dtype=np.float32) - colours) * share[..., None], 0.0, 255.0)


def _colour(channels: list[int]) -> Colour:
    """A colour of three channels."""
    red, green, blue = channels
    return red, green, blue
