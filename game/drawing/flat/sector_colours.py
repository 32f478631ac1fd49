"""The parts of a slot as colours of pixels in polar coordinates: the flat view's drawing of them.

Edges are anti-aliased exactly: how deep a pixel's middle lies inside a sector says how much of the pixel is covered. The light
of this view stands over the arena's centre. Pictures are three planes, red, green and blue, 0 to 255: so inner loops are long.
"""

from typing import NamedTuple

import numpy as np

from game.drawing.palette import Colour
from game.drawing.raster.annulus import Floats
from game.drawing.slots.parts import Bar, FootShade, Part, Slab, SlotShape

_WHOLE = np.pi * 0.999
"""Half angle from which a sector is a whole ring, which has no ends."""
_EDGE, _LEAST_EDGE = 0.22, 1.5
"""Width of a sector's edge that catches the light: in half widths, and at least so many pixels."""
_EDGE_LIGHT, _SLOPE = 0.34, 0.10
"""Share of the way to white, or to black, of the edge and of the rest."""
_END_FACING = 0.25
"""How much of the light a sector's ends catch."""
_INWARDS, _ASIDE = 0.3, 0.6
"""How far a shadow goes towards the centre and beyond the ends, in shares of its reach outwards."""


class PolarPixels(NamedTuple):
    """Where the pixels of a picture are in a slot.

    scale: pixels per world unit.
    radius: of each pixel, pixels.
    angle: of each pixel from the slot's middle, -pi to pi; together with radius it broadcasts to the picture's planes.
    """

    scale: float
    radius: Floats
    angle: Floats


class Shadow(NamedTuple):
    """A shadow on the ground.

    reach: how far it goes outwards, world units.
    half_pitch: half the angle from one slot to the next, radians: no shadow goes beyond.
    darkness: share of the light that it takes where it is darkest.
    """

    reach: float
    half_pitch: float
    darkness: float


def paint_parts(picture: Floats, parts: tuple[Part, ...], shape: SlotShape, pixels: PolarPixels) -> None:
    """Paint the parts of a slot over a picture, in place."""
    depth = _depth(shape, pixels)
    for part in parts:
        match part:
            case Slab():
                _paint(picture, depth - np.float32(part.inset * pixels.scale), part.colour)
            case FootShade():
                _shade(picture, depth, part, pixels.scale)
            case Bar():
                _paint_bar(picture, part, pixels)


def paint_shadow(picture: Floats, shape: SlotShape, pixels: PolarPixels, shadow: Shadow) -> None:
    """Darken the ground around a sector and beyond its outer face, in place."""
    scale, radius = pixels.scale, pixels.radius
    reach = np.float32(max(shadow.reach * scale, 1e-3))
    inside, beyond = radius - np.float32(shape.inner_radius * scale), radius - np.float32(shape.outer_radius * scale)
    share = np.minimum(inside / (np.float32(_INWARDS) * reach) + 1.0, 1.0 - beyond / reach)
    share = np.square(np.clip(share, 0.0, 1.0))
    if shape.half_angle < _WHOLE:
        gap = (shadow.half_pitch - shape.half_angle) * shape.radius * scale
        aside = (np.abs(pixels.angle) - np.float32(shape.half_angle)) * radius
        share = share * np.clip(1.0 - aside / np.float32(max(min(_ASIDE * shadow.reach * scale, gap), 1.0)), 0.0, 1.0)
    picture *= 1.0 - np.float32(shadow.darkness) * share


def paint_light(picture: Floats, shape: SlotShape, pixels: PolarPixels, strength: float) -> None:
    """The light on what stands in a slot, in place: its inner edge is bright, its outer one dark, and all between slopes.

    strength: 0 to 1.
    """
    scale, half_width = pixels.scale, np.float32(shape.half_width * pixels.scale)
    out = np.clip((pixels.radius - np.float32(shape.radius * scale)) / half_width, -1.0, 1.0)
    depth = _depth(shape, pixels)
    edge = np.clip(1.0 - depth / np.float32(max(_EDGE * shape.half_width * scale, _LEAST_EDGE)), 0.0, 1.0)
    at_face = half_width * (1.0 - np.abs(out)) - depth < 0.5
    facing = np.where(at_face, -np.sign(out), np.float32(_END_FACING))
    light = np.float32(_EDGE_LIGHT * strength) * edge * facing - np.float32(_SLOPE * strength) * out
    light *= np.clip(depth + 0.5, 0.0, 1.0)
    picture *= 1.0 - np.abs(light)
    picture += 255.0 * np.maximum(light, 0.0)


def _depth(shape: SlotShape, pixels: PolarPixels) -> Floats:
    """How far inside the sector a pixel is from its nearest side, pixels; negative outside."""
    scale, radius, angle = pixels
    radial = np.minimum(radius - shape.inner_radius * scale, shape.outer_radius * scale - radius).astype(np.float32)
    if shape.half_angle >= _WHOLE:
        return np.broadcast_to(radial, np.broadcast_shapes(radius.shape, angle.shape))
    ends = radius * np.sin(np.clip(shape.half_angle - np.abs(angle), -np.pi / 2.0, np.pi / 2.0))
    return np.asarray(np.minimum(radial, ends), dtype=np.float32)


def _paint(picture: Floats, depth: Floats, colour: Colour) -> None:
    """Cover what lies inside by a colour, pixels on the border in part. depth: pixels from the border inwards."""
    cover = np.clip(depth + np.float32(0.5), 0.0, 1.0)
    for plane, channel in zip(picture, colour, strict=True):
        np.add(plane, (np.float32(channel) - plane) * cover, out=plane)


def _shade(picture: Floats, depth: Floats, part: FootShade, scale: float) -> None:
    """Darken a terrace towards the foot of the next one."""
    past_foot = depth - np.float32(part.inset * scale)
    share = np.clip(1.0 + past_foot / np.float32(part.reach * scale), 0.0, 1.0) * (depth > 0.0)
    picture *= 1.0 - np.float32(part.darkness) * share


def _paint_bar(picture: Floats, bar: Bar, pixels: PolarPixels) -> None:
    """Paint a bar or a dot, looking only at the columns of pixels that it can reach."""
    scale, radius, angle = pixels
    (inner, start), (outer, end) = bar.inner, bar.outer
    low, high = inner * scale, outer * scale
    near = np.abs(angle - (start + end) / 2.0) < abs(end - start) / 2.0 + (bar.half_width + 1.0 / scale) / inner
    columns = np.flatnonzero(near)
    if not len(columns):
        return
    part = slice(int(columns[0]), int(columns[-1]) + 1)
    angle, radius = angle[..., part], radius if radius.shape[-1] == 1 else radius[..., part]
    path = start + (end - start) * (radius - low) / (high - low)
    lean = (end - start) * (inner + outer) / 2.0 / (outer - inner)
    across = (bar.half_width * scale - radius * np.abs(angle - path)) / np.hypot(1.0, lean)
    ends = np.minimum(radius - low, high - radius)
    _paint(picture[..., part], np.minimum(across, ends).astype(np.float32), bar.colour)
