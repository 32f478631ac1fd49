"""The ground and what stands on it seen aslant, from back to front.

All that stands on the ground is turned into quadrilaterals anew for every frame. That is quick because a ring's blocks are
cached, relative to its phase, and because the raster that fills them caches its tiles.
"""

from typing import NamedTuple

import numpy as np
import pygame

from game.drawing.canvas import Canvas
from game.drawing.ground.picture import draw_pattern, ground_picture
from game.drawing.light import side_shares
from game.drawing.palette import mixed
from game.drawing.raster.pixels import packed
from game.drawing.raster.quads import FinePixels, QuadRaster, fill_quads
from game.drawing.solid.arena_blocks import ArenaBlocks
from game.drawing.solid.faces import Faces, ProjectedBlocks, shadows, visible_faces
from game.picture.ground.measures import ground_of
from game.picture.slots.contents import Contents
from game.picture.solid.rings import solid_rings
from game.scene import Scene

_MOST_FINE_PIXELS = 6_000_000
"""Surfaces up to this size are drawn _FINER times finer, and scaled down; larger ones as they are, for the sake of speed."""
_BLACK = (0, 0, 0)
_FINER = 2
"""A power of two: with other numbers, scaling down changes colours."""
_FRINGE = 0.32
"""Pixels of the finer drawing by which filling whole pixels makes a polygon larger on every side, as measured."""


class _GroundPicture(NamedTuple):
    """The picture of the ground, and what it depends on."""

    key: tuple[object, ...]
    picture: pygame.Surface


class SolidPicture:
    """Draws the ground and the blocks; caches what an orbit or a turning ring does not change."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._bare: _GroundPicture | None = None  # without its pattern: an orbit does not change it
        self._ground: _GroundPicture | None = None
        self._blocks = ArenaBlocks()
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
        scale = canvas.camera.scale  # where blocks are not scaled down, bends are less fine, too
        rings = solid_rings(scene, contents, canvas.theme, scale, finer / _FINER, _FRINGE / finer)
        seen = self._blocks.seen(scene, rings, canvas.camera)
        dark = shadows(seen, scene.balls, canvas.camera, finer)
        faces = visible_faces(seen, canvas.camera, finer, side_shares(canvas.theme))
        if finer == 1:
            _fill_large(canvas, dark, faces)
            return seen
        pixel = self._raster.canvas
        shade = np.full(len(dark), round(canvas.theme.shadow * 255.0) << pixel.get_shifts()[3], dtype=np.uint32)
        colours = np.concatenate([shade, packed(pixel, faces.colours)])
        self._raster.draw(canvas.surface, np.concatenate([dark, faces.corners]), colours, finer, canvas.offset)
        return seen


def _fill_large(canvas: Canvas, dark: FinePixels, faces: Faces) -> None:
    """Fill shadows and faces on a large surface at once: every pixel that tiles would cost is saved.

    There shadows have one colour, the ground's in the shade, wherever they lie.
    """
    shade = mixed(canvas.theme.ground, _BLACK, canvas.theme.shadow)
    offset = np.complex64(complex(*canvas.offset))
    fill_quads(canvas.surface, dark + offset, np.repeat(np.array([shade], dtype=np.float32), len(dark), axis=0))
    fill_quads(canvas.surface, faces.corners + offset, faces.colours)


def _finer(size: tuple[int, int]) -> int:
    """Rows and columns of the drawing per pixel of a surface."""
    return _FINER if size[0] * size[1] <= _MOST_FINE_PIXELS else 1
