"""A struck paddle out of its slot, from straight above: its pixels look up their colours a little farther in.

The pixels of the paddles' band are sorted by angle: a paddle's are one or two runs of them, wherever it is.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.drawing.canvas import Canvas
from game.drawing.flat.ring import RingPicture, pieces_of
from game.drawing.raster.annulus import Floats, annulus_pixels
from game.drawing.raster.pixels import pixels_of
from game.drawing.slots.contents import ContentKind, SlotContent
from game.effects import Recoil
from physics import Ring

_OUTWARDS, _INWARDS = 0.035, 0.01
"""Shares of the paddles' radius; beyond them a recoil is cut off."""
_SHADOW_ASIDE = 24.0
"""Pixels beside a paddle that its shadow may reach."""
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

    def draw(self, canvas: Canvas, ring: Ring, recoil: Recoil, content: SlotContent, picture: RingPicture) -> None:
        """One paddle on a 32-bit surface. content: of the slot that is struck; picture: of the paddles' ring."""
        scale, pixels = canvas.camera.scale, self._pixels_near(canvas, ring)
        middle, margin = ring.angle(recoil.slot), _SHADOW_ASIDE / max(scale * ring.radius, 1.0)
        memory, out = pixels_of(canvas.surface), np.float32(_out(recoil, ring) * scale)
        for turn in (-math.tau, 0.0, math.tau):  # the paddle may lie across angle 0
            reach = ring.half_angle + margin
            begin, end = np.searchsorted(pixels.angle, (middle + turn - reach, middle + turn + reach)).tolist()
            for some in pieces_of(begin, end):
                angle = pixels.angle[some] - np.float32(middle + turn)
                colours = picture.colours_at(canvas.surface, content, pixels.radius[some] - out, angle)
                there = np.flatnonzero(colours)
                memory[pixels.pixel[some][there]] = colours[there]

    def _pixels_near(self, canvas: Canvas, ring: Ring) -> _PaddlePixels:
        """The pixels around the paddles' track."""
        surface, camera = canvas.surface, canvas.camera
        key = (canvas.size, surface.get_pitch(), camera, ring.radius, ring.half_width)
        if self._pixels is None or self._pixels.key != key:
            outer = (ring.outer_radius + _OUTWARDS * ring.radius) * camera.scale + 1.0
            inner = max((ring.inner_radius - _INWARDS * ring.radius) * camera.scale - 1.0, 0.0)
            found = annulus_pixels(canvas.size, surface.get_pitch() // 4, camera.centre, inner, outer)
            order = np.argsort((found.angle * _ANGLE_STEPS).astype(np.uint16), kind="stable")  # 16 bits are sorted in no time
            self._pixels = _PaddlePixels(key, found.pixel[order], found.radius[order], found.angle[order])
        return self._pixels


def _out(recoil: Recoil, ring: Ring) -> float:
    """World units that a paddle is out of its slot, outwards or inwards, as far as that is drawn."""
    return min(max(recoil.out, -_INWARDS * ring.radius), _OUTWARDS * ring.radius)


def without_recoiling(contents: tuple[SlotContent, ...], recoils: tuple[Recoil, ...]) -> tuple[SlotContent, ...]:
    """The paddles' contents, with nothing where a paddle is out of its slot."""
    away = {recoil.slot for recoil in recoils}
    empty = SlotContent(ContentKind.EMPTY)
    return tuple([empty if slot in away else content for slot, content in enumerate(contents)]) if away else contents
