"""The signs of power-ups: a shape of its own for each, on a chip that says whether it helps.

Chips that help are round and those that harm are pointed, so nobody needs to see colours. Shapes are outlines in a square from
-1 to 1, y upwards.
"""

import cmath
import math
from typing import NamedTuple

from game.drawing.palette import Colour, Theme, luminance
from game.rules import HARMFUL, PowerUp

_EDGE = 0.12
"""Width of a chip's edge, in shares of its radius."""
_SHAPE = 0.62
"""Half the side of the square that a sign has, in shares of its chip's radius."""

Outline = tuple[complex, ...]


class SignShape(NamedTuple):
    """A filled outline of a chip or of its sign. outline: in radii of the chip."""

    outline: Outline
    colour: Colour


def _disc(middle: complex, radius: float, corners: int = 20) -> Outline:
    """A disc as an outline."""
    return tuple([middle + radius * cmath.exp(1j * math.tau * k / corners) for k in range(corners)])


def _box(left: float, bottom: float, right: float, top: float) -> Outline:
    """A rectangle."""
    return complex(left, bottom), complex(right, bottom), complex(right, top), complex(left, top)


def _arc(inner: float, outer: float, start: float, end: float) -> Outline:
    """A piece of a ring, its angles in degrees."""
    angles = [math.radians(start + (end - start) * k / 16) for k in range(17)]
    there = [cmath.rect(outer, angle) for angle in angles]
    return (*there, *[cmath.rect(inner, angle) for angle in reversed(angles)])


def _moved(outline: Outline, offset: complex) -> Outline:
    """An outline somewhere else."""
    return tuple([point + offset for point in outline])


def _mirrored(outline: Outline) -> Outline:
    """An outline, left and right swapped."""
    return tuple([complex(-point.real, point.imag) for point in outline])


_CHEVRON: Outline = (-0.1 + 0.75j, 0.25 + 0.75j, 0.8 + 0j, 0.25 - 0.75j, -0.1 - 0.75j, 0.42 + 0j)
_POINTER: Outline = (0.35 + 0.45j, 0.95 + 0j, 0.35 - 0.45j)
_HEART: Outline = (
    *[complex(-0.45, 0.3) + 0.46 * cmath.exp(1j * math.radians(40 + 12 * k)) for k in range(16)],
    -0.92j,
    *[complex(0.45, 0.3) + 0.46 * cmath.exp(1j * math.radians(-40 + 12 * k)) for k in range(16)],
)
_SIGNS: dict[PowerUp, tuple[Outline, ...]] = {
    PowerUp.MULTI_BALL: (_disc(0.55j, 0.36), _disc(-0.52 - 0.38j, 0.36), _disc(0.52 - 0.38j, 0.36)),
    PowerUp.WIDE: (_box(-0.5, -0.16, 0.5, 0.16), _POINTER, _mirrored(_POINTER)),
    PowerUp.NARROW: (
        _box(-0.16, -0.7, 0.16, 0.7),
        _moved(_mirrored(_POINTER), 1.22 + 0j),
        _moved(_POINTER, -1.22 + 0j),
    ),
    PowerUp.SLOW: (_mirrored(_moved(_CHEVRON, 0.1 + 0j)), _mirrored(_moved(_CHEVRON, -0.62 + 0j))),
    PowerUp.FAST: (_moved(_CHEVRON, 0.1 + 0j), _moved(_CHEVRON, -0.62 + 0j)),
    PowerUp.STICKY: (
        _moved(_arc(0.36, 0.82, 180.0, 360.0), -0.05j),
        _box(-0.82, -0.05, -0.36, 0.35),
        _box(0.36, -0.05, 0.82, 0.35),
        _box(-0.82, 0.48, -0.36, 0.8),
        _box(0.36, 0.48, 0.82, 0.8),
    ),
    PowerUp.LIFE: (_HEART,),
    PowerUp.SHIELD: (_arc(0.66, 0.95, 0.0, 180.0), _arc(0.66, 0.95, 180.0, 360.0), _disc(0j, 0.3)),
    PowerUp.PIERCE: (
        (0.95j, 0.5 + 0.3j, 0.17 + 0.3j, 0.17 - 0.9j, -0.17 - 0.9j, -0.17 + 0.3j, -0.5 + 0.3j),
        _box(-0.9, -0.42, -0.34, -0.14),
        _box(0.34, -0.42, 0.9, -0.14),
    ),
}
"""What a power-up's sign is made of."""
_COLOURS: dict[PowerUp, Colour] = {
    PowerUp.MULTI_BALL: (255, 209, 102),
    PowerUp.WIDE: (112, 224, 144),
    PowerUp.NARROW: (255, 120, 108),
    PowerUp.SLOW: (124, 196, 255),
    PowerUp.FAST: (255, 142, 72),
    PowerUp.STICKY: (198, 160, 255),
    PowerUp.LIFE: (255, 140, 190),
    PowerUp.SHIELD: (96, 226, 226),
    PowerUp.PIERCE: (255, 244, 176),
}
_COLOURS_ON_LIGHT: dict[PowerUp, Colour] = {
    PowerUp.MULTI_BALL: (188, 112, 0),
    PowerUp.WIDE: (0, 138, 66),
    PowerUp.NARROW: (214, 32, 40),
    PowerUp.SLOW: (0, 108, 224),
    PowerUp.FAST: (224, 78, 0),
    PowerUp.STICKY: (124, 62, 222),
    PowerUp.LIFE: (222, 26, 122),
    PowerUp.SHIELD: (0, 134, 156),
    PowerUp.PIERCE: (112, 88, 20),
}
"""The same hues, as bright as a contrast of 3 to a light ground allows."""
_INK: Colour = (14, 16, 26)
_PAPER: Colour = (255, 255, 255)


def power_colour(kind: PowerUp, theme: Theme) -> Colour:
    """The colour of a power-up's chip, in contrast to the ground."""
    return (_COLOURS if luminance(theme.ground) < 0.5 else _COLOURS_ON_LIGHT)[kind]


def chip(kind: PowerUp, theme: Theme) -> tuple[SignShape, ...]:
    """A power-up's chip with its sign, from the back to the front."""
    colour = power_colour(kind, theme)
    ink = _INK if luminance(colour) > 0.3 else _PAPER
    edge = _star() if kind in HARMFUL else _disc(0j, 1.0, 64)
    shapes = [SignShape(edge, ink), SignShape(_scaled(edge, 1.0 - _EDGE), colour)]
    share = _SHAPE * (0.88 if kind in HARMFUL else 1.0)
    return (*shapes, *[SignShape(_scaled(outline, share), ink) for outline in _SIGNS[kind]])


def _scaled(outline: Outline, share: float) -> Outline:
    """An outline, larger or smaller."""
    return tuple([point * share for point in outline])


def _star() -> Outline:
    """A star of eight points, blunt: it looks as if it pricked."""
    return tuple([cmath.rect(1.0 if k % 2 == 0 else 0.8, math.tau * k / 16.0) for k in range(16)])
