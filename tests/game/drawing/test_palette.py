"""The colours can be told apart, also without colour vision, and text can be read."""

import numpy as np
import pytest

from game.drawing.light_colour import light_colour
from game.drawing.palette import DARK, HIGH_CONTRAST, LIGHT, contrast, layer_colour, luminance, mixed
from game.drawing.palettes import NAMES, themed
from game.effects import Light, LightSource
from game.picture.ground.colours import ground_shade, rounded

THEMES = pytest.mark.parametrize(
    "theme",
    [*[themed(theme, name) for theme in (DARK, LIGHT) for name in NAMES], HIGH_CONTRAST],
    ids=[*[f"{kind} {name}" for kind in ("dark", "light") for name in NAMES], "high contrast"],
)


def test_contrast_is_21_between_black_and_white():
    """Black and white have the highest contrast ratio, 21; a colour and itself have the lowest, 1."""
    assert contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21.0)
    assert contrast((9, 9, 9), (9, 9, 9)) == 1.0


@THEMES
def test_text_is_readable_wherever_it_stands(theme):
    """Every text colour has a contrast of at least 4.5 on every surface that text stands on."""
    for text in (theme.text, theme.faint, theme.accent, theme.danger):
        for under in (theme.background, theme.ground, theme.panel):
            assert contrast(text, under) >= 4.5


@THEMES
def test_things_stand_out_from_the_ground(theme):
    """Everything that the ball can meet has a contrast of at least 3 to the ground, and of 2.6 where that is lit the most."""
    lightest = rounded(ground_shade(theme, 0.2))
    for thing in (theme.paddle, theme.paddle_top, theme.ball, theme.steel, theme.rim, *theme.layers):
        assert contrast(thing, theme.ground) >= 3.0
        assert contrast(thing, lightest) >= 2.6


def test_high_contrast_is_what_its_name_says():
    """Text has 7 on every surface, what the ball meets 4.5, and no level's palette changes that."""
    theme = HIGH_CONTRAST
    assert {themed(theme, name) for name in NAMES} == {theme}
    for under in (theme.background, theme.ground, theme.panel):
        assert min([contrast(text, under) for text in (theme.text, theme.faint, theme.accent, theme.danger)]) >= 7.0
        assert min([contrast(thing, under) for thing in (theme.paddle, theme.steel, theme.rim, *theme.layers)]) >= 4.5


def simulated(colour, kind):
    """A colour as seen without one kind of cone: Machado, Oliveira and Fernandes (2009), severity 1, in linear light."""
    matrix = {
        "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
        "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
        "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
    }[kind]
    share = np.array(colour) / 255.0
    linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    seen = np.clip(np.array(matrix) @ linear, 0.0, 1.0)
    back = np.where(seen <= 0.0031308, 12.92 * seen, 1.055 * seen ** (1.0 / 2.4) - 0.055)
    return tuple(np.rint(255.0 * back).astype(int).tolist())


@THEMES
@pytest.mark.parametrize("kind", ["protanopia", "deuteranopia", "tritanopia"])
def test_without_one_kind_of_cone_everything_stands_out_too(theme, kind):
    """Without red, green or blue cones, all has a contrast above 2.2 to the ground, and six layers stay in order."""
    ground = simulated(theme.ground, kind)
    for thing in (theme.paddle, theme.paddle_top, theme.ball, theme.steel, theme.rim, *theme.layers):
        assert contrast(simulated(thing, kind), ground) >= 2.2
    light = [luminance(simulated(layer_colour(theme, layer), kind)) for layer in range(1, 7)]
    assert light == sorted(light, reverse=luminance(theme.ground) > 0.5)
    for layer in range(1, 6):
        pair = (simulated(layer_colour(theme, number), kind) for number in (layer, layer + 1))
        assert contrast(*pair) >= 1.08


@THEMES
def test_stacks_stay_in_order_in_grey(theme):
    """Each layer differs from the one below in lightness alone: by a fifth up to six, always in the same direction."""
    light = [luminance(layer_colour(theme, layer)) for layer in range(1, 10)]
    assert light == sorted(light, reverse=luminance(theme.ground) > 0.5)
    assert len(set(light)) == len(light)
    for layer in range(1, 6):
        assert contrast(layer_colour(theme, layer), layer_colour(theme, layer + 1)) >= 1.2


def test_layers_beyond_the_last_colour_share_it():
    """Layer 40 has the colour of layer 9."""
    assert layer_colour(DARK, 40) == layer_colour(DARK, 9)


def test_mixing_ends_at_both_colours():
    """A share of 0 is the first colour, of 1 the second."""
    assert mixed((1, 2, 3), (201, 102, 53), 0.0) == (1, 2, 3)
    assert mixed((1, 2, 3), (201, 102, 53), 1.0) == (201, 102, 53)
    assert mixed((0, 0, 0), (200, 100, 50), 0.5) == (100, 50, 25)


@THEMES
def test_light_is_never_like_smoke(theme):
    """The light of every layer has a tenth of the highest luminance, and a contrast of 3 to the ground."""
    for layer in range(1, 10):
        colour = light_colour(Light(LightSource.BRICK, 0j, 0.3, 1.0, 80, layer), theme)
        assert luminance(colour) > 0.1
        assert contrast(colour, theme.ground) >= 3.0
