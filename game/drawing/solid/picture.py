"""The ground and what stands on it seen aslant, from back to front.

All that stands on the ground is turned into quadrilaterals anew for every frame. That is quick because a ring's blocks are
cached, relative to its phase, and because the raster that fills them caches its tiles.
"""

import math
from collections import OrderedDict
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame

from game.drawing.canvas import Canvas
from game.drawing.ground.picture import draw_pattern, ground_picture
from game.drawing.palette import Theme, mixed
from game.drawing.raster.pixels import packed
from game.drawing.raster.quads import FinePixels, QuadRaster, fill_quads
from game.drawing.slots.contents import ContentKind, Contents, SlotContent
from game.drawing.slots.parts import LAYER_HEIGHT, Part, SlotShape, parts
from game.drawing.solid.faces import Faces, ProjectedBlocks, projected, shadows, visible_faces
from game.drawing.solid.painters_order import widest
from game.drawing.solid.prisms import Blocks, Cut, joined, pushed, recoloured, ring_blocks
from game.effects import FallingStack
from game.picture.ground.measures import ground_of
from game.rules import PADDLES
from game.scene import Scene

_MOST_FINE_PIXELS = 6_000_000
"""Surfaces up to this size are drawn _FINER times finer, and scaled down; larger ones as they are, for the sake of speed."""
_BLACK = (0, 0, 0)
_FINER = 2
"""A power of two: with other numbers, scaling down changes colours."""
_SCALE_STEPS = 8
"""Scales between one and its double for which blocks are cut anew; between two of them they stay as they are."""
_FRINGE = 0.32
"""Pixels of the finer drawing by which filling whole pixels makes a polygon larger on every side, as measured."""
_MOST_RINGS = 64
"""Rings whose blocks are cached."""


class _GroundPicture(NamedTuple):
    """The picture of the ground, and what it depends on."""

    key: tuple[object, ...]
    picture: pygame.Surface


class _RingKey(NamedTuple):
    """What a ring's blocks depend on.

    cut: how they are cut.
    tallest: layers of the ring's highest stack that may ever stand there.
    contents: of its slots.
    falling: stacks of it that are falling.
    theme: the colours.
    """

    cut: Cut
    tallest: int
    contents: tuple[SlotContent, ...]
    falling: tuple[FallingStack, ...]
    theme: Theme


class SolidPicture:
    """Draws the ground and the blocks; caches what an orbit or a turning ring does not change."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._bare: _GroundPicture | None = None  # without its pattern: an orbit does not change it
        self._ground: _GroundPicture | None = None
        self._blocks: OrderedDict[_RingKey, Blocks] = OrderedDict()
        self._raster = QuadRaster()

    def draw_ground(self, canvas: Canvas, scene: Scene) -> None:
        """Cover the surface with the ground and what is around it."""
        ground = ground_of(scene)
        unturned = canvas._replace(camera=canvas.camera._replace(azimuth=0.0))
        key = (canvas.size, unturned.camera, canvas.theme, ground)
        if self._bare is None or self._bare.key != key:
            self._bare, self._ground = _GroundPicture(key, ground_picture(unturned, ground)), None
        turned = (*key, canvas.camera.azimuth)
        if self._ground is None or self._ground.key != turned:
            picture = self._bare.picture.copy() if self._ground is None else self._ground.picture
            picture.blit(self._bare.picture, (0, 0))
            draw_pattern(canvas._replace(surface=picture), ground)
            self._ground = _GroundPicture(turned, picture)
        canvas.cover(self._ground.picture)

    def draw_blocks(self, canvas: Canvas, scene: Scene, contents: Contents) -> ProjectedBlocks:
        """Draw everything that stands on the ground but the balls, with the balls' shadows; the blocks as they are seen.

        contents: of all slots, per ring.
        """
        finer = _finer(canvas.size)
        seen = self._projected(canvas, scene, contents, finer)
        dark = shadows(seen, scene.balls, canvas.camera, finer)
        faces = visible_faces(seen, canvas.camera, finer, canvas.theme.shade)
        if finer == 1:
            _fill_large(canvas, dark, faces)
            return seen
        pixel = self._raster.canvas
        shade = np.full(len(dark), round(canvas.theme.shadow * 255.0) << pixel.get_shifts()[3], dtype=np.uint32)
        colours = np.concatenate([shade, packed(pixel, faces.colours)])
        self._raster.draw(canvas.surface, np.concatenate([dark, faces.corners]), colours, finer, canvas.offset)
        return seen

    def _projected(self, canvas: Canvas, scene: Scene, contents: Contents, finer: int) -> ProjectedBlocks:
        """The blocks of all rings on the screen."""
        order = sorted(range(len(scene.rings)), key=lambda k: scene.rings[k].radius)
        rings, partings, below = [], [], 0.0
        for k in order:
            ring = scene.rings[k]
            blocks = self._ring_blocks(_ring_key(canvas, scene, k, contents[k], below, finer))
            rings.append(pushed(blocks, scene.recoils) if k == PADDLES else blocks)
            partings.append((below + ring.inner_radius) / 2.0)
            below = ring.outer_radius
        rank = np.repeat(np.arange(len(order)), [len(blocks.slot) for blocks in rings])
        phase = np.array([scene.rings[k].phase for k in order])[rank]
        return projected(joined(rings), phase, np.array(partings)[rank], rank + 1, canvas.camera)

    def _ring_blocks(self, key: _RingKey) -> Blocks:
        """The blocks of one ring, cached; if only the light of hits differs, cached shapes get new colours."""
        found = self._blocks.get(key)
        if found is None:
            unlit = key._replace(contents=_unlit(key.contents))
            found = _cut(key) if unlit == key else recoloured(self._ring_blocks(unlit), _piles(key))
            self._blocks[key] = found
            if len(self._blocks) > _MOST_RINGS:
                self._blocks.popitem(last=False)
        else:
            self._blocks.move_to_end(key)
        return found


def _fill_large(canvas: Canvas, dark: FinePixels, faces: Faces) -> None:
    """Fill shadows and faces on a large surface at once: every pixel that tiles would cost is saved.

    There shadows have one colour, the ground's in the shade, wherever they lie.
    """
    shade = mixed(canvas.theme.ground, _BLACK, canvas.theme.shadow)
    offset = np.complex64(complex(*canvas.offset))
    fill_quads(canvas.surface, dark + offset, np.repeat(np.array([shade], dtype=np.float32), len(dark), axis=0))
    fill_quads(canvas.surface, faces.corners + offset, faces.colours)


def _ring_key(canvas: Canvas, scene: Scene, k: int, contents: tuple[SlotContent, ...], below: float, finer: int) -> _RingKey:
    """The key of a ring. below: radius of the outer faces of the next ring towards the centre."""
    ring, scale = scene.rings[k], 2.0 ** (round(math.log2(canvas.camera.scale) * _SCALE_STEPS) / _SCALE_STEPS)
    cut = Cut(
        ring.radius,
        ring.half_width,
        ring.half_angle,
        ring.count,
        widest(ring.inner_radius, below),
        LAYER_HEIGHT * scene.ground_radius,
        scale * finer / _FINER,  # where blocks are not scaled down, bends are less fine, too
        _FRINGE / finer / scale,
    )
    falling = tuple([stack for stack in scene.falling if stack.ring == k])
    return _RingKey(cut, scene.tallest[k], contents, falling, canvas.theme)


def _cut(key: _RingKey) -> Blocks:
    """Compute the blocks of a ring."""
    return ring_blocks(key.cut, _piles(key))


def _piles(key: _RingKey) -> list[tuple[int, tuple[Part, ...]]]:
    """The parts in every slot of a ring. Lines may be thinner than a pixel, since the picture is scaled down afterwards."""
    falling = {stack.slot: stack.height for stack in key.falling}
    cut = key.cut
    shape = SlotShape(cut.radius, cut.half_width, cut.half_angle, key.tallest, finest=0.0)
    return [(slot, parts(one, shape, falling.get(slot, 0.0), key.theme)) for slot, one in enumerate(key.contents)]


@lru_cache(maxsize=256)
def _unlit(contents: tuple[SlotContent, ...]) -> tuple[SlotContent, ...]:
    """The contents of a ring without the light of hits; contents that consist of light only stay."""
    return tuple([one if one.kind is ContentKind.GHOST else one._replace(glow=0) for one in contents])


def _finer(size: tuple[int, int]) -> int:
    """Rows and columns of the drawing per pixel of a surface."""
    return _FINER if size[0] * size[1] <= _MOST_FINE_PIXELS else 1
