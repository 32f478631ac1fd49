"""The ground and all rings from straight above.

The ground with the wall's rings is a backdrop that is cached from frame to frame. If a ring turns or its bricks change, only
the pixels whose colour differs are drawn again. The paddles are drawn over the backdrop in every frame.
"""

import math
from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.flat.band_pixels import BandKey, BandPixels, band_pixels
from game.drawing.flat.ring import BackdropRing, draw_over
from game.drawing.flat.slot_atlas import SlotAtlas, atlas_key
from game.drawing.ground.picture import draw_pattern, ground_picture
from game.picture.ground.measures import ground_of
from game.picture.slots.contents import Contents, pushed_out
from game.picture.slots.flat import wall_rings
from game.rules import PADDLES
from game.scene import Scene

_RECOIL = (0.01, 0.035)
"""How far paddles recoil at most, inwards and outwards, in shares of their radius; beyond that a recoil is cut off."""


class _Backdrop(NamedTuple):
    """The ground with the wall's rings.

    key: what it depends on, except the rings' angles and contents.
    picture: as large as the surface.
    rings: of the wall, by their indices.
    """

    key: tuple[object, ...]
    picture: pygame.Surface
    rings: dict[int, BackdropRing]


class FlatPicture:
    """Draws the ground and what stands in the slots; caches what does not change from frame to frame."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._backdrop: _Backdrop | None = None
        self._paddles: dict[tuple[int, float], SlotAtlas] = {}  # by ring index and half angle
        self._bands: dict[BandKey, BandPixels] = {}  # of paddles

    def draw(self, canvas: Canvas, scene: Scene, contents: Contents) -> None:
        """Cover a 32-bit surface. contents: of all slots, per ring. The canvas' offset leaves the arena on the surface."""
        backdrop = self._backdrop_of(canvas, scene)
        for k, ring in backdrop.rings.items():
            ring.draw(backdrop.picture, scene.rings[k].phase, contents[k])
        canvas.cover(backdrop.picture)
        if scene.second_paddle is not None:
            self._draw_paddles(canvas, scene, scene.second_paddle, contents)
        self._draw_paddles(canvas, scene, PADDLES, contents)

    def _backdrop_of(self, canvas: Canvas, scene: Scene) -> _Backdrop:
        """The backdrop; the cached one if only the rings' angles and contents have changed."""
        ground = ground_of(scene)
        standing = {k: scene.rings[k][:4] for k in wall_rings(scene)}
        key = (canvas.size, canvas.camera, canvas.theme, ground, scene.tallest, standing)
        if self._backdrop is None or self._backdrop.key != key:
            self._paddles.clear()
            self._bands.clear()
            picture = ground_picture(canvas, ground)
            draw_pattern(canvas._replace(surface=picture), ground)
            rings = {k: BackdropRing(SlotAtlas(atlas_key(canvas, scene, k)), picture) for k in standing}
            self._backdrop = _Backdrop(key, picture, rings)
        return self._backdrop

    def _draw_paddles(self, canvas: Canvas, scene: Scene, k: int, contents: Contents) -> None:
        """Draw a ring of paddles over the backdrop, each as far out of its slot as a hit has pushed it."""
        atlas, out = self._atlas_of_paddles(canvas, scene, k), pushed_out(scene, k)
        band = self._band(atlas.wide_band if out else atlas.band)
        draw_over(canvas, band, atlas, atlas.columns(canvas.surface, scene.rings[k].phase, contents[k], out))

    def _atlas_of_paddles(self, canvas: Canvas, scene: Scene, k: int) -> SlotAtlas:
        """The pictures of a ring of paddles."""
        ring = scene.rings[k]
        key = k, ring.half_angle
        if key not in self._paddles:
            room = _RECOIL[0] * ring.radius, _RECOIL[1] * ring.radius
            atlas = SlotAtlas(atlas_key(canvas, scene, k)._replace(lane=(0.0, math.inf), room=room))
            self._band(atlas.wide_band)  # computed in advance, since that takes long
            self._paddles[key] = atlas
        return self._paddles[key]

    def _band(self, key: BandKey) -> BandPixels:
        """The pixels of a band, cached: paddles that grow or shrink keep theirs."""
        if key not in self._bands:
            self._bands[key] = band_pixels(key)
        return self._bands[key]
