"""The colours of one slot of a ring, as a picture in polar coordinates: a row per radius, a column per angle.

Edges are anti-aliased exactly: how deep a place lies inside a sector, in pixels, says how much of its pixel is covered.
"""

from enum import IntEnum, auto
from typing import NamedTuple

import numpy as np

from game.drawing.flat.annulus_pixels import Floats
from game.drawing.palette import Colour, Theme, layer_colour, mixed

GLOW = 6
"""Steps from not glowing to glowing fully."""
DOT_SHADE = 0.6
"""How far the dots' colour is on its way from the top's to the ground's."""
MOST_DOT = 0.09
"""World units, half a dot."""
_DICE: dict[int, tuple[tuple[float, ...], ...]] = {
    2: ((-0.5, 0.5),),
    3: ((-1.0, 0.0, 1.0),),
    4: ((-0.5, 0.5),) * 2,
    5: ((-1.0, 0.0, 1.0), (-0.5, 0.5)),
    6: ((-1.0, 0.0, 1.0),) * 2,
    7: ((-1.5, -0.5, 0.5, 1.5), (-1.0, 0.0, 1.0)),
    8: ((-1.5, -0.5, 0.5, 1.5),) * 2,
    9: ((-1.0, 0.0, 1.0),) * 3,
}
"""Rows of dots for as many layers, and where they are along a row; more than nine look like nine."""
_TERRACE = 0.085
"""World units from one terrace's edge to the next, where there is room."""
_SHADE = 0.4
"""How much darker a terrace is at the foot of the next."""


class Kind(IntEnum):
    """What stands in a slot."""

    EMPTY = auto()
    PADDLE = auto()
    BRICKS = auto()
    STEEL = auto()
    GHOST = auto()


class Look(NamedTuple):
    """How a slot looks."""

    kind: Kind
    layers: int = 0  # of BRICKS
    glow: int = 0  # 0 to GLOW


class Sector(NamedTuple):
    """A sector's measures on the screen."""

    inner: float  # pixels
    outer: float
    half_angle: float  # radians
    terrace: float  # pixels from one terrace's edge to the next
    scale: float  # pixels per world unit


class Dot(NamedTuple):
    """One of the dots on a stack's top, square."""

    radius: float  # of its middle
    angle: float  # from the slot's middle
    half: float  # half its side, in the radius' unit


def dots(layers: int, radius: float, half_width: float, half_angle: float, most: float) -> list[Dot]:
    """As many dots as layers, laid out as on dice so that nobody has to count; none for one layer.

    radius, half_width, half_angle: of the stack's top, in any unit; most: half a dot where there is room.
    """
    rows = _DICE.get(min(layers, max(_DICE)), ())
    if not rows or half_width <= 0.0 or half_angle <= 0.0:
        return []
    along, across = 2.0 * half_angle * radius / max([len(row) for row in rows]), 2.0 * half_width / len(rows)
    half = min(0.3 * min(along, across), most)
    aside, up = min(4.0 * half, along) / radius, min(4.0 * half, across)
    middle = (len(rows) - 1) / 2.0
    return [Dot(radius + (k - middle) * up, place * aside, half) for k, row in enumerate(rows) for place in row]


def colours(look: Look, sector: Sector, radii: Floats, angles: Floats, theme: Theme) -> Floats:
    """Red, green and blue, 0 to 255, at every radius (pixels) and angle (radians from the sector's middle)."""
    picture = np.empty((len(radii), len(angles), 3), dtype=np.float32)
    picture[:] = theme.ground
    depth = _depth(sector, radii, angles)
    match look.kind:
        case Kind.PADDLE:
            track = 0.5 - np.abs(radii - (sector.inner + sector.outer) / 2.0)[:, None] + 0.015 * sector.scale
            _paint(picture, track.astype(np.float32), theme.ground_line)
            _paint(picture, depth, _glowing(theme.paddle, look, theme))
            rim = max(1.0, 0.2 * (sector.outer - sector.inner))
            _paint(picture, depth - np.float32(rim), _glowing(theme.paddle_top, look, theme))
        case Kind.BRICKS:
            _paint_stack(picture, depth, look, sector, theme)
            _paint_dots(picture, look, sector, radii, angles, theme)
        case Kind.STEEL:
            _paint(picture, depth, _glowing(theme.steel, look, theme))
            _paint_truss(picture, depth, sector, radii, angles, theme)
        case Kind.GHOST:
            fade = look.glow / GLOW
            smallest = min(sector.outer - sector.inner, 2.0 * sector.half_angle * sector.inner) / 2.0
            shrunk = depth - np.float32((1.0 - fade) * smallest)
            _paint(picture, shrunk, mixed(theme.ground, theme.flash, 0.75 * fade))
    return picture


def terrace(half_width: float, half_angle: float, inner: float, tallest: int) -> float:
    """World units from one terrace's edge to the next, so that the tallest stack of a ring keeps a top."""
    room = min(half_width, half_angle * inner)
    return min(_TERRACE, 0.6 * room / max(tallest, 1))


def _depth(sector: Sector, radii: Floats, angles: Floats) -> Floats:
    """How far inside the sector a place is from its nearest side, pixels; negative outside."""
    radial = np.minimum(radii - sector.inner, sector.outer - radii).astype(np.float32)
    if sector.half_angle >= np.pi * 0.999:
        return np.repeat(radial[:, None], len(angles), axis=1)
    ends = radii[:, None] * np.sin(np.clip(sector.half_angle - np.abs(angles), -np.pi / 2.0, np.pi / 2.0))[None, :]
    return np.asarray(np.minimum(radial[:, None], ends), dtype=np.float32)


def _paint(picture: Floats, depth: Floats, colour: Colour) -> None:
    """Cover what lies inside by a colour, the border pixels in part."""
    cover = np.clip(depth + np.float32(0.5), 0.0, 1.0)[:, :, None]
    picture += (np.array(colour, dtype=np.float32) - picture) * cover


def _paint_stack(picture: Floats, depth: Floats, look: Look, sector: Sector, theme: Theme) -> None:
    """A terrace per layer, each darker at the foot of the next."""
    for layer in range(1, look.layers + 1):
        above = depth - np.float32(sector.terrace * (layer - 1))
        if layer > 1:
            reach = max(0.6 * sector.terrace, 1.0)
            shade = np.float32(_SHADE) * np.clip(1.0 + above / reach, 0.0, 1.0) * (depth > 0.0)
            picture *= (1.0 - shade)[:, :, None].astype(np.float32)
        colour = layer_colour(theme, layer)
        _paint(picture, above, _glowing(colour, look, theme) if layer == look.layers else colour)


def _paint_dots(picture: Floats, look: Look, sector: Sector, radii: Floats, angles: Floats, theme: Theme) -> None:
    """What tells a stack's layers at a glance."""
    inset, radius = sector.terrace * (look.layers - 1), (sector.inner + sector.outer) / 2.0
    colour = _glowing(mixed(layer_colour(theme, look.layers), theme.ground, DOT_SHADE), look, theme)
    half_width, half_angle = (sector.outer - sector.inner) / 2.0 - inset, sector.half_angle - inset / radius
    for dot in dots(look.layers, radius, half_width, half_angle, MOST_DOT * sector.scale):
        aside, up = radii[:, None] * np.abs(angles - dot.angle)[None, :], np.abs(radii - dot.radius)[:, None]
        _paint(picture, (dot.half - np.maximum(aside, up)).astype(np.float32), colour)


def _paint_truss(picture: Floats, depth: Floats, sector: Sector, radii: Floats, angles: Floats, theme: Theme) -> None:
    """A frame and a zigzag: the mark of what no hit breaks."""
    line = max(1.0, 0.06 * sector.scale)
    margin = 0.12 * (sector.outer - sector.inner)
    frame = line / 2.0 - np.abs(depth - np.float32(margin))
    _paint(picture, frame.astype(np.float32), theme.steel_line)
    inside = sector.outer - sector.inner - 2.0 * margin
    along = 2.0 * sector.half_angle * (sector.inner + sector.outer) / 2.0 - 2.0 * margin
    if inside < 2.0 or along < 2.0:
        return
    count = max(2, round(along / inside))
    place = ((angles / (2.0 * sector.half_angle) + 0.5) * count) % 2.0
    height = sector.inner + margin + inside * (1.0 - np.abs(place - 1.0))
    slope = np.cos(np.arctan2(inside, along / count))
    zigzag = np.minimum(line / 2.0 - np.abs(radii[:, None] - height[None, :]) * slope, depth - np.float32(margin))
    _paint(picture, zigzag.astype(np.float32), theme.steel_line)


def _glowing(colour: Colour, look: Look, theme: Theme) -> Colour:
    """The colour, on its way to the flash's."""
    return mixed(colour, theme.flash, 0.8 * look.glow / GLOW)
