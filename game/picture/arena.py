"""The game's scene as two lists of primitives: a backdrop that seldom changes, and what is new in every frame."""

import math

from game.drawing.camera import Camera
from game.drawing.palette import Theme
from game.drawing.palettes import themed
from game.picture.display_list import DisplayList
from game.picture.ground.lists import add_ground
from game.picture.ground.measures import ground_of
from game.picture.moving.balls import BallTextures, add_ball
from game.picture.moving.bursts import flying_pieces
from game.picture.moving.glints import add_glints
from game.picture.moving.layers import add_in_air, add_on_ground
from game.picture.moving.words import add_words
from game.picture.slots.contents import Contents, SlotContent, pushed_out, slot_contents
from game.picture.slots.flat import FlatRing, add_content, add_shadow, flat_rings, wall_rings
from game.picture.solid.blocks import SolidBlocks
from game.picture.view import ArenaView
from game.rules import PADDLES
from game.scene import Scene

_MOST_RINGS = 64
"""Pictures of rings that are cached."""


class ArenaPicture:
    """Makes pictures of scenes; caches what did not change since the last one."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._key: object = None
        self._backdrop = DisplayList()
        self._rings: dict[object, DisplayList] = {}
        self._blocks = SolidBlocks()
        self._textures = BallTextures()

    def backdrop(self, scene: Scene, view: ArenaView) -> DisplayList:
        """The ground, and in the flat view the rings that rest: the very same list as long as it has not changed."""
        theme = themed(view.theme, scene.palette)
        resting = _resting(scene, view.camera)
        ground = ground_of(scene)
        contents = slot_contents(scene._replace(flashes=())) if resting else ()
        rings = flat_rings(scene, view.camera.scale, theme)
        key = (view.camera, theme, ground, tuple([(rings[k], contents[k], scene.rings[k].phase) for k in resting]))
        if key != self._key:
            self._key, self._backdrop = key, DisplayList()
            add_ground(self._backdrop, view.camera, theme, ground)
            for k in resting:
                self._add_ring(self._backdrop, view.camera.centre, rings[k], contents[k], scene.rings[k].phase)
        return self._backdrop

    def frame(self, scene: Scene, view: ArenaView) -> DisplayList:
        """All that moves. It is painted over the backdrop."""
        out, view = DisplayList(), view._replace(theme=themed(view.theme, scene.palette))
        camera, theme, contents = view.camera, view.theme, slot_contents(scene)
        if camera.flat:
            self._add_flat(out, scene, camera, theme, contents)
            add_on_ground(out, scene, view)
        else:
            add_on_ground(out, scene, view)
            texture = self._textures.texture(out, camera, theme, view.ball)
            self._blocks.add(out, scene, camera, theme, contents, texture, flying_pieces(scene, view))
        add_glints(out, scene, view)
        if camera.flat:
            for _, piece in flying_pieces(scene, view):
                out.extend(piece)
            texture = self._textures.texture(out, camera, theme, view.ball)
            for ball in scene.balls:
                add_ball(out, ball, camera, texture)
        add_in_air(out, scene, view)
        add_words(out, scene, view)
        return out

    def _add_flat(self, out: DisplayList, scene: Scene, camera: Camera, theme: Theme, contents: Contents) -> None:
        """Add the rings that turn, the slots that glow, and the paddles."""
        resting = _resting(scene, camera)
        for k, ring in enumerate(flat_rings(scene, camera.scale, theme)):
            if k == PADDLES:
                _add_paddles(out, scene, camera.centre, ring, contents[k])
            elif k in resting:
                _add_glowing(out, camera.centre, ring, contents[k], scene.rings[k].phase)
            else:
                self._add_ring(out, camera.centre, ring, contents[k], scene.rings[k].phase)

    def _add_ring(
        self, out: DisplayList, centre: complex, ring: FlatRing, contents: tuple[SlotContent, ...], phase: float
    ) -> None:
        """Add a whole ring, as it was cached for phase 0, turned to where it is."""
        key = (ring, contents, centre)
        cached = self._rings.get(key)
        if cached is None:
            if len(self._rings) >= _MOST_RINGS:
                self._rings.clear()
            cached = self._rings[key] = DisplayList()
            for add in (add_shadow, add_content):
                for slot, content in enumerate(contents):
                    add(cached, ring, content, ring.sector(centre, math.tau * slot / ring.slots))
        out.turn(centre, phase)
        out.extend(cached)
        out.turn(centre, 0.0)


def _resting(scene: Scene, camera: Camera) -> tuple[int, ...]:
    """The rings that the backdrop shows: in the flat view those that do not turn, once the wall stands."""
    if not camera.flat or scene.entry is not None:
        return ()
    return tuple([k for k in wall_rings(scene) if not scene.rings[k].spin])


def _add_glowing(out: DisplayList, centre: complex, ring: FlatRing, contents: tuple[SlotContent, ...], phase: float) -> None:
    """Add the slots of a resting ring that glow: they cover what the backdrop has there."""
    for slot, content in enumerate(contents):
        if content.glow:
            add_content(out, ring, content, ring.sector(centre, phase + math.tau * slot / ring.slots))


def _add_paddles(out: DisplayList, scene: Scene, centre: complex, ring: FlatRing, contents: tuple[SlotContent, ...]) -> None:
    """Add the paddles, each as far out of its slot as a hit has pushed it."""
    out_of_slot = pushed_out(scene, PADDLES)
    for add in (add_shadow, add_content):
        for slot, content in enumerate(contents):
            add(out, ring, content, ring.sector(centre, scene.rings[PADDLES].angle(slot), out_of_slot.get(slot, 0.0)))
