"""What players without one kind of cone see, computed: neighbouring things differ for them as they do for others.

How a colour is seen is simulated by the matrices of G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A physiologically-based
model for simulation of color vision deficiency", IEEE Transactions on Visualization and Computer Graphics 15 (2009), for the
severity 1.0. Differences are distances in CIELAB (1976) with the white of D65, in which 2.3 is just noticeable.
"""

import itertools

import numpy as np
import pytest

from game.drawing.colour_vision import VISION_NAMES, VISIONS, seen_by
from game.drawing.palette import DARK, HIGH_CONTRAST, LIGHT

MACHADO = {
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    "full": np.eye(3),
}
XYZ = [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
D65 = (0.95047, 1.0, 1.08883)
THEMES = {"dark": DARK, "light": LIGHT, "contrast": HIGH_CONTRAST}
CASES = [(vision, name) for vision in VISIONS[1:] for name in THEMES]
EACH = pytest.mark.parametrize(
    ("vision", "theme"), [(vision, THEMES[name]) for vision, name in CASES], ids=[f"{vision}-{name}" for vision, name in CASES]
)


def light(colour, vision):
    """Linear red, green and blue of what is seen."""
    channels = np.array(colour) / 255.0
    linear = np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)
    return np.clip(MACHADO[vision] @ linear, 0.0, 1.0)


def lab(colour, vision):
    """Coordinates in CIELAB of what is seen."""
    shares = XYZ @ light(colour, vision) / D65
    roots = np.where(shares > 216 / 24389, np.cbrt(shares), (24389 / 27 * shares + 16) / 116)
    return np.array([116 * roots[1] - 16, 500 * (roots[0] - roots[1]), 200 * (roots[1] - roots[2])])


def difference(first, second, vision):
    """How far two colours are apart as they are seen."""
    return float(np.linalg.norm(lab(first, vision) - lab(second, vision)))


def contrast(first, second, vision):
    """Contrast ratio as in WCAG 2 of two colours as they are seen."""
    darker, lighter = sorted(XYZ[1] @ light(colour, vision) for colour in (first, second))
    return (lighter + 0.05) / (darker + 0.05)


def kinds(theme):
    """Pairs of colours that stand for different things in the arena."""
    others = (theme.paddle, theme.paddle_top, theme.steel)
    pairs = [(other, layer) for other in others for layer in theme.layers[:6]]
    return [*pairs, (theme.paddle, theme.steel), (theme.paddle_top, theme.steel)]


def test_the_simulation_is_the_published_one():
    """White stays white; red and green of one brightness, far apart for most, are nearly one colour without green cones."""
    for vision in VISIONS:
        assert light((255, 255, 255), vision) == pytest.approx([1.0, 1.0, 1.0], abs=1e-5)
    red, green = (200, 60, 60), (110, 110, 40)
    assert difference(red, green, "full") > 50.0
    assert difference((190, 80, 60), (120, 115, 50), "deuteranopia") < 25.0
    assert difference((0, 130, 190), (0, 150, 140), "tritanopia") < 12.0 < difference((0, 130, 190), (0, 150, 140), "full")


@EACH
def test_things_of_different_kinds_differ(vision, theme):
    """Bricks, paddles and what never breaks are at least 24 apart, bad news and what is chosen too; so they are for others."""
    own = seen_by(vision, theme)
    for seen in (vision, "full"):
        for first, second in [*kinds(own), (own.danger, own.accent), (own.danger, own.text), (own.accent, own.text)]:
            assert difference(first, second, seen) >= 24.0


@EACH
def test_a_stacks_layers_differ_from_the_next(vision, theme):
    """Up to six: by 10 and by a contrast of 1.2; all nine grow lighter, or darker on the light theme, as they are seen."""
    layers = seen_by(vision, theme).layers
    for lower, upper in itertools.pairwise(layers[:6]):
        assert difference(lower, upper, vision) >= 10.0
        assert contrast(lower, upper, vision) >= 1.2
    brightness = [XYZ[1] @ light(layer, vision) for layer in layers]
    assert brightness == sorted(brightness, reverse=theme is LIGHT)
    assert len(set(brightness)) == len(layers)


@EACH
def test_things_and_text_stand_out(vision, theme):
    """Everything that the ball can meet has a contrast of 3 to the ground, text one of 4.5 to what it stands on."""
    own = seen_by(vision, theme)
    for seen in (vision, "full"):
        for thing in (own.paddle, own.paddle_top, own.ball, own.steel, own.rim, *own.layers):
            assert contrast(thing, own.ground, seen) >= 3.0
        for text, under in itertools.product(
            (own.text, own.faint, own.accent, own.danger), (own.background, own.ground, own.panel)
        ):
            assert contrast(text, under, seen) >= 4.5


@EACH
def test_the_usual_colours_are_not_enough(vision, theme):
    """In them some things of different kinds are less than 24 apart for this player."""
    assert min([difference(first, second, vision) for first, second in kinds(theme)]) < 24.0


def test_every_vision_has_a_name_and_full_vision_the_usual_colours():
    """And the other themes are as they were."""
    assert set(VISION_NAMES) == set(VISIONS)
    assert seen_by("full", DARK) is DARK
    assert seen_by("full", LIGHT) is LIGHT
