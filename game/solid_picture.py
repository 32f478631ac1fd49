"""The scene seen aslant: the ground, what lies on it, blocks from back to front, the balls among them.

Blocks are drawn several times finer and scaled down, only where there are any: around the wall and around each paddle.
"""

import itertools
import math
from collections import OrderedDict
from typing import NamedTuple

import numpy as np
import pygame

from game import blocks as pieces
from game import depth_order, slabs
from game.blocks import Blocks, Cut, Integers
from game.camera import Camera
from game.ground import ground_picture
from game.palette import Theme
from game.recoil_picture import pushed
from game.rules import PADDLES
from game.scene import Scene
from game.skins import Look
from game.slabs import Slot
from game.solids import Seen, faces, seen

_FINENESS = ((4_000_000, 2),)
"""Up to how many pixels blocks are drawn how many times finer. Scaling down by a power of two leaves the ground alone."""
_STEPS = 8
"""Sizes of blocks between one and twice as large: where they are cut and how thin they are drawn changes but there."""
_FRINGE = 0.25
"""Pixels by which whole pixels of a drawing make a polygon larger on every side."""
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
        self._canvas: pygame.Surface | None = None

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
        scale = 2.0 ** (round(math.log2(camera.scale) * _STEPS) / _STEPS)
        parts: list[Blocks] = []
        phases, partings, ranks, groups = [], [], [], []
        order = sorted(range(len(scene.rings)), key=lambda k: scene.rings[k].radius)
        below = 0.0
        for rank, k in enumerate(order, 1):
            ring = scene.rings[k]
            part = self._ring_blocks(scene, k, below, looks[k], scale, theme)
            part = pushed(part, scene.recoils) if k == PADDLES else part
            size = len(part.slot)
            parts.append(part)
            phases.append(np.full(size, ring.phase))
            partings.append(np.full(size, (below + ring.inner_radius) / 2.0))
            ranks.append(np.full(size, rank))
            groups.append(part.slot + 1 if k == PADDLES else np.zeros(size, dtype=np.int64))
            below = ring.outer_radius
        all_blocks = pieces.joined(parts)
        things = seen(
            all_blocks, np.concatenate(phases), np.concatenate(partings), np.concatenate(ranks), np.concatenate(groups), camera
        )
        self._draw(surface, things, camera)
        return things

    def _ring_blocks(self, scene: Scene, k: int, below: float, looks: tuple[Look, ...], scale: float, theme: Theme) -> Blocks:
        """The blocks of one ring, from memory if it looked the same before."""
        ring = scene.rings[k]
        drops = tuple([drop for drop in scene.drops if drop.ring == k])
        cut = Cut(
            ring.radius,
            ring.half_width,
            ring.half_angle,
            ring.count,
            depth_order.widest(ring.inner_radius, below),
            scale,
            _FRINGE / scale,
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

    def _draw(self, surface: pygame.Surface, things: Seen, camera: Camera) -> None:
        """Draw the faces, area by area."""
        areas, area = areas_of(things, surface.get_rect())
        finer = _finer(sum([box.width * box.height for box in areas]))
        every = faces(things, camera, finer, [complex(*box.topleft) for box in areas], area)
        for number, group in itertools.groupby(every, key=lambda face: face.area):
            box = areas[number]
            if box.width and box.height:
                fine = self._fine_canvas(surface, box, finer)
                for face in group:
                    pygame.draw.polygon(fine, face.colour, face.corners)
                pygame.transform.smoothscale(fine, box.size, surface.subsurface(box))

    def _fine_canvas(self, surface: pygame.Surface, box: pygame.Rect, finer: int) -> pygame.Surface:
        """A finer copy of a part of the surface, to draw on."""
        size = (box.width * finer, box.height * finer)
        canvas = self._canvas
        if canvas is None or canvas.get_width() < size[0] or canvas.get_height() < size[1]:
            held = (0, 0) if canvas is None else canvas.get_size()
            canvas = self._canvas = pygame.Surface((max(size[0], held[0]), max(size[1], held[1])), 0, surface)
        fine = canvas.subsurface((0, 0, *size))
        pygame.transform.scale(surface.subsurface(box), size, fine)
        return fine


def areas_of(things: Seen, screen: pygame.Rect) -> tuple[list[pygame.Rect], Integers]:
    """Boxes to draw in one after the other, and the box of each block: one for every run of blocks of a group.

    The blocks' order is kept: boxes may overlap, the later one is drawn on what the earlier ones left.
    """
    starts = np.flatnonzero(np.diff(things.group, prepend=-1))
    points = np.concatenate([things.outer_top, things.inner_top, things.outer_bottom, things.inner_bottom], axis=1)
    left, top = (np.floor(np.minimum.reduceat(part.min(axis=1), starts)) - 1 for part in (points.real, points.imag))
    right, bottom = (np.ceil(np.maximum.reduceat(part.max(axis=1), starts)) + 1 for part in (points.real, points.imag))
    corners = np.stack([left, top, right - left, bottom - top], axis=1).astype(np.int64).tolist()
    area = np.cumsum(np.diff(things.group, prepend=things.group[0]) != 0)
    return [pygame.Rect(*box).clip(screen) for box in corners], area


def _finer(pixels: int) -> int:
    """Rows and columns of the drawing per pixel of the screen."""
    return next((finer for most, finer in _FINENESS if pixels <= most), 1)
