"""The ground and all rings from straight above.

What rests is drawn once: the ground with the rings that do not turn. When a brick there changes, only the rings are drawn
again. What turns is drawn afresh in every frame.
"""

from bisect import bisect_right
from collections import OrderedDict
from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.flat.ring import RingKey, RingPicture, least_lane, ring_key, shift_of
from game.drawing.ground.measures import Ground
from game.drawing.ground.picture import draw_pattern, ground_picture
from game.drawing.slots.contents import ContentKind, Contents, SlotContent
from game.rules import PADDLES
from game.scene import Scene

_MOST_RINGS = 96
"""Pictures of rings cached; more than one arena may be on the screen."""
_RECOIL = (0.01, 0.035)
"""How far paddles recoil at most, inwards and outwards, in shares of their radius; beyond that a recoil is cut off."""
_EMPTY = SlotContent(ContentKind.EMPTY)


class _RestingPicture(NamedTuple):
    """The ground with the rings that do not turn, and what it shows.

    key: surface, camera, theme, ground and rings.
    contents: of these rings.
    ground: without them.
    picture: with them; both are as large as the surface.
    """

    key: tuple[object, ...]
    contents: Contents
    ground: pygame.Surface
    picture: pygame.Surface


class FlatPicture:
    """Draws the ground and what stands in the slots; caches what does not change from frame to frame."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._resting: _RestingPicture | None = None
        self._rings: OrderedDict[RingKey, RingPicture] = OrderedDict()

    def draw(self, canvas: Canvas, scene: Scene, contents: Contents) -> None:
        """Cover a 32-bit surface. contents: of all slots, per ring. The canvas' offset leaves the arena on the surface."""
        self._draw_resting(canvas, scene, contents)
        for k, ring in enumerate(scene.rings):
            if k == scene.second_paddle or (k != PADDLES and ring.spin):
                self._ring(canvas, scene, k).draw(canvas.surface, ring.phase, contents[k], shift=shift_of(canvas))
        self._draw_paddles(canvas, scene, contents[PADDLES])

    def _draw_resting(self, canvas: Canvas, scene: Scene, contents: Contents) -> None:
        """The ground and the rings at rest, from memory as far as they are the same."""
        resting = [k for k, ring in enumerate(scene.rings) if k not in (PADDLES, scene.second_paddle) and not ring.spin]
        now = tuple([contents[k] for k in resting])
        rings = tuple([(k, scene.rings[k]) for k in resting])
        ground = Ground(scene.ground_radius, scene.rings[PADDLES].radius, scene.ground)
        key = (canvas.size, canvas.camera, canvas.theme, ground, rings)
        cached = self._resting
        if cached is None or cached.key != key:
            self._rings.clear()
            empty = ground_picture(canvas, ground)
            draw_pattern(canvas._replace(surface=empty), ground)
            cached = _RestingPicture(key, ((),) * len(resting), empty, empty.copy())
        before = dict(zip(resting, cached.contents, strict=True))
        if cached.contents != now and min(_lanes(scene)) < least_lane(canvas.camera.scale):
            before = dict.fromkeys(resting, ())  # the borders of rings that are so close overlap, and the last one drawn wins
        for k, shown in before.items():
            if shown != contents[k]:
                self._ring(canvas, scene, k).draw(cached.picture, scene.rings[k].phase, contents[k], cached.ground, shown)
        self._resting = cached._replace(contents=now)
        canvas.cover(cached.picture)

    def _draw_paddles(self, canvas: Canvas, scene: Scene, contents: tuple[SlotContent, ...]) -> None:
        """The paddles in their slots, and over them those that were struck."""
        paddles, shift = scene.rings[PADDLES], shift_of(canvas)
        picture = self._ring(canvas, scene, PADDLES)
        out = {recoil.slot: recoil.out for recoil in scene.recoils}
        still = tuple([_EMPTY if slot in out else content for slot, content in enumerate(contents)])
        picture.draw(canvas.surface, paddles.phase, still, shift=shift)
        if out:
            picture.draw_moved(canvas.surface, paddles.phase, contents, out, shift)

    def _ring(self, canvas: Canvas, scene: Scene, k: int) -> RingPicture:
        """The picture of one ring."""
        ring = scene.rings[k]
        room = (_RECOIL[0] * ring.radius, _RECOIL[1] * ring.radius) if k == PADDLES else (0.0, 0.0)
        key = ring_key(canvas, ring, scene.tallest[k], scene.ground_radius, _lanes(scene)[k], room)
        picture = self._rings.get(key)
        if picture is None:
            picture = self._rings[key] = RingPicture(key)
            if len(self._rings) > _MOST_RINGS:
                self._rings.popitem(last=False)
        return picture


def _lanes(scene: Scene) -> list[float]:
    """For every ring the distance to the next one outwards, or to the rim, world units."""
    end = max(scene.ground_radius, *[ring.outer_radius for ring in scene.rings])  # the editor draws rings beyond the rim, too
    edges = sorted([*[ring.inner_radius for ring in scene.rings], end])
    return [edges[bisect_right(edges, ring.radius)] - ring.outer_radius for ring in scene.rings]
