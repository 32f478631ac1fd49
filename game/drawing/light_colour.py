"""The colour of a light that a hit throws, for every painter."""

from game.drawing.arcade.signs import power_colour
from game.drawing.palette import Colour, Theme, layer_colour
from game.effects import Light, LightSource


def light_colour(light: Light, theme: Theme) -> Colour:
    """The colour of a light."""
    if light.source is LightSource.BRICK:
        return layer_colour(theme, light.layer)
    if light.power is not None:
        return power_colour(light.power, theme)
    plain = {LightSource.PADDLE: theme.paddle_top, LightSource.STEEL: theme.steel, LightSource.BAD: theme.danger}
    return plain.get(light.source, theme.accent)
