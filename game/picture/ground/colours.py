"""The colour of the ground and of what is around it, by the distance from the centre: a light middle, a glowing rim."""

import math

from game.drawing.palette import Colour, Theme

FARTHEST = 1.6
"""Ground radii from the centre to where there is no glow any more."""
_INNER_GLOW, _INNER_REACH = 0.16, 0.035
"""Of the rim's light on the ground: its strength at the rim, and the distance in which it fades to 1/e, in ground radii."""
_OUTER_GLOW, _OUTER_REACH = 0.30, 0.09
"""The same of the light around the ground."""
Shade = tuple[float, float, float]
"""Red, green and blue, 0 to 255, before they are rounded."""


def ground_shade(theme: Theme, share: float) -> Shade:
    """The ground at a distance from the centre, in ground radii."""
    light = 1.0 + theme.vignette * (0.5 - share * share)
    red, green, blue = theme.ground
    glow = _INNER_GLOW * theme.glow * math.exp((min(share, 1.0) - 1.0) / _INNER_REACH)
    return _towards((red * light, green * light, blue * light), theme.rim, glow)


def around_shade(theme: Theme, share: float) -> Shade:
    """What is around the ground, where shares are above 1."""
    fading = min(max((FARTHEST - share) / (FARTHEST - 1.0), 0.0), 1.0)
    return _towards(theme.background, theme.rim, _OUTER_GLOW * theme.glow * math.exp((1.0 - share) / _OUTER_REACH) * fading)


def mark_shade(theme: Theme, share: float, strength: float) -> Shade:
    """A mark on the ground. strength: share of the way from the ground's colour to that of its lines."""
    lines, ground = theme.ground_line, theme.ground
    red, green, blue = (own + (lines[k] - ground[k]) * strength for k, own in enumerate(ground_shade(theme, share)))
    return _within((red, green, blue))


def rounded(shade: Shade) -> Colour:
    """The colour that a screen shows."""
    red, green, blue = shade
    return round(red), round(green), round(blue)


def _towards(shade: Shade, other: Colour, share: float) -> Shade:
    """A shade some share of the way to a colour."""
    red, green, blue = (own + (there - own) * share for own, there in zip(shade, other, strict=True))
    return _within((red, green, blue))


def _within(shade: Shade) -> Shade:
    """A shade that a screen can show."""
    red, green, blue = (min(max(channel, 0.0), 255.0) for channel in shade)
    return red, green, blue
