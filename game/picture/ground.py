"""The ground and what is around it: a light middle, a glowing rim; from above and aslant."""

import cmath
import math
from functools import lru_cache

from game.drawing.camera import Camera
from game.drawing.ground.colours import FARTHEST, around_shade, ground_shade, mark_shade, rounded
from game.drawing.ground.measures import EDGE_SHADE, THICKNESS, Ground, rim_width, track_width
from game.drawing.ground.patterns import marks
from game.drawing.palette import Colour, Theme, mixed
from game.picture.display_list import DisplayList

_STOPS = 24
_AROUND = tuple([cmath.rect(1.0, math.tau * k / 72) for k in range(72)])
_RINGS_ASLANT = 24
"""Discs of one colour each that the ground aslant is made of, and what is around it."""


def add_ground(out: DisplayList, camera: Camera, theme: Theme, ground: Ground) -> None:
    """Add the ground with its pattern."""
    if camera.flat:
        _add_flat(out, camera, theme, ground)
    else:
        _add_aslant(out, camera, theme, ground)


def _add_flat(out: DisplayList, camera: Camera, theme: Theme, ground: Ground) -> None:
    """Add the ground from straight above."""
    radius = ground.radius * camera.scale
    out.gradient(camera.centre, radius * FARTHEST, _stops(theme, outside=True))
    out.gradient(camera.centre, radius, _stops(theme, outside=False))
    if ground.track is not None:
        out.circle(camera.centre, ground.track * camera.scale, track_width(camera) * camera.scale, theme.ground_line)
    _add_pattern(out, camera, theme, ground)
    width = rim_width(camera) * camera.scale
    out.circle(camera.centre, radius + width / 2.0, width, theme.rim)


def _add_aslant(out: DisplayList, camera: Camera, theme: Theme, ground: Ground) -> None:
    """Add the ground as a plate seen aslant: discs from the largest to the smallest, each in one colour."""
    outer = ground.radius + rim_width(camera)
    for k in range(_RINGS_ASLANT):
        share = 1.0 + (FARTHEST - 1.0) * (1.0 - k / _RINGS_ASLANT) ** 2
        out.polygon(_circle(camera, ground.radius * share), rounded(around_shade(theme, share)))
    below = [camera.project(point * outer, -THICKNESS * outer) for point in _AROUND]
    out.polygon(below, mixed(theme.rim, theme.background, EDGE_SHADE))
    out.polygon(_circle(camera, outer), theme.rim)
    for k in range(_RINGS_ASLANT):
        share = 1.0 - (k / _RINGS_ASLANT) ** 2
        out.polygon(_circle(camera, ground.radius * share), rounded(ground_shade(theme, share)))
    if ground.track is not None:
        track = _circle(camera, ground.track)
        out.line([*track, track[0]], track_width(camera) * camera.scale, theme.ground_line)
    _add_pattern(out, camera, theme, ground)


def _add_pattern(out: DisplayList, camera: Camera, theme: Theme, ground: Ground) -> None:
    """Add the marks at the rim and the pattern, a quadrilateral each."""
    for corners, colour in _coloured_marks(ground.pattern, theme):
        out.polygon(camera.pixels([corner * ground.radius for corner in corners]), colour)


@lru_cache(maxsize=8)
def _coloured_marks(pattern: str, theme: Theme) -> tuple[tuple[tuple[complex, ...], Colour], ...]:
    """The corners of every mark, in ground radii, and its colour."""
    drawn = marks(pattern)
    return tuple([(mark.corners, rounded(mark_shade(theme, abs(sum(mark.corners)) / 4.0, mark.strength))) for mark in drawn])


def _circle(camera: Camera, radius: float) -> list[complex]:
    """A circle on the ground, pixels."""
    return camera.pixels([point * radius for point in _AROUND])


@lru_cache(maxsize=32)
def _stops(theme: Theme, *, outside: bool) -> tuple[tuple[float, Colour], ...]:
    """The colours of the ground, or of what is around it, by the share of the radius. They lie closer near the rim."""
    if outside:
        shares = [1.0 + (FARTHEST - 1.0) * (k / _STOPS) ** 2 for k in range(_STOPS + 1)]
        return tuple([(share / FARTHEST, rounded(around_shade(theme, share))) for share in shares])
    shares = [1.0 - (1.0 - k / _STOPS) ** 2 for k in range(_STOPS + 1)]
    return tuple([(share, rounded(ground_shade(theme, share))) for share in shares])
