"""What stands in a slot, as a pile of parts: their heights, insets and colours, the same for both views.

The flat view paints every part over those before it. The solid view raises the slabs and lays the rest on their tops. A stack
that lost its lowest layer falls by one layer. While it falls, inset and colour of every slab follow from its height, so that
nothing jumps: at the start of the fall each layer looks as it did before the hit, and at rest as the layer that was below it.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

from game.drawing.palette import Colour, Theme, layer_colour, mixed
from game.picture.slots.contents import GLOW_STEPS, ContentKind, SlotContent
from physics import Ring

WHOLE = math.pi * 0.999
"""Half angle from which a sector is a whole ring, which has no ends."""
LAYER_HEIGHT = 0.045
"""Height of one layer, in shares of the ground's radius: about a ball's."""
PADDLE_HEIGHT, STEEL_HEIGHT, SHIELD_HEIGHT = 0.7, 1.0, 0.5
"""Heights of a paddle, of what never breaks, and of the shield, in layers."""
DOT_SHADE = 0.6
"""Colour of the dots on a stack: this share of the way from the top's colour to the ground's."""
_MOST_DOT = 0.09
"""World units; half a dot's side where there is room."""

_GLOW = 0.8
"""At full glow, a colour is this share of the way to the flash's."""
_GHOST_GLOW = 0.75
"""The light of a brick that has gone: its share of the way from the ground's colour to the flash's, at first."""
_PADDLE_RIM = 0.4
"""Width of a paddle's darker edge, in half widths."""
_SECOND_SIDE = 0.45
"""The second player's paddle has the text's colour; its sides have this share of the way from there to the ground's."""
_KNOB, _KNOB_PITCH = 0.3, 3.0
"""Half the side of a dot on a sticky paddle, and from one to the next, in half widths."""
_TERRACE = 0.085
"""World units from one terrace's edge to the next, where there is room."""
_TERRACES_SHARE = 0.6
"""Share of the half width, or of half the length, that the terraces of the tallest stack take; the rest is its top."""
_COMMON_LAYERS = 3
"""Stacks up to this height have terraces of the same width."""
_SHADE_REACH, _SHADE_DARKNESS = 0.6, 0.4
"""Shade at the foot of a terrace: its reach, in terraces, and how much of the light it takes at the foot."""
_BUMPER_RIM, _BUMPER_CORE = 0.3, 0.55
"""Insets of a bumper's dark line and of its bright core, in half widths."""
_SHIELD_RIM = 0.35
"""Inset of a shield's bright line, in half widths."""
_SHIELD_LIGHT = 0.35
"""The shield's bright line is this share of the way from the paddles' colour to the text's."""
_SEAM = 0.16
"""Inset of the seam on bricks that grow again, in half widths."""
_FRAME_MARGIN = 0.24
"""From the edge of a steel block to the middle of its frame's line, in half widths."""
_FRAME_LINE, _BAR_LINE = 0.06, 0.05
"""World units; widths of the lines on steel: of the frame, and of the bars within."""
_DICE: dict[int, tuple[tuple[float, ...], ...]] = {
    2: ((-0.5, 0.5),),
    3: ((-1.0, 0.0, 1.0),),
    4: ((-0.5, 0.5),) * 2,
    5: ((-1.0, 0.0, 1.0), (-0.5, 0.5)),
    6: ((-1.0, 0.0, 1.0),) * 2,
    7: ((-1.5, -0.5, 0.5, 1.5), (-1.0, 0.0, 1.0)),
    8: ((-1.5, -0.5, 0.5, 1.5),) * 2,
    9: ((-1.0, 0.0, 1.0),) * 3,
}
"""Rows of dots for a number of layers, and the dots' positions along each row; more than nine layers look like nine."""


class SlotShape(NamedTuple):
    """The sector that a slot is, and what its parts are fitted to.

    radius, half_width: of the ring, world units.
    half_angle: radians.
    tallest: layers of the highest stack that may ever stand in the ring.
    finest: world units; no line is thinner: the size of a pixel, where lines are drawn pixel by pixel, else 0.
    """

    radius: float
    half_width: float
    half_angle: float
    tallest: int
    finest: float

    @property
    def inner_radius(self) -> float:
        """World units."""
        return self.radius - self.half_width

    @property
    def outer_radius(self) -> float:
        """World units."""
        return self.radius + self.half_width

    @property
    def terrace(self) -> float:
        """World units from one terrace's edge to the next, so that the ring's tallest stack keeps a top."""
        room = min(self.half_width, self.half_angle * self.inner_radius)
        return min(_TERRACE, _TERRACES_SHARE * room / max(self.tallest, _COMMON_LAYERS))


class Slab(NamedTuple):
    """The slot's sector, smaller by an inset on all sides; where bottom and top are the same, only painted.

    bottom, top: layers above the ground.
    inset: world units.
    colour: of the top; sides are the same in the shade.
    """

    bottom: float
    top: float
    inset: float
    colour: Colour


class FootShade(NamedTuple):
    """The shade on a terrace at the foot of the next one.

    top: of the terrace, layers above the ground.
    inset: of the next terrace, world units.
    reach: how far the shade goes outwards from there, world units.
    darkness: how much of the light it takes at the foot, 0 to 1; less and less farther out.
    colour: of the terrace.
    """

    top: float
    inset: float
    reach: float
    darkness: float
    colour: Colour


class Bar(NamedTuple):
    """A line or a dot painted on a top, straight from one end to the other in polar coordinates.

    top: layers above the ground.
    inner, outer: its two ends, each a radius in world units and an angle from the slot's middle in radians.
    half_width: along the arc, world units.
    colour: of all of it.
    """

    top: float
    inner: tuple[float, float]
    outer: tuple[float, float]
    half_width: float
    colour: Colour


Part = Slab | FootShade | Bar


def slot_shape(ring: Ring, tallest: int, finest: float) -> SlotShape:
    """The shape of a ring's slots. tallest, finest: as in `SlotShape`."""
    return SlotShape(ring.radius, ring.half_width, ring.half_angle, tallest, finest)


def height(content: SlotContent) -> float:
    """Layers from the ground to the top of what stands in a slot at rest."""
    heights = {
        ContentKind.PADDLE: PADDLE_HEIGHT,
        ContentKind.STICKY_PADDLE: PADDLE_HEIGHT,
        ContentKind.SECOND_PADDLE: PADDLE_HEIGHT,
        ContentKind.STICKY_SECOND_PADDLE: PADDLE_HEIGHT,
        ContentKind.STEEL: STEEL_HEIGHT,
        ContentKind.BUMPER: STEEL_HEIGHT,
        ContentKind.SHIELD: SHIELD_HEIGHT,
    }
    return heights.get(content.kind, float(content.layers))


@lru_cache(maxsize=512)
def parts(content: SlotContent, shape: SlotShape, drop: float, theme: Theme) -> tuple[Part, ...]:
    """What stands in a slot, from the lowest part to the highest. drop: layers that a stack has still to fall."""
    if content.kind in _STACKS:
        return _stack(content, shape, drop, theme)
    pile = _PILES.get(content.kind)
    return () if pile is None else pile(content, shape, theme)


def dots(layers: int, top: SlotShape) -> list[tuple[float, float, float]]:
    """As many dots as layers, laid out as on dice so that nobody has to count; none for one layer.

    Each is the radius and the angle of its middle, and half its side. top: the top of the stack.
    """
    rows = _DICE.get(min(layers, max(_DICE)), ())
    if not rows or top.half_width <= 0.0 or top.half_angle <= 0.0:
        return []
    along = 2.0 * top.half_angle * top.radius / max([len(row) for row in rows])
    across = 2.0 * top.half_width / len(rows)
    half = min(0.3 * min(along, across), _MOST_DOT)
    pitch, row_pitch = min(4.0 * half, along) / top.radius, min(4.0 * half, across)
    middle = (len(rows) - 1) / 2.0
    return [(top.radius + (k - middle) * row_pitch, position * pitch, half) for k, row in enumerate(rows) for position in row]


def _paddle(content: SlotContent, shape: SlotShape, theme: Theme) -> tuple[Part, ...]:
    """A low box with a lighter top."""
    rim = max(_PADDLE_RIM * shape.half_width, shape.finest)
    second = content.kind in (ContentKind.SECOND_PADDLE, ContentKind.STICKY_SECOND_PADDLE)
    side, top = (mixed(theme.text, theme.ground, _SECOND_SIDE), theme.text) if second else (theme.paddle, theme.paddle_top)
    return (
        Slab(0.0, PADDLE_HEIGHT, 0.0, _glowing(side, content, theme)),
        Slab(PADDLE_HEIGHT, PADDLE_HEIGHT, rim, _glowing(top, content, theme)),
    )


def _sticky_paddle(content: SlotContent, shape: SlotShape, theme: Theme) -> tuple[Part, ...]:
    """A paddle with a line of dots along its middle, which hold the ball."""
    half, radius = max(_KNOB * shape.half_width, shape.finest), shape.radius
    count = max(int(shape.half_angle * radius / (_KNOB_PITCH * shape.half_width)), 1)
    end = shape.half_angle * (1.0 - 1.0 / count)
    knobs = [_dot(PADDLE_HEIGHT, radius, angle, half, theme.ground) for angle in _spread(end, count)]
    return (*_paddle(content, shape, theme), *knobs)


def _dot(top: float, radius: float, angle: float, half: float, colour: Colour) -> Bar:
    """A square dot. half: half its side, world units."""
    return Bar(top, (radius - half, angle), (radius + half, angle), half, colour)


def _spread(end: float, count: int) -> list[float]:
    """Angles from -end to end at equal distances."""
    return [end * (2.0 * k / (count - 1) - 1.0) for k in range(count)] if count > 1 else [0.0]


def _stack(content: SlotContent, shape: SlotShape, drop: float, theme: Theme) -> tuple[Part, ...]:
    """A terrace per layer, each with the shade of the next on it, and dots on the top that tell how many they are."""
    step = shape.terrace
    pile: list[Part] = []
    for layer in range(content.layers):
        bottom, last = layer + drop, layer == content.layers - 1
        colour = _colour_at(theme, content.tint + bottom)
        if last:
            colour = _glowing(colour, content, theme)
        pile.append(Slab(bottom, bottom + 1.0, bottom * step, colour))
        if not last:
            reach = max(_SHADE_REACH * step, shape.finest)
            pile.append(FootShade(bottom + 1.0, (bottom + 1.0) * step, reach, _SHADE_DARKNESS, colour))
    highest = content.layers - 1.0 + drop
    top_colour = _colour_at(theme, content.tint + highest)
    if content.kind is ContentKind.GROWING:
        pile += _seam(_glowing(top_colour, content, theme), highest * step, highest + 1.0, shape, theme)
    dotted = _glowing(mixed(top_colour, theme.ground, DOT_SHADE), content, theme)
    inset = highest * step
    top = shape._replace(half_width=shape.half_width - inset, half_angle=shape.half_angle - inset / shape.radius)
    for radius, angle, half in dots(content.layers, top):
        pile.append(_dot(highest + 1.0, radius, angle, half, dotted))
    return tuple(pile)


def _steel(content: SlotContent, shape: SlotShape, theme: Theme) -> tuple[Part, ...]:
    """A block with a truss on it, a frame and a zigzag: the mark of what no hit breaks."""
    top, plain = STEEL_HEIGHT, _glowing(theme.steel, content, theme)
    margin, line = _FRAME_MARGIN * shape.half_width, max(_FRAME_LINE, shape.finest)
    block = Slab(0.0, top, 0.0, plain)
    frame = Slab(top, top, margin - line / 2.0, theme.steel_line)
    within = Slab(top, top, margin + line / 2.0, plain)
    return block, frame, within, *_zigzag(shape, margin, max(_BAR_LINE, shape.finest), theme.steel_line)


def _seam(colour: Colour, inset: float, top: float, shape: SlotShape, theme: Theme) -> tuple[Slab, Slab]:
    """A bright frame on the top of bricks that grow again. colour, inset, top: of the highest layer."""
    inset, line = inset + _SEAM * shape.half_width, max(_FRAME_LINE, shape.finest)
    return Slab(top, top, inset, theme.accent), Slab(top, top, inset + line, colour)


def _bumper(content: SlotContent, shape: SlotShape, theme: Theme) -> tuple[Part, ...]:
    """A steel block with a bright core that says: hit me."""
    top = STEEL_HEIGHT
    return (
        Slab(0.0, top, 0.0, _glowing(theme.steel, content, theme)),
        Slab(top, top, max(_BUMPER_RIM * shape.half_width, shape.finest), theme.steel_line),
        Slab(top, top, max(_BUMPER_CORE * shape.half_width, 2.0 * shape.finest), _glowing(theme.accent, content, theme)),
    )


def _shield(content: SlotContent, shape: SlotShape, theme: Theme) -> tuple[Part, ...]:
    """A low wall of light."""
    bright = _glowing(mixed(theme.paddle_top, theme.text, _SHIELD_LIGHT), content, theme)
    return (
        Slab(0.0, SHIELD_HEIGHT, 0.0, _glowing(theme.paddle, content, theme)),
        Slab(SHIELD_HEIGHT, SHIELD_HEIGHT, max(_SHIELD_RIM * shape.half_width, shape.finest), bright),
    )


def _zigzag(shape: SlotShape, margin: float, line: float, colour: Colour) -> list[Bar]:
    """Bars from side to side of a frame, each about as long along the frame as across it; none in a frame as thin as a line."""
    across, along = 2.0 * (shape.half_width - margin), 2.0 * (shape.half_angle * shape.radius - margin)
    if min(across, along) <= line:
        return []
    count = max(2, round(along / across))
    half_width = line / 2.0 * math.hypot(across, along / count) / across
    end = shape.half_angle - margin / shape.radius
    angles = [(2.0 * k / count - 1.0) * end for k in range(count + 1)]
    low, high = shape.inner_radius + margin, shape.outer_radius - margin
    bars = []
    for k in range(count):
        inner, outer = (angles[k], angles[k + 1]) if k % 2 == 0 else (angles[k + 1], angles[k])
        bars.append(Bar(STEEL_HEIGHT, (low, inner), (high, outer), half_width, colour))
    return bars


def _ghost(content: SlotContent, shape: SlotShape, theme: Theme) -> tuple[Part, ...]:
    """A patch of light on the ground that shrinks and fades."""
    strength = content.glow / GLOW_STEPS
    half_length = min(shape.half_width, shape.half_angle * shape.inner_radius)
    return (Slab(0.0, 0.0, (1.0 - strength) * half_length, mixed(theme.ground, theme.flash, _GHOST_GLOW * strength)),)


_STACKS = frozenset({ContentKind.BRICKS, ContentKind.GROWING})
_PILES: dict[ContentKind, Callable[[SlotContent, SlotShape, Theme], tuple[Part, ...]]] = {
    ContentKind.PADDLE: _paddle,
    ContentKind.STICKY_PADDLE: _sticky_paddle,
    ContentKind.SECOND_PADDLE: _paddle,
    ContentKind.STICKY_SECOND_PADDLE: _sticky_paddle,
    ContentKind.STEEL: _steel,
    ContentKind.BUMPER: _bumper,
    ContentKind.SHIELD: _shield,
    ContentKind.GHOST: _ghost,
}
"""What stands in a slot besides stacks, by its kind."""


def _colour_at(theme: Theme, bottom: float) -> Colour:
    """The colour of a layer whose bottom is so many layers above the ground, tint added; between two layers' as it falls."""
    low = math.floor(bottom)
    return mixed(layer_colour(theme, low + 1), layer_colour(theme, low + 2), bottom - low)


def _glowing(colour: Colour, content: SlotContent, theme: Theme) -> Colour:
    """A colour in the light of a hit."""
    return mixed(colour, theme.flash, _GLOW * content.glow / GLOW_STEPS)
