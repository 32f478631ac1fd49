"""The colour of a light that a hit throws, for every painter."""

from game.drawing.arcade.signs import power_colour
from game.drawing.palette import Colour, Theme, layer_colour, luminance
from game.effects import Light, LightSource

_LIGHTEST = 2
"""Layers of a stack whose colours shine on light grounds: those above are so dark that their light would look like smoke."""


def light_colour(light: Light, theme: Theme) -> Colour:
    """The colour of a light."""
    if light.source is LightSource.BRICK:
        return layer_colour(theme, light.layer if luminance(theme.ground) < 0.5 else min(light.layer, _LIGHTEST))
    if light.power is not None:
        return power_colour(light.power, theme)
    plain = {LightSource.PADDLE: theme.paddle_top, LightSource.STEEL: theme.steel, LightSource.BAD: theme.danger}
    return plain.get(light.source, theme.accent)
