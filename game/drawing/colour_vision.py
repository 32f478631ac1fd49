"""Themes for players who lack one kind of cone: nothing is told apart by what they do not see.

Without red or green cones (protanopia, deuteranopia) the bricks are orange and the paddles blue; without blue cones
(tritanopia) the bricks are red and the paddles green-blue. What never breaks stays grey.
`tests/game/drawing/test_colour_vision.py` computes how all this is seen.
"""

from typing import NamedTuple

from game.drawing.palette import LIGHT, Colour, Theme
from game.language import tr_noop


class _Seen(NamedTuple):
    """The colours of a theme that are other ones. Fields are those of `Theme`."""

    layers: tuple[Colour, ...]
    paddle: Colour
    paddle_top: Colour
    accent: Colour
    danger: Colour


_DARK = {
    "protanopia": _Seen(
        layers=(
            (182, 90, 29),
            (191, 113, 0),
            (233, 131, 6),
            (241, 161, 39),
            (252, 189, 87),
            (255, 219, 128),
            (255, 232, 170),
            (255, 244, 208),
            (255, 252, 240),
        ),
        paddle=(20, 96, 230),
        paddle_top=(96, 164, 255),
        accent=(255, 209, 102),
        danger=(132, 181, 251),
    ),
    "deuteranopia": _Seen(
        layers=(
            (167, 84, 0),
            (197, 105, 6),
            (223, 129, 10),
            (246, 158, 10),
            (251, 191, 77),
            (255, 224, 133),
            (255, 232, 170),
            (255, 244, 208),
            (255, 252, 240),
        ),
        paddle=(20, 96, 230),
        paddle_top=(96, 164, 255),
        accent=(255, 209, 102),
        danger=(145, 187, 255),
    ),
    "tritanopia": _Seen(
        layers=(
            (194, 37, 64),
            (222, 52, 105),
            (227, 97, 93),
            (238, 123, 124),
            (250, 156, 152),
            (255, 188, 180),
            (255, 210, 204),
            (255, 230, 226),
            (255, 248, 246),
        ),
        paddle=(0, 140, 140),
        paddle_top=(60, 220, 210),
        accent=(255, 170, 190),
        danger=(255, 120, 120),
    ),
}
_LIGHT = {
    "protanopia": _Seen(
        layers=(
            (176, 134, 25),
            (182, 104, 6),
            (161, 81, 7),
            (126, 63, 0),
            (98, 47, 6),
            (74, 31, 0),
            (56, 26, 0),
            (36, 16, 0),
            (13, 6, 0),
        ),
        paddle=(0, 80, 220),
        paddle_top=(40, 110, 240),
        accent=(158, 72, 0),
        danger=(0, 60, 190),
    ),
    "deuteranopia": _Seen(
        layers=(
            (206, 107, 1),
            (174, 98, 6),
            (146, 80, 0),
            (124, 69, 10),
            (98, 49, 0),
            (74, 36, 0),
            (56, 26, 0),
            (36, 16, 0),
            (16, 8, 0),
        ),
        paddle=(0, 80, 220),
        paddle_top=(40, 110, 240),
        accent=(150, 68, 0),
        danger=(0, 60, 190),
    ),
    "tritanopia": _Seen(
        layers=(
            (230, 96, 118),
            (219, 68, 88),
            (185, 63, 70),
            (167, 18, 52),
            (137, 16, 36),
            (108, 8, 28),
            (80, 4, 18),
            (52, 2, 10),
            (22, 2, 6),
        ),
        paddle=(0, 110, 110),
        paddle_top=(0, 140, 136),
        accent=(160, 20, 60),
        danger=(13, 105, 114),
    ),
}
VISIONS = ("full", *_DARK)
"""What a player may see: all colours, or all but those of one kind of cone."""
VISION_NAMES = {
    "full": tr_noop("normal"),
    "protanopia": tr_noop("no red (protanopia)"),
    "deuteranopia": tr_noop("no green (deuteranopia)"),
    "tritanopia": tr_noop("no blue (tritanopia)"),
}
"""Their names."""


def seen_by(vision: str, theme: Theme) -> Theme:
    """A theme in colours that a player tells apart; those on black are the dark theme's. vision: one of VISIONS."""
    if vision == VISIONS[0]:
        return theme
    return theme._replace(**(_LIGHT if theme == LIGHT else _DARK)[vision]._asdict())
