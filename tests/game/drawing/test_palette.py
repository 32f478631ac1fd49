"""The colours can be told apart, also without colour vision, and text can be read."""

import pytest

from game.drawing.palette import DARK, LIGHT, contrast, layer_colour, luminance, mixed

THEMES = pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])


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
    """Everything that the ball can meet has a contrast of at least 3 to the ground."""
    for thing in (theme.paddle, theme.paddle_top, theme.ball, theme.steel, theme.rim, *theme.layers):
        assert contrast(thing, theme.ground) >= 3.0


@THEMES
def test_stacks_stay_in_order_in_grey(theme):
    """Each layer differs from the one below in lightness alone: by a fifth up to six, always in the same direction."""
    light = [luminance(layer_colour(theme, layer)) for layer in range(1, 10)]
    assert light == sorted(light, reverse=theme is LIGHT)
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
