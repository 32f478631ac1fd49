"""The ground and what is around it: a light middle, a glowing rim; from above and aslant."""

import cmath
import math
from functools import lru_cache

from game.drawing.camera import Camera
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
_RIM, _LINE = 0.006, 0.0025
"""Width of the rim and of the lines on the ground, in ground radii."""
_LINES = (0.25, 0.5, 0.75)
_SPOKES = 12


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


def add_ground(out: DisplayList, camera: Camera, theme: Theme, ground_radius: float) -> None:
    """Add the ground."""
    if camera.flat:
        _add_flat(out, camera, theme, ground_radius)
    else:
        _add_aslant(out, camera, theme, ground_radius)


def _add_flat(out: DisplayList, camera: Camera, theme: Theme, ground_radius: float) -> None:
    """Add the ground from straight above."""
    radius = ground_radius * camera.scale
    out.gradient(camera.centre, radius * _FARTHEST, _stops(theme, outside=True))
    out.gradient(camera.centre, radius, _stops(theme, outside=False))
    for share in _LINES:
        out.circle(camera.centre, radius * share, max(_LINE * radius, 1.0), theme.ground_line)
    for k in range(_SPOKES):
        direction = cmath.rect(radius, math.tau * k / _SPOKES)
        out.line(
            (camera.centre + direction * _LINES[0], camera.centre + direction), max(_LINE * radius, 1.0), theme.ground_line
        )
    out.circle(camera.centre, radius, max(_RIM * radius, 1.5), theme.rim)


def _add_aslant(out: DisplayList, camera: Camera, theme: Theme, ground_radius: float) -> None:
    """Add the ground as a plate seen aslant: discs from the largest to the smallest, each in one colour."""
    for k in range(_RINGS_ASLANT):
        share = _FARTHEST - (_FARTHEST - 1.0) * k / _RINGS_ASLANT
        out.polygon(_circle(camera, ground_radius * share), around_colour(theme, share))
    below = [camera.project(point * ground_radius, -_THICKNESS * ground_radius) for point in _AROUND]
    out.polygon(below, mixed(theme.rim, theme.background, 0.55))
    for k in range(_RINGS_ASLANT):
        share = 1.0 - (k / _RINGS_ASLANT) ** 2
        out.polygon(_circle(camera, ground_radius * share), ground_colour(theme, share))
    width = max(_LINE * ground_radius * camera.scale, 1.0)
    for share in _LINES:
        ring = _circle(camera, ground_radius * share)
        out.line([*ring, ring[0]], width, theme.ground_line)
    rim = _circle(camera, ground_radius)
    out.line([*rim, rim[0]], max(_RIM * ground_radius * camera.scale, 1.5), theme.rim)


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
