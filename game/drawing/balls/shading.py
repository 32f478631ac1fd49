"""The colour of every visible point of a ball: its skin's colour, lit."""

from game.drawing.balls.skins import surface_colours
from game.drawing.light import ScreenLight
from game.drawing.palette import Theme
from game.maths import Maths, Planes, Values

_DARK = (20, 30, 70)
"""Colour of the side that faces away from the light, and its share there; the highlight is white."""
_DARK_SHARE = 0.55


def shaded(maths: Maths[Values], skin: str, theme: Theme, light: ScreenLight, right: Values, up: Values) -> Planes[Values]:
    """Red, green and blue of points. right, up: from the ball's centre, in radii; points beyond the edge have its colour."""
    away = maths.hypot(right, up)
    out = maths.sqrt(maths.clip(1.0 - away * away, 0.0, 1.0))
    facing = right * light.right + up * light.up + out * light.out
    own, gloss = surface_colours(maths, skin, theme, right, up)
    in_the_dark: Values = _DARK_SHARE * (1.0 - maths.clip(0.5 + 0.6 * facing, 0.0, 1.0) ** 1.3)
    shine: Values = gloss * maths.clip(2.0 * out * facing - light.out, 0.0, 1.0) ** 24.0

    def lit(colour: Values, dark: float) -> Values:
        """Red, green or blue, lit."""
        dimmed: Values = colour + (dark - colour) * in_the_dark
        bright: Values = dimmed + (255.0 - dimmed) * shine
        return bright

    red, green, blue = own
    return lit(red, _DARK[0]), lit(green, _DARK[1]), lit(blue, _DARK[2])
