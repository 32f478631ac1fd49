"""The parts of a slot as colours of pixels in polar coordinates: the flat view's drawing of them.

Edges are anti-aliased exactly: how deep a pixel's middle lies inside a sector says how much of the pixel is covered.
"""

import numpy as np

from game.drawing.palette import Colour
from game.drawing.raster.annulus import Floats
from game.drawing.slots.parts import Bar, FootShade, Part, Slab, SlotShape

_WHOLE = np.pi * 0.999
"""Half angle from which a sector is a whole ring, which has no ends."""


def paint_parts(
    picture: Floats, parts: tuple[Part, ...], shape: SlotShape, scale: float, radius: Floats, angle: Floats
) -> None:
    """Paint the parts of a slot over a picture, in place.

    picture: red, green and blue, 0 to 255, along its last axis; the axes before are those that radius and angle broadcast to.
    scale: pixels per world unit. radius: of each pixel, pixels. angle: of each pixel from the slot's middle, -pi to pi, one
    for each column of the picture.
    """
    depth = _depth(shape, scale, radius, angle)
    for part in parts:
        match part:
            case Slab():
                _paint(picture, depth - np.float32(part.inset * scale), part.colour)
            case FootShade():
                _shade(picture, depth, part, scale)
            case Bar():
                _paint_bar(picture, part, scale, radius, angle)


def paint_circle(picture: Floats, width: float, middle: float, radius: Floats, colour: Colour) -> None:
    """Paint a circle over a picture, in place. All in pixels; width: of its line; middle: its radius; radius: of each pixel."""
    _paint(picture, (width / 2.0 - np.abs(radius - middle)).astype(np.float32), colour)


def _depth(shape: SlotShape, scale: float, radius: Floats, angle: Floats) -> Floats:
    """How far inside the sector a pixel is from its nearest side, pixels; negative outside."""
    radial = np.minimum(radius - shape.inner_radius * scale, shape.outer_radius * scale - radius).astype(np.float32)
    if shape.half_angle >= _WHOLE:
        return np.broadcast_to(radial, np.broadcast_shapes(radius.shape, angle.shape))
    ends = radius * np.sin(np.clip(shape.half_angle - np.abs(angle), -np.pi / 2.0, np.pi / 2.0))
    return np.asarray(np.minimum(radial, ends), dtype=np.float32)


def _paint(picture: Floats, depth: Floats, colour: Colour) -> None:
    """Cover what lies inside by a colour, pixels on the border in part. depth: pixels from the border inwards."""
    cover = np.clip(depth + np.float32(0.5), 0.0, 1.0)[..., None]
    picture += (np.array(colour, dtype=np.float32) - picture) * cover


def _shade(picture: Floats, depth: Floats, part: FootShade, scale: float) -> None:
    """Darken a terrace towards the foot of the next one."""
    past_foot = depth - np.float32(part.inset * scale)
    share = np.clip(1.0 + past_foot / np.float32(part.reach * scale), 0.0, 1.0) * (depth > 0.0)
    picture *= (1.0 - np.float32(part.darkness) * share)[..., None].astype(np.float32)


def _paint_bar(picture: Floats, bar: Bar, scale: float, radius: Floats, angle: Floats) -> None:
    """Paint a bar or a dot, looking only at the columns of pixels that it can reach."""
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
    _paint(picture[..., part, :], np.minimum(across, ends).astype(np.float32), bar.colour)
