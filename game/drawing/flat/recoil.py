"""A struck paddle out of its place: from above painted pixel by pixel, aslant as the same blocks a little farther out.

The pixels of the paddles' band are sorted by angle: a paddle's are one or two runs of them, wherever it is.
"""

import math
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.flat.annulus_pixels import Floats, band
from game.drawing.flat.ring import packed, pixels_of
from game.drawing.flat.sector_colours import GLOW, Kind, Look
from game.drawing.palette import Theme, mixed
from game.drawing.solid.prisms import Blocks
from game.effects import Recoil
from physics import Ring

_FARTHEST = 0.05
"""Of the paddles' radius: beyond this a recoil is cut off."""
_RIM, _LEAST_RIM = 0.4, 1.0
"""Width of a paddle's darker edge: of its half width, and pixels."""
_AWAY = Look(Kind.EMPTY)


class _Band(NamedTuple):
    """The pixels that a paddle may cover, sorted by angle."""

    key: tuple[object, ...]
    place: NDArray[np.int64]
    radius: Floats  # pixels
    angle: Floats  # in [0, 2 pi)


class RecoilPicture:
    """Draws paddles out of their place from straight above; remembers where their pixels are."""

    def __init__(self) -> None:
        """Start with nothing remembered."""
        self._band: _Band | None = None

    def draw(self, surface: pygame.Surface, ring: Ring, recoil: Recoil, look: Look, camera: Camera, theme: Theme) -> None:
        """One paddle on a 32-bit surface. ring: the paddles in their place; look: of this one."""
        pixels = self._pixels(surface, ring, camera)
        middle, margin = ring.angle(recoil.slot), 2.0 / max(camera.scale * ring.radius, 1.0)
        rows = _between(pixels.angle, middle - ring.half_angle - margin, middle + ring.half_angle + margin)
        off = np.abs((pixels.angle[rows] - middle + math.pi) % math.tau - math.pi)
        radius = pixels.radius[rows] - min(recoil.out, _FARTHEST * ring.radius) * camera.scale
        sides = ring.half_width * camera.scale - np.abs(radius - ring.radius * camera.scale)
        ends = radius * np.sin(np.clip(ring.half_angle - off, -1.0, math.pi / 2.0))
        depth = np.minimum(sides, ends).astype(np.float32)
        covered = depth > -0.5
        rim = max(_RIM * ring.half_width * camera.scale, _LEAST_RIM)
        pixels_of(surface)[pixels.place[rows[covered]]] = packed(surface, _painted(depth[covered], rim, look, theme))

    def _pixels(self, surface: pygame.Surface, ring: Ring, camera: Camera) -> _Band:
        """The pixels around the paddles' track."""
        key = (surface.get_size(), surface.get_pitch(), camera, ring.radius, ring.half_width)
        if self._band is None or self._band.key != key:
            reach = (ring.outer_radius + _FARTHEST * ring.radius) * camera.scale + 1.0
            low = max((ring.inner_radius - _FARTHEST * ring.radius) * camera.scale - 1.0, 0.0)
            found = band(surface.get_size(), surface.get_pitch() // 4, camera.centre, low, reach)
            order = np.argsort(found.angle)
            self._band = _Band(key, found.place[order], found.radius[order], found.angle[order])
        return self._band


def without(looks: tuple[Look, ...], recoils: tuple[Recoil, ...]) -> tuple[Look, ...]:
    """The looks of the paddles' places, nothing where one is out of its place."""
    away = {recoil.slot for recoil in recoils}
    return tuple([_AWAY if slot in away else look for slot, look in enumerate(looks)]) if away else looks


def pushed(blocks: Blocks, recoils: tuple[Recoil, ...]) -> Blocks:
    """The paddles' blocks, those of a struck one out of their place."""
    for recoil in recoils:
        out = np.where(blocks.slot == recoil.slot, recoil.out, 0.0)[:, None]
        blocks = blocks._replace(foot=blocks.foot * (1.0 + out / np.abs(blocks.foot)))
    return blocks


def _between(angles: Floats, low: float, high: float) -> NDArray[np.int64]:
    """Which of the rising angles lie between two, also across 0."""
    runs = [np.searchsorted(angles, (low + turn, high + turn)) for turn in (-math.tau, 0.0, math.tau)]
    return np.concatenate([np.arange(first, last) for first, last in runs])


def _painted(depth: Floats, rim: float, look: Look, theme: Theme) -> Floats:
    """The paddle's colours at depths inside it, pixels: ground outside, its edge, its top; as the ring's picture has them."""
    light = 0.8 * look.glow / GLOW
    ground, edge, top = (
        np.array(colour, dtype=np.float32)
        for colour in (theme.ground, mixed(theme.paddle, theme.flash, light), mixed(theme.paddle_top, theme.flash, light))
    )
    colours = ground + (edge - ground) * np.clip(depth + 0.5, 0.0, 1.0)[:, None]
    return np.asarray(colours + (top - colours) * np.clip(depth - rim + 0.5, 0.0, 1.0)[:, None], dtype=np.float32)
