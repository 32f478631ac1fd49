"""The colours of everything, dark, light and in high contrast, chosen to tell apart without colour vision.

Stacks are told apart by their terraces first and by colour second; the colours of a stack grow lighter (on dark ground)
or darker (on light ground) with every layer, so that they stay in order in grey. `tests/game/drawing/test_palette.py` computes
all this.
"""

import math
from functools import cache
from typing import NamedTuple

Colour = tuple[int, int, int]


class Theme(NamedTuple):
    """One set of colours, sRGB.

    background: around the ground. ground, ground_line, rim: of the ground, the lines on it, and its edge.
    text, faint: of main and of secondary text. accent: of what is chosen, and of the serve's aim.
    panel, panel_edge: of plates with text.
    paddle, paddle_top, ball, trail: of these. steel, steel_line: of what never breaks, and of the lines on it.
    flash: the light of a hit. danger: bad news.
    shadow: share of the ground's light that a shadow takes. shade: how dark the sides of blocks are, 0 to 1.
    vignette: share of its light by which the ground is darker at the rim than in the middle.
    glow: strength of the light that the rim gives off, 0 to 1.
    relief: strength of light and shadow on what stands in the flat view, 0 to 1.
    layers: of a stack's terraces, from the lowest, 1, to 9.
    """

    background: Colour
    ground: Colour
    ground_line: Colour
    rim: Colour
    text: Colour
    faint: Colour
    accent: Colour
    panel: Colour
    panel_edge: Colour
    paddle: Colour
    paddle_top: Colour
    ball: Colour
    trail: Colour
    steel: Colour
    steel_line: Colour
    flash: Colour
    danger: Colour
    shadow: float
    shade: float
    vignette: float
    glow: float
    relief: float
    layers: tuple[Colour, ...]


DARK = Theme(
    background=(9, 11, 22),
    ground=(18, 22, 40),
    ground_line=(31, 37, 62),
    rim=(86, 101, 154),
    text=(240, 243, 255),
    faint=(160, 170, 204),
    accent=(255, 209, 102),
    panel=(22, 27, 50),
    panel_edge=(74, 88, 138),
    paddle=(22, 148, 146),
    paddle_top=(74, 226, 208),
    ball=(255, 255, 255),
    trail=(120, 160, 255),
    steel=(118, 126, 146),
    steel_line=(38, 43, 58),
    flash=(255, 255, 255),
    danger=(255, 138, 128),
    shadow=0.42,
    shade=1.0,
    vignette=0.5,
    glow=1.0,
    relief=1.0,
    layers=(
        (58, 92, 214),
        (136, 92, 236),
        (222, 98, 196),
        (255, 134, 116),
        (255, 178, 84),
        (255, 222, 110),
        (255, 244, 176),
        (255, 252, 224),
        (255, 255, 255),
    ),
)

LIGHT = Theme(
    background=(222, 226, 236),
    ground=(246, 247, 251),
    ground_line=(226, 230, 240),
    rim=(120, 132, 168),
    text=(20, 24, 44),
    faint=(74, 82, 110),
    accent=(158, 72, 0),
    panel=(255, 255, 255),
    panel_edge=(120, 132, 168),
    paddle=(0, 116, 118),
    paddle_top=(0, 156, 150),
    ball=(24, 28, 48),
    trail=(70, 96, 170),
    steel=(132, 138, 154),
    steel_line=(58, 62, 76),
    flash=(255, 176, 0),
    danger=(176, 24, 36),
    shadow=0.22,
    shade=0.6,
    vignette=0.06,
    glow=1.0,
    relief=1.0,
    layers=(
        (84, 136, 240),
        (126, 104, 240),
        (168, 58, 206),
        (176, 34, 120),
        (150, 24, 60),
        (112, 18, 30),
        (78, 14, 18),
        (48, 8, 12),
        (16, 4, 6),
    ),
)

HIGH_CONTRAST = Theme(
    background=(0, 0, 0),
    ground=(0, 0, 0),
    ground_line=(58, 58, 58),
    rim=(255, 255, 255),
    text=(255, 255, 255),
    faint=(214, 214, 214),
    accent=(255, 232, 0),
    panel=(0, 0, 0),
    panel_edge=(118, 118, 118),
    paddle=(0, 176, 160),
    paddle_top=(0, 255, 232),
    ball=(255, 255, 255),
    trail=(120, 180, 255),
    steel=(150, 150, 150),
    steel_line=(0, 0, 0),
    flash=(255, 255, 255),
    danger=(255, 120, 110),
    shadow=0.0,
    shade=1.0,
    vignette=0.0,
    glow=0.0,
    relief=0.0,
    layers=(
        (72, 105, 240),
        (152, 98, 255),
        (217, 109, 212),
        (249, 136, 112),
        (247, 173, 45),
        (254, 200, 4),
        (255, 226, 84),
        (255, 241, 144),
        (255, 255, 255),
    ),
)
"""Black, without light and shadow; the levels' own palettes are left out."""


@cache
def without_depth(theme: Theme) -> Theme:
    """A theme in which every surface of the flat view has one colour: no light, no shadow, no glow."""
    return theme._replace(vignette=0.0, glow=0.0, relief=0.0)


def layer_colour(theme: Theme, layer: int) -> Colour:
    """Colour of the given terrace of a stack, 1 the lowest; those above the last colour share it."""
    return theme.layers[min(layer, len(theme.layers)) - 1]


def mixed(first: Colour, second: Colour, share: float) -> Colour:
    """The colour a share, 0 to 1, of the way from the first to the second."""
    return (
        round(first[0] + (second[0] - first[0]) * share),
        round(first[1] + (second[1] - first[1]) * share),
        round(first[2] + (second[2] - first[2]) * share),
    )


def luminance(colour: Colour) -> float:
    """Relative luminance as in WCAG 2: 0 black to 1 white."""
    red, green, blue = (_linear(channel / 255.0) for channel in colour)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(first: Colour, second: Colour) -> float:
    """Contrast ratio as in WCAG 2: 1 to 21."""
    darker, lighter = sorted((luminance(first), luminance(second)))
    return (lighter + 0.05) / (darker + 0.05)


def _linear(channel: float) -> float:
    """Light of an sRGB channel."""
    return channel / 12.92 if channel <= 0.04045 else math.pow((channel + 0.055) / 1.055, 2.4)
