"""What stands in a slot, as a pile of slabs: pieces of the slot's sector with a bottom, a top and an inset all around.

The same terraces as the top-down picture draws, with a height each. A stack that was hit falls: its slabs are higher by the
drop that is left, and inset and colour follow the height, so that a slab that has landed is the one below of before.
"""

import math
from functools import lru_cache
from typing import NamedTuple

from game.drawing.flat.sector_colours import DOT_SHADE, GLOW, MOST_DOT, Kind, Look, dots, terrace
from game.drawing.palette import Colour, Theme, layer_colour, mixed

LAYER = 0.045
"""Height of one layer, in shares of the ground's radius: about a ball's."""
COMMON_LAYERS = 3
"""Stacks up to this height have terraces of the same width."""
_PADDLE = 0.7
"""Heights of a paddle and of what never breaks, in layers."""
_STEEL = 1.0
_FOOT, _SHADE = 0.35, 0.8
"""The shade at the foot of the next terrace: its reach, in terraces, and what it leaves of the colour."""


class Mark(NamedTuple):
    """A bar or a dot painted on a top: from one place to another, both a radius and an angle from the slot's middle."""

    inner: tuple[float, float]
    outer: tuple[float, float]
    half_width: float  # world units, along the arc


class Slab(NamedTuple):
    """One extruded annular sector, or with bottom = top something painted on one."""

    bottom: float  # world units
    top: float
    inset: float  # world units, from the slot's sector on all sides
    side_colour: Colour
    top_colour: Colour
    mark: Mark | None = None  # instead of the sector


class Slot(NamedTuple):
    """A slot's sector and what is to stand in it."""

    radius: float
    half_width: float
    half_angle: float
    tallest: int  # layers of the ring's highest stack that may ever stand there
    layer: float  # height of one, world units


@lru_cache(maxsize=512)
def slabs(look: Look, slot: Slot, drop: float, theme: Theme) -> tuple[Slab, ...]:
    """The slabs of a slot, from the lowest to the highest. drop: layers that its stack has still to fall."""
    match look.kind:
        case Kind.PADDLE:
            return _paddle(look, slot, theme)
        case Kind.BRICKS:
            return _stack(look, slot, drop, theme)
        case Kind.STEEL:
            return _steel(look, slot, theme)
        case Kind.GHOST:
            fade = look.glow / GLOW
            smallest = min(2.0 * slot.half_width, 2.0 * slot.half_angle * (slot.radius - slot.half_width)) / 2.0
            colour = mixed(theme.ground, theme.flash, 0.75 * fade)
            return (Slab(0.0, 0.0, (1.0 - fade) * smallest, colour, colour),)
    return ()


def _paddle(look: Look, slot: Slot, theme: Theme) -> tuple[Slab, ...]:
    """A low box with a lighter top."""
    top = _PADDLE * slot.layer
    edge, inner = _glowing(theme.paddle, look, theme), _glowing(theme.paddle_top, look, theme)
    return Slab(0.0, top, 0.0, edge, edge), Slab(top, top, 0.4 * slot.half_width, inner, inner)


def _stack(look: Look, slot: Slot, drop: float, theme: Theme) -> tuple[Slab, ...]:
    """A terrace per layer, each with the shade of the next on it."""
    step = terrace(slot.half_width, slot.half_angle, slot.radius - slot.half_width, max(slot.tallest, COMMON_LAYERS))
    pile: list[Slab] = []
    for index in range(look.layers):
        place = index + drop
        colour = _colour_at(theme, place)
        if index == look.layers - 1:
            colour = _glowing(colour, look, theme)
        top = (place + 1.0) * slot.layer
        pile.append(Slab(place * slot.layer, top, place * step, colour, colour))
        if index < look.layers - 1:
            shade = mixed((0, 0, 0), colour, _SHADE)
            pile.append(Slab(top, top, (place + 1.0 - _FOOT) * step, shade, shade))
    top, place = (look.layers + drop) * slot.layer, look.layers - 1.0 + drop
    dotted = _glowing(mixed(_colour_at(theme, place), theme.ground, DOT_SHADE), look, theme)
    inset = place * step
    for dot in dots(look.layers, slot.radius, slot.half_width - inset, slot.half_angle - inset / slot.radius, MOST_DOT):
        low, high = (dot.radius - dot.half, dot.angle), (dot.radius + dot.half, dot.angle)
        pile.append(Slab(top, top, 0.0, dotted, dotted, Mark(low, high, dot.half)))
    return tuple(pile)


def _colour_at(theme: Theme, place: float) -> Colour:
    """The colour of a layer at a height, in layers; between two while it falls from one to the other."""
    low = math.floor(place)
    return mixed(layer_colour(theme, low + 1), layer_colour(theme, low + 2), place - low)


def _steel(look: Look, slot: Slot, theme: Theme) -> tuple[Slab, ...]:
    """A block that carries a frame and a zigzag: the mark of what no hit breaks."""
    top, plain, line_colour = _STEEL * slot.layer, _glowing(theme.steel, look, theme), theme.steel_line
    margin, line = 0.24 * slot.half_width, 0.06
    pile = [
        Slab(0.0, top, 0.0, plain, plain),
        Slab(top, top, margin - line / 2.0, line_colour, line_colour),
        Slab(top, top, margin + line / 2.0, plain, plain),
    ]
    inside = 2.0 * (slot.half_width - margin)
    along = 2.0 * (slot.half_angle * slot.radius - margin)
    if inside > line and along > line:
        count = max(2, round(along / inside))
        ends = [(2.0 * k / count - 1.0) * (slot.half_angle - margin / slot.radius) for k in range(count + 1)]
        low, high = slot.radius - slot.half_width + margin, slot.radius + slot.half_width - margin
        for k in range(count):
            bar = (ends[k], ends[k + 1]) if k % 2 == 0 else (ends[k + 1], ends[k])
            pile.append(Slab(top, top, 0.0, line_colour, line_colour, Mark((low, bar[0]), (high, bar[1]), line / 2.0)))
    return tuple(pile)


def _glowing(colour: Colour, look: Look, theme: Theme) -> Colour:
    """The colour, on its way to the flash's."""
    return mixed(colour, theme.flash, 0.8 * look.glow / GLOW)
