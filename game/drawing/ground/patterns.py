"""What is drawn on the ground: a protractor's marks at the rim, and a pattern of the level's choice.

Everything is a quadrilateral in polar coordinates, in shares of the ground's radius. So a pattern looks the same at every
size, and any camera can show it.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from game.drawing.raster.arrays import Points, Reals

PLAIN = "plain"
_TICKS, _LONG_EVERY = 72, 6
"""Marks at the rim, one every 5 degrees, and every so many a longer one."""
_TICK_OUTER, _TICK_LENGTH, _LONG_LENGTH, _TICK_WIDTH = 0.992, 0.012, 0.024, 0.0026
_OUTERMOST = 0.885
"""Radius at which the patterns end: the paddles' track begins there."""
_CIRCLES = 8
_RAYS, _RAY_STEPS, _RAY_INNER = 24, 10, 0.06
_SEEDS, _GOLDEN = 420, math.pi * (3.0 - math.sqrt(5.0))
"""Dots of the pattern like a sunflower's seeds, and the angle from one to the next."""
_ARMS, _ARM_STEPS, _ARM_WIND = 7, 48, 2.4
"""Arms of the spiral, pieces of each, and the angle that an arm turns through, radians."""


class Marks(NamedTuple):
    """Quadrilaterals of the ground, one a row.

    corners: four each, in shares of the ground's radius.
    strength: share of the way from the ground's colour to that of its lines.
    """

    corners: Points
    strength: Reals


@cache
def marks(name: str) -> Marks:
    """The marks at the rim and a pattern. name: one of `NAMES`."""
    parts = [_ticks(), *([] if name == PLAIN else [_PATTERNS[name]()])]
    return Marks(np.concatenate([part.corners for part in parts]), np.concatenate([part.strength for part in parts]))


def _ticks() -> Marks:
    """A protractor's marks."""
    angles = np.arange(_TICKS) * (math.tau / _TICKS)
    long = np.arange(_TICKS) % _LONG_EVERY == 0
    inner = _TICK_OUTER - np.where(long, _LONG_LENGTH, _TICK_LENGTH)
    half = np.where(long, 1.4, 1.0) * _TICK_WIDTH / 2.0
    return Marks(_boxes(inner, np.full(_TICKS, _TICK_OUTER), angles - half, angles + half), np.where(long, 2.2, 1.3))


def _circles() -> Marks:
    """Circles about the centre, every second one stronger."""
    around = np.linspace(0.0, math.tau, 121)
    radius = np.repeat(np.arange(1, _CIRCLES + 1) / _CIRCLES * _OUTERMOST, len(around) - 1)
    start, end = np.tile(around[:-1], _CIRCLES), np.tile(around[1:], _CIRCLES)
    strong = np.repeat(np.arange(1, _CIRCLES + 1) % 2 == 0, len(around) - 1)
    half = np.where(strong, 0.0026, 0.0018)
    return Marks(_boxes(radius - half, radius + half, start, end), np.where(strong, 0.9, 0.55))


def _rays() -> Marks:
    """Every second of the sectors around the centre, fainter towards the rim."""
    edges = np.linspace(_RAY_INNER, _OUTERMOST, _RAY_STEPS + 1)
    width = math.tau / _RAYS
    pieces = np.linspace(-width / 2.0, width / 2.0, 5)
    sector, step, piece = (index.ravel() for index in np.indices((_RAYS // 2, _RAY_STEPS, len(pieces) - 1)))
    middle = sector * 2.0 * width
    boxes = _boxes(edges[step], edges[step + 1], middle + pieces[piece], middle + pieces[piece + 1])
    return Marks(boxes, 0.34 - 0.2 * step / _RAY_STEPS)


def _seeds() -> Marks:
    """Dots at golden angles, growing outwards, as in a sunflower."""
    number = np.arange(6, _SEEDS)
    share = np.sqrt(number / _SEEDS)
    middle = share * _OUTERMOST * np.exp(1j * number * _GOLDEN)
    half = 0.0035 + 0.0055 * share
    corners = half[:, None] * np.exp(1j * (np.angle(middle)[:, None] + math.tau * np.arange(8) / 8.0))
    left = middle[:, None] + corners[:, [0, 1, 2, 3]]
    right = middle[:, None] + corners[:, [4, 5, 6, 7]]
    across = middle[:, None] + corners[:, [3, 4, 7, 0]]
    return Marks(np.concatenate([left, right, across]), np.full(3 * len(number), 0.75))


def _spiral() -> Marks:
    """Arms that wind outwards and grow wider."""
    edges = np.linspace(0.05, _OUTERMOST, _ARM_STEPS + 1)
    bend = _ARM_WIND * np.sqrt(edges)
    half = math.tau / _ARMS / 4.0
    arm, step = (index.ravel() for index in np.indices((_ARMS, _ARM_STEPS)))
    turn = arm * math.tau / _ARMS
    inner, outer = turn + bend[step], turn + bend[step + 1]
    corners = [
        edges[step + 1] * np.exp(1j * (outer - half)),
        edges[step + 1] * np.exp(1j * (outer + half)),
        edges[step] * np.exp(1j * (inner + half)),
        edges[step] * np.exp(1j * (inner - half)),
    ]
    halves = [np.stack([a, (a + b) / 2.0 * _bulge(half), (c + d) / 2.0 * _bulge(half), d], axis=1) for a, b, c, d in [corners]]
    halves += [np.stack([(a + b) / 2.0 * _bulge(half), b, c, (c + d) / 2.0 * _bulge(half)], axis=1) for a, b, c, d in [corners]]
    return Marks(np.concatenate(halves), np.tile(0.30 - 0.16 * step / _ARM_STEPS, 2))


def _bulge(half: float) -> float:
    """What the middle of a chord is multiplied by to lie on its arc. half: half the arc's angle."""
    return 1.0 / math.cos(half)


_PATTERNS: dict[str, Callable[[], Marks]] = {"rings": _circles, "rays": _rays, "dots": _seeds, "spiral": _spiral}
NAMES = (PLAIN, *_PATTERNS)
"""The names of all patterns."""


def _boxes(inner: Reals, outer: Reals, start: Reals, end: Reals) -> Points:
    """Quadrilaterals between two radii and two angles."""
    return np.stack(
        [outer * np.exp(1j * start), outer * np.exp(1j * end), inner * np.exp(1j * end), inner * np.exp(1j * start)], axis=1
    )
