"""What is drawn on the ground: a protractor's marks at the rim, and a pattern of the level's choice.

Everything is a quadrilateral in polar coordinates, in shares of the ground's radius. So a pattern looks the same at every
size, and any camera and any painter can show it: no numpy is needed.
"""

import cmath
import math
from collections.abc import Callable, Iterator
from functools import cache
from typing import NamedTuple

PLAIN = "plain"
_TICKS, _LONG_EVERY = 72, 6
"""Marks at the rim, one every 5 degrees, and every so many a longer one."""
_TICK_OUTER, _TICK_LENGTH, _LONG_LENGTH, _TICK_WIDTH = 0.992, 0.012, 0.024, 0.0026
_OUTERMOST = 0.885
"""Radius at which the patterns end: the paddles' track begins there."""
_CIRCLES, _CHORDS = 8, 120
"""Circles, and the pieces of each."""
_RAYS, _RAY_STEPS, _RAY_PIECES, _RAY_INNER = 24, 10, 4, 0.06
"""Sectors, pieces of each outwards and across, and where they begin."""
_SEEDS, _GOLDEN = 420, math.pi * (3.0 - math.sqrt(5.0))
"""Dots of the pattern like a sunflower's seeds, and the angle from one to the next."""
_ARMS, _ARM_STEPS, _ARM_WIND = 7, 48, 2.4
"""Arms of the spiral, pieces of each, and the angle that an arm turns through, radians."""


class Mark(NamedTuple):
    """A quadrilateral of the ground.

    corners: in shares of the ground's radius. strength: share of the way from the ground's colour to that of its lines.
    """

    corners: tuple[complex, complex, complex, complex]
    strength: float


@cache
def marks(name: str) -> tuple[Mark, ...]:
    """The marks at the rim and a pattern. name: one of `NAMES`."""
    return (*_ticks(), *(() if name == PLAIN else _PATTERNS[name]()))


def _ticks() -> Iterator[Mark]:
    """A protractor's marks."""
    for number in range(_TICKS):
        angle, long = number * math.tau / _TICKS, number % _LONG_EVERY == 0
        half = (1.4 if long else 1.0) * _TICK_WIDTH / 2.0
        inner = _TICK_OUTER - (_LONG_LENGTH if long else _TICK_LENGTH)
        yield Mark(_box(inner, _TICK_OUTER, angle - half, angle + half), 2.2 if long else 1.3)


def _circles() -> Iterator[Mark]:
    """Circles about the centre, every second one stronger."""
    for circle in range(1, _CIRCLES + 1):
        radius, strong = circle / _CIRCLES * _OUTERMOST, circle % 2 == 0
        half = 0.0026 if strong else 0.0018
        for piece in range(_CHORDS):
            start, end = (math.tau * edge / _CHORDS for edge in (piece, piece + 1))
            yield Mark(_box(radius - half, radius + half, start, end), 0.9 if strong else 0.55)


def _rays() -> Iterator[Mark]:
    """Every second of the sectors around the centre, fainter towards the rim."""
    width = math.tau / _RAYS
    for sector in range(0, _RAYS, 2):
        for step in range(_RAY_STEPS):
            inner, outer = (_RAY_INNER + (_OUTERMOST - _RAY_INNER) * edge / _RAY_STEPS for edge in (step, step + 1))
            for piece in range(_RAY_PIECES):
                start, end = ((sector - 0.5 + edge / _RAY_PIECES) * width for edge in (piece, piece + 1))
                yield Mark(_box(inner, outer, start, end), 0.34 - 0.2 * step / _RAY_STEPS)


def _seeds() -> Iterator[Mark]:
    """Dots at golden angles, growing outwards, as in a sunflower."""
    for number in range(6, _SEEDS):
        share, angle = math.sqrt(number / _SEEDS), number * _GOLDEN
        middle, half = cmath.rect(share * _OUTERMOST, angle), 0.0035 + 0.0055 * share
        around = [middle + cmath.rect(half, angle + math.tau * corner / 8.0) for corner in range(8)]
        for a, b, c, d in ((0, 1, 2, 3), (4, 5, 6, 7), (3, 4, 7, 0)):
            yield Mark((around[a], around[b], around[c], around[d]), 0.75)


def _spiral() -> Iterator[Mark]:
    """Arms that wind outwards and grow wider; each piece is two quadrilaterals, so that its ends follow their circles."""
    half = math.tau / _ARMS / 4.0
    for arm in range(_ARMS):
        for step in range(_ARM_STEPS):
            inner, outer = (0.05 + (_OUTERMOST - 0.05) * edge / _ARM_STEPS for edge in (step, step + 1))
            inner_angle, outer_angle = (arm * math.tau / _ARMS + _ARM_WIND * math.sqrt(radius) for radius in (inner, outer))
            strength = 0.30 - 0.16 * step / _ARM_STEPS
            for right, left in ((-half, 0.0), (0.0, half)):
                outer_corners = cmath.rect(outer, outer_angle + right), cmath.rect(outer, outer_angle + left)
                inner_corners = cmath.rect(inner, inner_angle + left), cmath.rect(inner, inner_angle + right)
                yield Mark((*outer_corners, *inner_corners), strength)


def _box(inner: float, outer: float, start: float, end: float) -> tuple[complex, complex, complex, complex]:
    """A quadrilateral between two radii and two angles."""
    return cmath.rect(outer, start), cmath.rect(outer, end), cmath.rect(inner, end), cmath.rect(inner, start)


_PATTERNS: dict[str, Callable[[], Iterator[Mark]]] = {"rings": _circles, "rays": _rays, "dots": _seeds, "spiral": _spiral}
NAMES = (PLAIN, *_PATTERNS)
"""The names of all patterns."""
