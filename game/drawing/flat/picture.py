"""The ground and all rings from straight above.

What rests is drawn once: the ground with the rings that do not turn. When a brick there changes, only the rings are drawn
again. What turns is drawn afresh in every frame.
"""

from collections import OrderedDict
from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.flat.recoil import RecoilPicture, without_recoiling
from game.drawing.flat.ring import RingKey, RingPicture, ring_key
from game.drawing.ground import ground_picture
from game.drawing.slots.contents import Contents, SlotContent
from game.rules import PADDLES
from game.scene import Scene
from physics import Ring

_MOST_RINGS = 96
"""Pictures of rings cached; more than one arena may be on the screen."""


class _RestingPicture(NamedTuple):
    """The ground with the rings that do not turn, and what it shows.

    key: surface, camera, theme, ground and rings.
    contents: of these rings.
    picture: as large as the surface.
    """

    key: tuple[object, ...]
    contents: Contents
    picture: pygame.Surface


class FlatPicture:
    """Draws the ground and what stands in the slots; caches what does not change from frame to frame."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._resting: _RestingPicture | None = None
        self._rings: OrderedDict[RingKey, RingPicture] = OrderedDict()
        self._recoil = RecoilPicture()

    def draw(self, canvas: Canvas, scene: Scene, contents: Contents) -> None:
        """Cover a 32-bit surface. contents: of all slots, per ring."""
        self._draw_resting(canvas, scene, contents)
        for k, ring in enumerate(scene.rings):
            if k != PADDLES and ring.spin:
                self._draw_ring(canvas, ring, contents[k], scene.tallest[k])
        self._draw_paddles(canvas, scene, contents[PADDLES])

    def _draw_resting(self, canvas: Canvas, scene: Scene, contents: Contents) -> None:
        """The ground and the rings at rest, from memory as far as they are the same."""
        resting = [k for k, ring in enumerate(scene.rings) if k != PADDLES and not ring.spin]
        now = tuple([contents[k] for k in resting])
        rings = tuple([(k, scene.rings[k]) for k in resting])
        key = (canvas.size, canvas.camera, canvas.theme, scene.ground_radius, rings)
        cached = self._resting
        if cached is None or cached.key != key:
            self._rings.clear()
            cached = _RestingPicture(key, ((),) * len(resting), ground_picture(canvas, scene.ground_radius))
        if cached.contents != now:  # all of them, for the borders of close rings overlap and the last one drawn wins
            for (k, ring), content in zip(rings, now, strict=True):
                self._draw_ring(canvas._replace(surface=cached.picture), ring, content, scene.tallest[k])
        self._resting = cached._replace(contents=now)
        canvas.surface.blit(cached.picture, (0, 0))

    def _draw_paddles(self, canvas: Canvas, scene: Scene, contents: tuple[SlotContent, ...]) -> None:
        """The paddles in their slots, and over them those that were struck."""
        paddles = scene.rings[PADDLES]
        self._draw_ring(canvas, paddles, without_recoiling(contents, scene.recoils), scene.tallest[PADDLES])
        for recoil in scene.recoils:
            self._recoil.draw(canvas, paddles, recoil, contents[recoil.slot])

    def _draw_ring(self, canvas: Canvas, ring: Ring, contents: tuple[SlotContent, ...], tallest: int) -> None:
        """One ring and the ground in its gaps. tallest: layers of the highest stack that may ever stand there."""
        key = ring_key(canvas, ring, tallest)
        picture = self._rings.get(key)
        if picture is None:
            picture = self._rings[key] = RingPicture(key)
            if len(self._rings) > _MOST_RINGS:
                self._rings.popitem(last=False)
        picture.draw(canvas.surface, ring.phase, contents)
