"""The ground and what is around it: a light middle, a glowing rim; from above and aslant."""

import cmath
import math
from functools import lru_cache
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.ground.patterns import marks
from game.drawing.palette import Colour, Theme, mixed
from game.picture.display_list import DisplayList

_INNER_GLOW, _INNER_REACH = 0.16, 0.035
_OUTER_GLOW, _OUTER_REACH = 0.30, 0.09
"""Of the rim's light on the ground and around it: as in `game.drawing.ground.colours`, whose arrays no browser has."""
_FARTHEST = 1.6
_STOPS = 24
_AROUND = tuple([cmath.rect(1.0, math.tau * k / 72) for k in range(72)])
_RINGS_ASLANT = 14
_THICKNESS = 0.03
"""Of the ground seen aslant, in ground radii."""
_RIM, _LEAST_RIM = 0.07, 2.0
"""Width of the rim: world units, and pixels."""
_TRACK, _TRACK_PIXELS = 0.03, 1.0
"""The paddles' track is so many world units wide, and so many pixels more."""


class PatternedGround(NamedTuple):
    """What the ground is. radius: world units. track: of the circle that the paddles run on. pattern: its name."""

    radius: float
    track: float
    pattern: str


def ground_colour(theme: Theme, share: float) -> Colour:
    """The ground's colour at a distance from the centre in ground radii, up to 1."""
    light = 1.0 + theme.vignette * (0.5 - share * share)
    glow = _INNER_GLOW * theme.glow * math.exp((min(share, 1.0) - 1.0) / _INNER_REACH)
    lit = [min(max(channel * light, 0.0), 255.0) for channel in theme.ground]
    red, green, blue = (round(own + (other - own) * glow) for own, other in zip(lit, theme.rim, strict=True))
    return red, green, blue


def around_colour(theme: Theme, share: float) -> Colour:
    """The colour beyond the rim, where the share is above 1."""
    fading = min(max((_FARTHEST - share) / (_FARTHEST - 1.0), 0.0), 1.0)
    return mixed(theme.background, theme.rim, _OUTER_GLOW * theme.glow * math.exp((1.0 - share) / _OUTER_REACH) * fading)


def add_ground(out: DisplayList, camera: Camera, theme: Theme, ground: PatternedGround) -> None:
    """Add the ground with its pattern."""
    if camera.flat:
        _add_flat(out, camera, theme, ground)
    else:
        _add_aslant(out, camera, theme, ground)


def pattern_colour(theme: Theme, share: float, strength: float) -> Colour:
    """The colour of a mark on the ground, at a distance from the centre in ground radii."""
    own = zip(ground_colour(theme, share), theme.ground_line, theme.ground, strict=True)
    red, green, blue = (round(min(max(channel + (line - plain) * strength, 0.0), 255.0)) for channel, line, plain in own)
    return red, green, blue


def _add_flat(out: DisplayList, camera: Camera, theme: Theme, ground: PatternedGround) -> None:
    """Add the ground from straight above."""
    radius = ground.radius * camera.scale
    out.gradient(camera.centre, radius * _FARTHEST, _stops(theme, outside=True))
    out.gradient(camera.centre, radius, _stops(theme, outside=False))
    out.circle(camera.centre, ground.track * camera.scale, _TRACK * camera.scale + _TRACK_PIXELS, theme.ground_line)
    _add_pattern(out, camera, theme, ground)
    width = max(_RIM * camera.scale, _LEAST_RIM)
    out.circle(camera.centre, radius + width / 2.0, width, theme.rim)


def _add_aslant(out: DisplayList, camera: Camera, theme: Theme, ground: PatternedGround) -> None:
    """Add the ground as a plate seen aslant: discs from the largest to the smallest, each in one colour."""
    for k in range(_RINGS_ASLANT):
        share = _FARTHEST - (_FARTHEST - 1.0) * k / _RINGS_ASLANT
        out.polygon(_circle(camera, ground.radius * share), around_colour(theme, share))
    below = [camera.project(point * ground.radius, -_THICKNESS * ground.radius) for point in _AROUND]
    out.polygon(below, mixed(theme.rim, theme.background, 0.55))
    for k in range(_RINGS_ASLANT):
        share = 1.0 - (k / _RINGS_ASLANT) ** 2
        out.polygon(_circle(camera, ground.radius * share), ground_colour(theme, share))
    track = _circle(camera, ground.track)
    out.line([*track, track[0]], _TRACK * camera.scale + _TRACK_PIXELS, theme.ground_line)
    _add_pattern(out, camera, theme, ground)
    rim = _circle(camera, ground.radius)
    out.line([*rim, rim[0]], max(_RIM * camera.scale, _LEAST_RIM), theme.rim)


def _add_pattern(out: DisplayList, camera: Camera, theme: Theme, ground: PatternedGround) -> None:
    """Add the marks at the rim and the pattern, a quadrilateral each."""
    turning, sine, cosine = camera.turning * ground.radius, math.sin(camera.tilt), math.cos(camera.tilt)
    scale, nearer, x, y = camera.scale, camera.closeness * sine, camera.centre.real, camera.centre.imag
    for corners, colour in _coloured_marks(ground.pattern, theme):
        pixels = []
        for corner in corners:
            turned = corner * turning
            there = scale / (1.0 + nearer * turned.imag)
            pixels.append(complex(x + turned.real * there, y - turned.imag * cosine * there))
        out.polygon(pixels, colour)


@lru_cache(maxsize=8)
def _coloured_marks(pattern: str, theme: Theme) -> tuple[tuple[tuple[complex, ...], Colour], ...]:
    """The corners of every mark, in ground radii, and its colour."""
    drawn = marks(pattern)
    return tuple([(mark.corners, pattern_colour(theme, abs(sum(mark.corners)) / 4.0, mark.strength)) for mark in drawn])


def _circle(camera: Camera, radius: float) -> list[complex]:
    """A circle on the ground, pixels."""
    return [camera.project(point * radius) for point in _AROUND]


@lru_cache(maxsize=32)
def _stops(theme: Theme, *, outside: bool) -> tuple[tuple[float, Colour], ...]:
    """The colours of the ground, or of what is around it, by the share of the radius. They lie closer near the rim."""
    if outside:
        shares = [1.0 + (_FARTHEST - 1.0) * (k / _STOPS) ** 2 for k in range(_STOPS + 1)]
        return tuple([(share / _FARTHEST, around_colour(theme, share)) for share in shares])
    shares = [1.0 - (1.0 - k / _STOPS) ** 2 for k in range(_STOPS + 1)]
    return tuple([(share, ground_colour(theme, share)) for share in shares])
