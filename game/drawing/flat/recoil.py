"""A struck paddle out of its slot, from straight above: the parts of a paddle, painted pixel by pixel a little farther out.

The pixels of the paddles' band are sorted by angle: a paddle's are one or two runs of them, wherever it is.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.canvas import Canvas
from game.drawing.flat.sector_colours import PolarPixels, paint_light, paint_parts
from game.drawing.raster.annulus import Floats, annulus_pixels
from game.drawing.raster.pixels import packed, pixels_of, unpacked
from game.drawing.slots.contents import ContentKind, SlotContent
from game.drawing.slots.parts import parts, slot_shape
from game.effects import Recoil
from physics import Ring

_FARTHEST = 0.05
"""Share of the paddles' radius; beyond it a recoil is cut off."""
_ANGLE_STEPS = np.float32(65535.0 / math.tau)
"""Per radian, for sorting: finer than any pixel."""


class _PaddlePixels(NamedTuple):
    """The pixels that a paddle may cover, sorted by angle.

    key: what they depend on.
    pixel: its index in the surface's memory, row after row.
    radius: of its middle, pixels.
    angle: of its middle, radians in [0, 2 pi).
    """

    key: tuple[object, ...]
    pixel: NDArray[np.int64]
    radius: Floats
    angle: Floats


class RecoilPicture:
    """Draws paddles out of their slots; remembers where their pixels are."""

    def __init__(self) -> None:
        """Start with nothing remembered."""
        self._pixels: _PaddlePixels | None = None

    def prepare(self, canvas: Canvas, ring: Ring) -> None:
        """Find the pixels of the paddles' track where they are not known, so that the first hit costs no more than the next."""
        self._pixels_near(canvas, ring)

    def draw(self, canvas: Canvas, ring: Ring, recoil: Recoil, content: SlotContent) -> None:
        """One paddle on a 32-bit surface. ring: the paddles in their slots; content: of the slot that is struck."""
        scale = canvas.camera.scale
        pixels = self._pixels_near(canvas, ring)
        middle, margin = ring.angle(recoil.slot), 2.0 / max(scale * ring.radius, 1.0)
        rows = _between(pixels.angle, middle - ring.half_angle - margin, middle + ring.half_angle + margin)
        index = pixels.pixel[rows]
        angle = ((pixels.angle[rows] - middle + math.pi) % math.tau - math.pi).astype(np.float32)
        radius = pixels.radius[rows] - np.float32(min(recoil.out, _FARTHEST * ring.radius) * scale)
        shape = slot_shape(ring, 0, 1.0 / scale)
        memory = pixels_of(canvas.surface)
        picture = np.ascontiguousarray(unpacked(canvas.surface, memory[index]).T)
        where = PolarPixels(scale, radius, angle)
        paint_parts(picture, parts(content, shape, 0.0, canvas.theme), shape, where)
        paint_light(picture, shape, where, canvas.theme.relief)
        memory[index] = packed(canvas.surface, picture.T)

    def _pixels_near(self, canvas: Canvas, ring: Ring) -> _PaddlePixels:
        """The pixels around the paddles' track."""
        surface, camera = canvas.surface, canvas.camera
        key = (canvas.size, surface.get_pitch(), camera, ring.radius, ring.half_width)
        if self._pixels is None or self._pixels.key != key:
            outer = (ring.outer_radius + _FARTHEST * ring.radius) * camera.scale + 1.0
            inner = max((ring.inner_radius - _FARTHEST * ring.radius) * camera.scale - 1.0, 0.0)
            found = annulus_pixels(canvas.size, surface.get_pitch() // 4, camera.centre, inner, outer)
            order = np.argsort((found.angle * _ANGLE_STEPS).astype(np.uint16), kind="stable")  # 16 bits are sorted in no time
            self._pixels = _PaddlePixels(key, found.pixel[order], found.radius[order], found.angle[order])
        return self._pixels


def without_recoiling(contents: tuple[SlotContent, ...], recoils: tuple[Recoil, ...]) -> tuple[SlotContent, ...]:
    """The paddles' contents, with nothing where a paddle is out of its slot."""
    away = {recoil.slot for recoil in recoils}
    empty = SlotContent(ContentKind.EMPTY)
    return tuple([empty if slot in away else content for slot, content in enumerate(contents)]) if away else contents


def _between(angles: Floats, low: float, high: float) -> NDArray[np.int64]:
    """Which of the rising angles lie between two, also across 0."""
    runs = [np.searchsorted(angles, (low + turn, high + turn)) for turn in (-math.tau, 0.0, math.tau)]
    return np.concatenate([np.arange(first, last) for first, last in runs])
