"""The look of flying pieces: shape and light of plates, colours of sparks. The formulas take numbers or arrays."""

from game.drawing.light import LIGHT
from game.drawing.palette import Colour, Theme, layer_colour
from game.effects.bursts import Burst, Matter
from game.maths import Maths, Values

PLATES = frozenset({Matter.BRICK, Matter.BALL})
"""Materials that break into plates; the others give off sparks."""
STREAK_TICKS = 9
"""A streak extends from its spark's position to the position this many ticks ago."""
STREAK_WIDTH, STREAK_FRONT = 0.35, 0.15
"""Half the width of a streak in sizes of its spark, and how far its blunt end extends ahead, in lengths of the streak."""
LEAST_SIZE = 0.35
"""Pixels; smaller pieces are not drawn."""
_LIGHT_ABOVE = 0.6
"""Share of a plate's light that comes from above, the rest from the side."""
_DIMMEST = 0.72
"""Share of its colour that a plate shows while it is edge-on to the light."""
_GLITTER, _WHITEST = 6.0, 0.6
"""Exponent of a plate's highlight as it turns towards the light, and how far the highlight goes to white."""


def burst_colour(burst: Burst, theme: Theme) -> Colour:
    """The colour of what a burst is made of."""
    if burst.matter is Matter.BRICK:
        return layer_colour(theme, burst.layer)
    return {Matter.BALL: theme.danger, Matter.STEEL: theme.accent, Matter.PADDLE: theme.paddle_top}[burst.matter]


def unevenness(maths: Maths[Values], shape: Values, corner: int) -> Values:
    """Distance of a plate's corner, 0 to 3, from its centre, in half diagonals. shape: the plate's random number, 0 to 1."""
    return 0.65 + 0.35 * maths.cos(7.0 * shape + corner * 2.2)


def plate_light(maths: Maths[Values], turn: Values, tumble: Values) -> Values:
    """The light on a plate, 0 to 1. turn, tumble: angles about the vertical and about a horizontal axis."""
    from_the_side = maths.sin(tumble) * (maths.sin(turn) * LIGHT.real - maths.cos(turn) * LIGHT.imag)
    return abs(from_the_side * (1.0 - _LIGHT_ABOVE) + maths.cos(tumble) * _LIGHT_ABOVE)


def glittering(maths: Maths[Values], own: Values, light: Values) -> Values:
    """A plate's red, green or blue. own: that of its material; light: 0 to 1."""
    shade: Values = own * (_DIMMEST + (1.0 - _DIMMEST) * maths.clip(1.4 * light, 0.0, 1.0))
    glitter: Values = maths.clip(2.0 * light - 1.0, 0.0, 1.0) ** _GLITTER
    bright: Values = shade + (255.0 - shade) * _WHITEST * glitter
    return bright


def burning(maths: Maths[Values], own: Values, hot: Values, cold: Values, share: Values) -> Values:
    """A spark's red, green or blue after a share of its life. hot: at first; own: then; cold: at last, the ground's."""
    bright = own + (hot - own) * maths.clip(1.0 - 3.0 * share, 0.0, 1.0)
    left: Values = bright + (cold - bright) * share * share
    return left
