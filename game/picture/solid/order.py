"""Which of many blocks hides which: an order to draw them in, from back to front, that is right from every angle.

All blocks stand on the ground, so one hides another exactly if a ray along the ground, away from the point below the eye,
meets its foot first. Blocks of one ring are parted by lines through the centre: the one nearer in angle to the eye is in
front. Two rings are parted by a circle: what a ray meets of the outer ring before the circle is in front of the inner ring,
what it meets after, behind. So the far parts of the rings come first, from the outermost inwards, then the near parts, from
the innermost outwards. Blocks are not quite the convex wedges this asks for; `widest` says how narrow is narrow enough. A
slot that is wider is divided into wedges, and those of its wedges that are near come apart from those that are far.
"""

import cmath
import math
from bisect import bisect_left
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from game.drawing.camera import Camera
from game.picture.slots.parts import WHOLE
from physics import Ring

_WIDEST, _NARROWEST = math.radians(12.0), math.radians(2.0)


class RankedRing(NamedTuple):
    """A ring among the others.

    ring: its index. rank: counted from the centre, 1 and up.
    parting: radius of a circle between it and the next ring towards the centre, world units.
    widest: half angle of the widest wedge that its slots may be divided into, radians.
    """

    ring: int
    rank: int
    parting: float
    widest: float


class Span(NamedTuple):
    """Wedges of a slot that are drawn together. The order of spans is that of drawing.

    rank: of the ring, negative for the far parts. nearness: of the slot's middle, or of a ball or a piece, -1 farthest to 1.
    ring, slot: indices. first, last: wedges; of a whole ring the last may be before the first.
    """

    rank: float
    nearness: float
    ring: int
    slot: int
    first: int
    last: int


def ranked(rings: Sequence[Ring]) -> tuple[RankedRing, ...]:
    """The rings from the innermost outwards."""
    return _ranked(tuple([(ring.radius, ring.half_width) for ring in rings]))


@lru_cache(maxsize=64)
def _ranked(sizes: tuple[tuple[float, float], ...]) -> tuple[RankedRing, ...]:
    """The rings from the innermost outwards. sizes: their radii and half widths."""
    found, below = [], 0.0
    for rank, k in enumerate(sorted(range(len(sizes)), key=lambda k: sizes[k][0]), 1):
        radius, half_width = sizes[k]
        found.append(RankedRing(k, rank, (below + radius - half_width) / 2.0, widest(radius - half_width, below)))
        below = radius + half_width
    return tuple(found)


def widest(inner: float, below: float) -> float:
    """Half angle up to which the blocks of a ring do not reach below a tangent of the next ring towards the centre.

    inner: radius of their inner faces; below: of the outer faces of that next ring, 0 if there is none.
    """
    return min(max(math.acos(min(below / inner, 1.0)), _NARROWEST), _WIDEST)


def back_to_front(rings: Sequence[Ring], wedges: Sequence[int], camera: Camera) -> list[Span]:
    """All slots, or parts of them, in the order to draw them. wedges: that the slots of each ring are divided into.

    What stands in a slot is drawn from the lowest prism to the highest, as the eye is above them.
    """
    sine, spans = math.sin(camera.tilt), []
    for k, rank, parting, _ in ranked(rings):
        turn, limit = cmath.rect(1.0, rings[k].phase - camera.azimuth), camera.closeness * parting
        bearings = [bearing * turn for bearing in _bearings(rings[k].count)]
        if wedges[k] == 1:
            spans += [
                Span(rank if -sine * bearing.imag > limit else -rank, -bearing.imag, k, slot, 0, 0)
                for slot, bearing in enumerate(bearings)
            ]
            continue
        middles = _middles(rings[k].half_angle, wedges[k])
        for slot, bearing in enumerate(bearings):
            near = tuple([-sine * (bearing * middle).imag > limit for middle in middles])
            spans += [
                Span(rank if near[first] else -rank, -bearing.imag, k, slot, first, last)
                for first, last in _runs(near, closed=rings[k].half_angle >= WHOLE)
            ]
    spans.sort()
    return spans


def among_rings(positions: Sequence[complex], rings: Sequence[Ring], camera: Camera) -> list[tuple[float, float]]:
    """Rank and nearness, as in `Span`, of balls and of pieces in the air.

    They come after those parts of a ring that they are above.
    """
    sine, closeness, turning = math.sin(camera.tilt), camera.closeness, camera.turning
    inner, outer = sorted([ring.inner_radius for ring in rings]), sorted([ring.outer_radius for ring in rings])
    found = []
    for position in positions:
        distance = abs(position)
        nearness = -(position * turning).imag / distance if distance else 0.0
        if sine * nearness > closeness * distance:
            found.append((bisect_left(inner, distance) + 0.5, nearness))
        else:
            found.append((-bisect_left(outer, distance) - 0.5, nearness))
    return found


@lru_cache(maxsize=256)
def _bearings(count: int) -> tuple[complex, ...]:
    """The unit vector towards the middle of every slot of a ring with phase 0."""
    return tuple([cmath.rect(1.0, math.tau * slot / count) for slot in range(count)])


@lru_cache(maxsize=256)
def _middles(half_angle: float, wedges: int) -> tuple[complex, ...]:
    """The unit vector towards the middle of every wedge of a slot at angle 0."""
    return tuple([cmath.rect(1.0, half_angle * ((2.0 * wedge + 1.0) / wedges - 1.0)) for wedge in range(wedges)])


@lru_cache(maxsize=256)
def _runs(near: tuple[bool, ...], *, closed: bool) -> tuple[tuple[int, int], ...]:
    """The first and the last wedge of each run of near and of far ones. closed: whether the last wedge meets the first."""
    count = len(near)
    begins = [k for k in range(count) if near[k] != near[k - 1] or (k == 0 and not closed)]
    if not begins:
        return ((0, count - 1),)
    return tuple([(first, (behind - 1) % count) for first, behind in zip(begins, [*begins[1:], begins[0]], strict=True)])
