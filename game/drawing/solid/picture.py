"""The scene seen aslant: the ground, what lies on it, blocks from back to front, the balls among them.

All that stands on the ground is turned into quadrilaterals anew for every frame; what makes that quick is that a ring's blocks
are remembered, relative to its phase, and that a mosaic fills them.
"""

import math
from collections import OrderedDict
from typing import NamedTuple

import numpy as np
import pygame

from game.drawing.camera import Camera
from game.drawing.flat.recoil import pushed
from game.drawing.flat.ring import packed
from game.drawing.flat.sector_colours import Look
from game.drawing.ground import ground_picture
from game.drawing.palette import Theme
from game.drawing.solid import painters_order as depth_order
from game.drawing.solid import prisms as pieces
from game.drawing.solid import slabs
from game.drawing.solid.faces import Seen, faces, seen, shadows
from game.drawing.solid.prisms import Blocks, Cut
from game.drawing.solid.quad_raster import Mosaic
from game.drawing.solid.slabs import Slot
from game.rules import PADDLES
from game.scene import Scene

_FINENESS = ((9_000_000, 2),)
"""Up to how many pixels of the surface blocks are drawn how many times finer; a power of two, for others change colours."""
_STEPS = 8
"""Sizes of blocks between one and twice as large: where they are cut and how thin they are drawn changes but there."""
_FRINGE = 0.32
"""Pixels of a drawing by which whole pixels make a polygon larger on every side, as measured."""
_REMEMBERED = 64


class _Ground(NamedTuple):
    """The picture of the ground, and what it depends on."""

    key: tuple[object, ...]
    picture: pygame.Surface


Looks = tuple[tuple[Look, ...], ...]
"""Per ring and slot."""


class SolidPicture:
    """Draws the ground and the blocks; remembers what an orbit or a turning ring does not change."""

    def __init__(self) -> None:
        """Start with nothing remembered."""
        self._ground: _Ground | None = None
        self._blocks: OrderedDict[tuple[object, ...], Blocks] = OrderedDict()
        self._mosaic = Mosaic()

    def draw_ground(self, surface: pygame.Surface, scene: Scene, camera: Camera, theme: Theme) -> None:
        """Cover the surface with the ground and what is around it."""
        track = scene.rings[PADDLES].radius
        unturned = camera._replace(azimuth=0.0)
        key = (surface.get_size(), unturned, theme, scene.ground_radius, track)
        if self._ground is None or self._ground.key != key:
            self._ground = _Ground(key, ground_picture(surface, scene.ground_radius, unturned, theme, track))
        surface.blit(self._ground.picture, (0, 0))

    def draw_blocks(self, surface: pygame.Surface, scene: Scene, looks: Looks, camera: Camera, theme: Theme) -> Seen:
        """Draw everything that stands on the ground but the balls, and return it as it is seen."""
        finer = _finer(surface.get_width() * surface.get_height())
        scale = 2.0 ** (round(math.log2(camera.scale) * _STEPS) / _STEPS)
        order = sorted(range(len(scene.rings)), key=lambda k: scene.rings[k].radius)
        parts, partings, below = [], [], 0.0
        for k in order:
            part = self._ring_blocks(scene, k, below, looks[k], (scale, _FRINGE / finer / scale), theme)
            parts.append(pushed(part, scene.recoils) if k == PADDLES else part)
            partings.append((below + scene.rings[k].inner_radius) / 2.0)
            below = scene.rings[k].outer_radius
        place = np.repeat(np.arange(len(order)), [len(part.slot) for part in parts])
        every = pieces.joined(parts)
        phase = np.array([scene.rings[k].phase for k in order])[place]
        things = seen(every, phase, np.array(partings)[place], place + 1, camera)
        dark, drawn = shadows(things, scene.balls, camera, finer), faces(things, camera, finer)
        shade = np.full(len(dark), round(theme.shadow * 255.0) << self._mosaic.canvas.get_shifts()[3], dtype=np.uint32)
        colours = np.concatenate([shade, packed(self._mosaic.canvas, drawn.colours)])
        self._mosaic.draw(surface, np.concatenate([dark, drawn.corners]), colours, finer)
        return things

    def _ring_blocks(
        self, scene: Scene, k: int, below: float, looks: tuple[Look, ...], drawn: tuple[float, float], theme: Theme
    ) -> Blocks:
        """The blocks of one ring, from memory if it looked the same before. drawn: scale and fringe, as in `Cut`."""
        ring = scene.rings[k]
        drops = tuple([drop for drop in scene.drops if drop.ring == k])
        cut = Cut(
            ring.radius,
            ring.half_width,
            ring.half_angle,
            ring.count,
            depth_order.widest(ring.inner_radius, below),
            *drawn,
        )
        key = (cut, looks, drops, theme, scene.ground_radius, scene.tallest[k])
        found = self._blocks.get(key)
        if found is None:
            falling = {drop.slot: drop.height for drop in drops}
            slot = Slot(ring.radius, ring.half_width, ring.half_angle, scene.tallest[k], slabs.LAYER * scene.ground_radius)
            piles = [(number, slabs.slabs(look, slot, falling.get(number, 0.0), theme)) for number, look in enumerate(looks)]
            found = self._blocks[key] = pieces.blocks(cut, piles)
            if len(self._blocks) > _REMEMBERED:
                self._blocks.popitem(last=False)
        else:
            self._blocks.move_to_end(key)
        return found


def _finer(pixels: int) -> int:
    """Rows and columns of the drawing per pixel of the screen."""
    return next((finer for most, finer in _FINENESS if pixels <= most), 1)
