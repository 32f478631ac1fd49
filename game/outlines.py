"""The outlines of annular sectors, discs and arrows, in pixels about the origin, fine enough to look round.

Every shape has two: a fill, and an edge line that is drawn anti-aliased over the fill's border. A line one pixel wide
whose middle lies half a pixel inside the shape covers each border pixel by just the shape's share of it.
"""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.camera import Points

_EDGE_INSET = 0.5
_FILL_INSET = 0.9
_SAGITTA = 0.08
"""Pixels that a chord may lie inside its arc."""


class Outline(NamedTuple):
    """One shape, twice."""

    fill: Points
    edge: Points


@lru_cache(maxsize=4096)
def sector(inner: float, outer: float, half_angle: float, inset: float) -> Outline | None:
    """A sector about angle 0 with a border of `inset` taken off all round; None if nothing is left. Pixels, radians."""
    thickness = outer - inner - 2.0 * (inset + _FILL_INSET)
    if thickness <= 0.0 or not _wide_enough(inner, half_angle, inset + _FILL_INSET):
        return None
    return Outline(
        _sector(inner, outer, half_angle, inset + _FILL_INSET), _sector(inner, outer, half_angle, inset + _EDGE_INSET)
    )


@lru_cache(maxsize=256)
def truss(inner: float, outer: float, half_angle: float, inset: float) -> Points | None:
    """A zigzag between a sector's faces, the mark of what cannot break; None where it is too small to see."""
    low, high = inner + inset, outer - inset
    if high - low < 2.0 or not _wide_enough(inner, half_angle, inset):
        return None
    length = 2.0 * half_angle * (inner + outer) / 2.0 - 2.0 * inset
    count = max(2, round(length / (high - low)))
    radii = np.where(np.arange(count + 1) % 2 == 0, low, high)
    half = half_angle - inset / low
    return np.asarray(radii * np.exp(1j * np.linspace(-half, half, count + 1)), dtype=np.complex128)


@lru_cache(maxsize=64)
def disc(radius: float) -> Outline | None:
    """A full circle; None below a pixel."""
    if radius <= 1.0:
        return None
    circle = np.exp(2j * math.pi * np.arange(_arc_steps(radius, math.pi)) / _arc_steps(radius, math.pi))
    return Outline(circle * (radius - _FILL_INSET), circle * (radius - _EDGE_INSET))


def arrow(length: float, width: float) -> Points:
    """An arrow's head along angle 0, its tip at `length`."""
    return np.array([length, length - 1.7 * width + 1j * width, length - 1.25 * width, length - 1.7 * width - 1j * width])


def _wide_enough(inner: float, half_angle: float, inset: float) -> bool:
    """Whether insetting leaves something of the inner face."""
    return inset < inner and half_angle - math.asin(min(inset / (inner + inset), 1.0)) > 0.0


def _sector(inner: float, outer: float, half_angle: float, inset: float) -> Points:
    """The outline at a distance of `inset` inside the sector's four sides."""
    low, high = inner + inset, outer - inset
    half_high, half_low = half_angle - math.asin(inset / high), half_angle - math.asin(inset / low)
    outside = high * np.exp(1j * np.linspace(-half_high, half_high, _arc_steps(high, half_high) + 1))
    inside = low * np.exp(1j * np.linspace(half_low, -half_low, _arc_steps(low, half_low) + 1))
    return np.concatenate([outside, inside])


def _arc_steps(radius: float, half_angle: float) -> int:
    """Chords to draw an arc with."""
    if radius <= 2.0 * _SAGITTA:
        return 3
    return max(1, math.ceil(half_angle / math.acos(1.0 - _SAGITTA / radius)))
