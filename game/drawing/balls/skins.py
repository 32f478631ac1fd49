"""What balls are made of: the colour of every point of the side that is seen, before light and shadow."""

import math
from typing import Protocol

from game.drawing.palette import Colour, Theme, layer_colour, luminance, mixed
from game.maths import Maths, Planes, Values

_GLOSS = 0.7
"""Share of the way to white that a highlight goes."""
_BANDS, _TWIST = 2.6, 5.0
"""Of the marble: bands across it, and how they wind."""
_RING_EDGES = (0.38, 0.68)
"""Of the target: radii between its rings."""
_HALO = 0.78
"""Of the eclipse: radius from which on it is bright."""


def surface_colours(maths: Maths[Values], skin: str, theme: Theme, right: Values, up: Values) -> tuple[Planes[Values], float]:
    """Red, green and blue of points, and how white a highlight is, from 0 to 1.

    right, up: offset of the points from the centre, in radii; arrays are broadcast against each other.
    """
    return _SKINS[skin](maths, theme, right, up), 0.25 if skin == "eclipse" else _GLOSS


def _pearl(_maths: Maths[Values], theme: Theme, right: Values, up: Values) -> Planes[Values]:
    """Of one colour."""
    return _between(theme.ball, theme.ball, 0.0 * (right + up))


def _marble(maths: Maths[Values], theme: Theme, right: Values, up: Values) -> Planes[Values]:
    """Veins of the palette's colour in the ball's."""
    wind = maths.sin(_BANDS * math.pi * (0.8 * right + 0.6 * up) + _TWIST * right * up)
    return _between(theme.ball, mixed(theme.ball, theme.trail, 0.75), maths.clip(3.0 * wind, 0.0, 1.0))


def _target(maths: Maths[Values], theme: Theme, right: Values, up: Values) -> Planes[Values]:
    """Rings about the middle: a small arena."""
    away = maths.hypot(right, up)
    inner, outer = _RING_EDGES
    band = _step(maths, away, inner) - _step(maths, away, outer)
    return _between(theme.ball, _strong(theme), band)


def _ember(maths: Maths[Values], theme: Theme, right: Values, up: Values) -> Planes[Values]:
    """Hot in the middle, glowing around."""
    hot, rim = ((255, 240, 170), (255, 96, 30)) if _is_dark(theme) else ((196, 60, 0), (96, 12, 0))
    return _between(hot, rim, maths.clip(maths.hypot(right, up) * 1.15 - 0.1, 0.0, 1.0))


def _eclipse(maths: Maths[Values], theme: Theme, right: Values, up: Values) -> Planes[Values]:
    """Dark, with a bright edge."""
    core = (46, 50, 84) if _is_dark(theme) else (214, 218, 232)
    return _between(core, theme.ball, _step(maths, maths.hypot(right, up), _HALO))


def _prism(maths: Maths[Values], theme: Theme, right: Values, up: Values) -> Planes[Values]:
    """Six sectors of six colours, around the middle."""
    sector = maths.clip((maths.arctan2(up, right) / math.tau * 6.0) % 6.0, 0.0, 5.9)
    red, green, blue = zip(*[mixed(layer_colour(theme, layer), theme.ball, 0.35) for layer in range(1, 7)], strict=True)
    return maths.pick(red, sector), maths.pick(green, sector), maths.pick(blue, sector)


class _Skin(Protocol):
    """A function that computes a skin's colours."""

    def __call__(self, maths: Maths[Values], theme: Theme, right: Values, up: Values, /) -> Planes[Values]:
        """Red, green and blue of points."""


_SKINS: dict[str, _Skin] = {
    "pearl": _pearl,
    "marble": _marble,
    "target": _target,
    "ember": _ember,
    "eclipse": _eclipse,
    "prism": _prism,
}


def _between(first: Colour, second: Colour, share: Values) -> Planes[Values]:
    """Colours some shares of the way from one to another."""
    red, green, blue = [one + (other - one) * share for one, other in zip(first, second, strict=True)]
    return red, green, blue


def _step(maths: Maths[Values], away: Values, edge: float) -> Values:
    """0 within an edge and 1 beyond, smooth over a tenth of the radius."""
    return maths.clip((away - edge) / 0.1 + 0.5, 0.0, 1.0)


def _strong(theme: Theme) -> Colour:
    """A colour that stands out on the ball."""
    return (226, 64, 64) if _is_dark(theme) else (255, 150, 120)


def _is_dark(theme: Theme) -> bool:
    """Whether the ground is dark."""
    return luminance(theme.ground) < 0.5
