"""What balls are made of: the colour of every point of the side that is seen, before light and shadow."""

import math
from collections.abc import Callable

import numpy as np

from game.drawing.palette import Colour, Theme, layer_colour, luminance, mixed
from game.drawing.raster.annulus import Floats

_GLOSS = 0.7
"""Share of the way to white that a highlight goes."""
_BANDS, _TWIST = 2.6, 5.0
"""Of the marble: bands across it, and how they wind."""
_RING_EDGES = (0.38, 0.68)
"""Of the target: radii between its rings."""
_HALO = 0.78
"""Of the eclipse: radius from which on it is bright."""


def surface_colours(skin: str, theme: Theme, right: Floats, up: Floats) -> tuple[Floats, float]:
    """Three planes, red, green and blue, 0 to 255, and how far highlights go to white.

    right, up: of the points from the middle, in radii; they broadcast to a plane.
    """
    return _SKINS[skin](theme, right, up), 0.25 if skin == "eclipse" else _GLOSS


def _pearl(theme: Theme, right: Floats, up: Floats) -> Floats:
    """Of one colour."""
    return _between(theme.ball, theme.ball, np.zeros(np.broadcast_shapes(right.shape, up.shape), dtype=np.float32))


def _marble(theme: Theme, right: Floats, up: Floats) -> Floats:
    """Veins of the palette's colour in the ball's."""
    wind = np.sin(_BANDS * math.pi * (0.8 * right + 0.6 * up) + _TWIST * right * up)
    return _between(theme.ball, mixed(theme.ball, theme.trail, 0.75), np.clip(3.0 * wind, 0.0, 1.0))


def _target(theme: Theme, right: Floats, up: Floats) -> Floats:
    """Rings about the middle: a small arena."""
    away = np.hypot(right, up)
    inner, outer = _RING_EDGES
    band = _step(away, inner) - _step(away, outer)
    return _between(theme.ball, _strong(theme), band)


def _ember(theme: Theme, right: Floats, up: Floats) -> Floats:
    """Hot in the middle, glowing around."""
    hot, rim = ((255, 240, 170), (255, 96, 30)) if _is_dark(theme) else ((196, 60, 0), (96, 12, 0))
    return _between(hot, rim, np.clip(np.hypot(right, up) * 1.15 - 0.1, 0.0, 1.0))


def _eclipse(theme: Theme, right: Floats, up: Floats) -> Floats:
    """Dark, with a bright edge."""
    core = (46, 50, 84) if _is_dark(theme) else (214, 218, 232)
    return _between(core, theme.ball, _step(np.hypot(right, up), _HALO))


def _prism(theme: Theme, right: Floats, up: Floats) -> Floats:
    """Six sectors of six colours, around the middle."""
    turn = (np.arctan2(up, right) / math.tau * 6.0) % 6.0
    colours = np.array([mixed(layer_colour(theme, layer), theme.ball, 0.35) for layer in range(1, 7)], dtype=np.float32).T
    return np.asarray(colours[:, np.minimum(turn.astype(np.int64), 5)], dtype=np.float32)


_SKINS: dict[str, Callable[[Theme, Floats, Floats], Floats]] = {
    "pearl": _pearl,
    "marble": _marble,
    "target": _target,
    "ember": _ember,
    "eclipse": _eclipse,
    "prism": _prism,
}


def _between(first: Colour, second: Colour, share: Floats) -> Floats:
    """Colours some shares of the way from one to another."""
    one, other = (np.array(colour, dtype=np.float32)[:, None, None] for colour in (first, second))
    return np.asarray(one + (other - one) * share)


def _step(away: Floats, edge: float) -> Floats:
    """0 within an edge and 1 beyond, smooth over a tenth of the radius."""
    return np.asarray(np.clip((away - edge) / 0.1 + 0.5, 0.0, 1.0))


def _strong(theme: Theme) -> Colour:
    """A colour that stands out on the ball."""
    return (226, 64, 64) if _is_dark(theme) else (255, 150, 120)


def _is_dark(theme: Theme) -> bool:
    """Whether the ground is dark."""
    return luminance(theme.ground) < 0.5
