"""What stands in a slot as colours of pixels in polar coordinates: the flat view's painting of `game.picture.slots`' lists.

Edges are anti-aliased exactly: how deep a pixel's middle lies inside a sector says how much of the pixel is covered. Pictures
are three planes, red, green and blue, 0 to 255: so inner loops are long.
"""

import math
from array import array
from typing import NamedTuple

import numpy as np

from game.drawing.palette import Colour
from game.drawing.raster.annulus import Floats
from game.picture.display_list import DisplayList
from game.picture.primitives import Primitive, primitives, unpacked

_SECTOR_NUMBERS = 6
"""Numbers of a sector, without its inset, at the beginning of a primitive's own."""


class PolarPixels(NamedTuple):
    """Where the pixels of a picture are in a slot.

    radius: of each pixel, pixels.
    angle: of each pixel from the slot's middle, -pi to pi; together with radius it broadcasts to the picture's planes.
    """

    radius: Floats
    angle: Floats


class _SectorPixels(NamedTuple):
    """A sector about the slot's middle, and the pixels in it.

    inner, outer: radii, pixels; half_angle: pi for a whole ring.
    depth: how far inside a pixel is from the nearest side, pixels; negative outside.
    """

    inner: float
    outer: float
    half_angle: float
    depth: Floats


def paint_slot(picture: Floats, slot: DisplayList, pixels: PolarPixels) -> None:
    """Paint a list of what is in a slot over a picture, in place. slot: about the centre 0, the slot's middle at angle 0."""
    own_numbers, sector = array("f"), None
    for code, packed, opacity, own in primitives(slot.numbers):
        if code == Primitive.BAR:
            _paint_bar(picture, unpacked(packed), own, pixels)
            continue
        if sector is None or own[:_SECTOR_NUMBERS] != own_numbers:
            own_numbers, sector = own[:_SECTOR_NUMBERS], _sector(own, pixels)
        rest = own[_SECTOR_NUMBERS:].tolist()
        match code:
            case Primitive.SECTOR:
                _paint(picture, sector.depth - np.float32(rest[0]), unpacked(packed))
            case Primitive.FOOT:
                _paint_foot(picture, sector, rest, opacity)
            case Primitive.RELIEF:
                _paint_relief(picture, sector, rest, pixels, opacity)
            case Primitive.CAST:
                _paint_cast(picture, sector, rest, pixels, opacity)
            case _:
                raise ValueError(f"no slot has {Primitive(code).name}")


def _sector(own: "array[float]", pixels: PolarPixels) -> _SectorPixels:
    """The sector that a primitive begins with."""
    _x, _y, inner, outer, _angle, half_angle = own[:_SECTOR_NUMBERS]
    radius, angle = pixels
    depth = np.minimum(radius - inner, outer - radius).astype(np.float32)
    if half_angle >= math.pi:
        return _SectorPixels(inner, outer, half_angle, np.broadcast_to(depth, np.broadcast_shapes(radius.shape, angle.shape)))
    ends = radius * np.sin(np.clip(half_angle - np.abs(angle), -np.pi / 2.0, np.pi / 2.0))
    return _SectorPixels(inner, outer, half_angle, np.asarray(np.minimum(depth, ends), dtype=np.float32))


def _paint(picture: Floats, depth: Floats, colour: Colour) -> None:
    """Cover what lies inside by a colour, pixels on the border in part. depth: pixels from the border inwards."""
    cover = np.clip(depth + np.float32(0.5), 0.0, 1.0)
    for plane, channel in zip(picture, colour, strict=True):
        np.add(plane, (np.float32(channel) - plane) * cover, out=plane)


def _paint_foot(picture: Floats, sector: _SectorPixels, own: list[float], opacity: float) -> None:
    """Darken a sector towards the foot of a smaller one."""
    inset, reach = own
    past_foot = sector.depth - np.float32(inset)
    share = np.clip(1.0 + past_foot / np.float32(reach), 0.0, 1.0) * (sector.depth > 0.0)
    picture *= 1.0 - np.float32(opacity) * share


def _paint_cast(picture: Floats, sector: _SectorPixels, own: list[float], pixels: PolarPixels, opacity: float) -> None:
    """Darken the ground around a sector."""
    inwards, outwards, aside = map(np.float32, own)
    radius, angle = pixels
    inside, outside = radius - np.float32(sector.inner), radius - np.float32(sector.outer)
    share = np.square(np.clip(np.minimum(inside / inwards + 1.0, 1.0 - outside / outwards), 0.0, 1.0))
    if sector.half_angle < math.pi:
        beyond = (np.abs(angle) - np.float32(sector.half_angle)) * radius
        share = share * np.clip(1.0 - beyond / aside, 0.0, 1.0)
    picture *= 1.0 - np.float32(opacity) * share


def _paint_relief(picture: Floats, sector: _SectorPixels, own: list[float], pixels: PolarPixels, opacity: float) -> None:
    """Lighten and darken a sector: pixels at its border as far as they are covered."""
    edge, at_faces, at_ends, slope = own
    depth, half_width = sector.depth, np.float32((sector.outer - sector.inner) / 2.0)
    out = np.clip((pixels.radius - np.float32((sector.inner + sector.outer) / 2.0)) / half_width, -1.0, 1.0)
    at_side = np.clip(1.0 - depth / np.float32(edge), 0.0, 1.0)
    at_face = half_width * (1.0 - np.abs(out)) - depth < 0.5
    strength = np.where(at_face, np.float32(-at_faces * opacity) * np.sign(out), np.float32(at_ends * opacity))
    light = strength * at_side - np.float32(slope * opacity) * out
    light *= np.clip(depth + 0.5, 0.0, 1.0)
    picture *= 1.0 - np.abs(light)
    picture += 255.0 * np.maximum(light, 0.0)


def _paint_bar(picture: Floats, colour: Colour, own: "array[float]", pixels: PolarPixels) -> None:
    """Paint a bar or a dot, looking only at the columns of pixels that it can reach."""
    _x, _y, _angle, low, start, high, end, half_width = own
    radius, angle = pixels
    near = np.abs(angle - (start + end) / 2.0) < abs(end - start) / 2.0 + (half_width + 1.0) / low
    columns = np.flatnonzero(near)
    if not len(columns):
        return
    part = slice(int(columns[0]), int(columns[-1]) + 1)
    angle, radius = angle[..., part], radius if radius.shape[-1] == 1 else radius[..., part]
    path = start + (end - start) * (radius - low) / (high - low)
    lean = (end - start) * (low + high) / 2.0 / (high - low)
    across = (half_width - radius * np.abs(angle - path)) / np.hypot(1.0, lean)
    ends = np.minimum(radius - low, high - radius)
    _paint(picture[..., part], np.minimum(across, ends).astype(np.float32), colour)
