"""The blocks of the solid view, from back to front, as prisms; the painter projects and shades them.

All blocks stand on the ground. Blocks of one ring are drawn from the far ones to the near ones. Of two rings the far parts of
the outer one come before the inner one, and its near parts after it: `game.drawing.solid.painters_order` says why.
"""

import cmath
import math
from functools import lru_cache
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.light import LIGHT, SHADOW_SLANT
from game.drawing.palette import Theme
from game.drawing.slots.contents import ContentKind, Contents, SlotContent
from game.drawing.slots.parts import LAYER_HEIGHT, Bar, Slab, SlotShape, height, parts, slot_shape
from game.picture.display_list import DisplayList, inset_half_angle
from game.picture.moving.balls import add_ball, add_ball_shadow
from game.rules import PADDLES
from game.scene import Scene
from physics import Ball

_SHARES = 0.42, 0.78
"""Brightness, as a share of the colour, of a side that faces away from the light, and of one that faces it."""
_WIDEST = math.radians(6.0)
"""Angle from corner to corner of a prism's arcs, at most."""


class _Piece(NamedTuple):
    """A block, or a ball, to be drawn. The order: rings from the outermost inwards and out again, each from back to front.

    angle: of the slot, for a block.
    """

    rank: float
    depth: float
    picture: DisplayList
    angle: float | None = None


class _RingLook(NamedTuple):
    """The look of a ring's blocks, which does not depend on the ring's angle.

    out_of_slot: how far each slot's content is moved outwards, world units. falling: how far each still has to fall, layers.
    unit: height of a layer, world units.
    """

    contents: tuple[SlotContent, ...]
    shape: SlotShape
    out_of_slot: tuple[tuple[int, float], ...]
    falling: tuple[tuple[int, float], ...]
    unit: float
    theme: Theme


class SolidBlocks:
    """Draws blocks and balls. Caches the prisms of every ring, since they depend neither on its angle nor on the camera."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._rings: dict[int, tuple[_RingLook, list[DisplayList | None]]] = {}

    def add(self, out: DisplayList, scene: Scene, camera: Camera, theme: Theme, contents: Contents, texture: int) -> None:
        """Add the shadows, then all blocks and balls from back to front. texture: of balls."""
        out.camera(camera, LIGHT, _SHARES)
        _add_shadows(out, scene, camera, theme, contents)
        for ball in scene.balls:
            add_ball_shadow(out, ball, camera, theme)
        order = sorted(range(len(scene.rings)), key=lambda k: scene.rings[k].radius)
        pieces = [_ball_piece(ball, scene, camera, texture, order) for ball in scene.balls]
        sine = math.sin(camera.tilt)
        for rank, k in enumerate(order, 1):
            ring, lists = scene.rings[k], self._lists(_ring_look(scene, k, theme, contents[k]), k)
            turn, parting = cmath.rect(1.0, ring.phase - camera.azimuth), camera.closeness * ring.inner_radius
            for picture, (angle, bearing) in zip(lists, _slots(ring.count), strict=True):
                if picture is not None:
                    near = -(bearing * turn).imag
                    pieces.append(_Piece(rank if sine * near > parting else -rank, near, picture, ring.phase + angle))
        for piece in sorted(pieces, key=lambda piece: piece[:2]):
            if piece.angle is not None:
                out.slot(piece.angle)
            out.extend(piece.picture)

    def _lists(self, look: _RingLook, k: int) -> list[DisplayList | None]:
        """The prisms of every slot of a ring; None for an empty one."""
        cached = self._rings.get(k)
        if cached is None or cached[0] != look:
            out_of_slot, falling = dict(look.out_of_slot), dict(look.falling)
            lists = [
                None
                if content.kind is ContentKind.EMPTY
                else _block(
                    content,
                    look.shape._replace(radius=look.shape.radius + out_of_slot.get(slot, 0.0)),
                    falling.get(slot, 0.0),
                    look.unit,
                    look.theme,
                )
                for slot, content in enumerate(look.contents)
            ]
            cached = self._rings[k] = look, lists
        return cached[1]


def _ring_look(scene: Scene, k: int, theme: Theme, contents: tuple[SlotContent, ...]) -> _RingLook:
    """The present look of a ring's blocks."""
    return _RingLook(
        contents,
        slot_shape(scene.rings[k], scene.tallest[k], 0.0),
        tuple([(recoil.slot, recoil.out) for recoil in scene.recoils]) if k == PADDLES else (),
        tuple([(stack.slot, stack.height) for stack in scene.falling if stack.ring == k]),
        LAYER_HEIGHT * scene.ground_radius,
        theme,
    )


@lru_cache(maxsize=256)
def _slots(count: int) -> tuple[tuple[float, complex], ...]:
    """The angle of every slot of a ring with phase 0, and the unit vector in this direction."""
    angles = [math.tau * slot / count for slot in range(count)]
    return tuple([(angle, cmath.rect(1.0, angle)) for angle in angles])


def _ball_piece(ball: Ball, scene: Scene, camera: Camera, texture: int, order: list[int]) -> _Piece:
    """A ball among the rings: in front of those that it is nearer than."""
    picture = DisplayList()
    add_ball(picture, ball, camera, texture)
    distance = abs(ball.position)
    passed = sum([distance > scene.rings[k].radius for k in order])
    bearing = math.atan2(ball.position.imag, ball.position.real) if distance else 0.0
    near = -math.sin(bearing - camera.azimuth)
    front = math.sin(camera.tilt) * near > camera.closeness * distance
    return _Piece(passed + 0.5 if front else -passed - 0.5, near, picture)


@lru_cache(maxsize=512)
def _block(content: SlotContent, shape: SlotShape, drop: float, unit: float, theme: Theme) -> DisplayList:
    """What stands in a slot at angle 0, from the lowest part to the highest. unit: height of a layer, world units."""
    out = DisplayList()
    for part in parts(content, shape, drop, theme):
        match part:
            case Slab(bottom, top, inset, colour):
                outline = _outline(shape, inset)
                if outline:
                    out.prism(outline, bottom * unit, top * unit, colour)
            case Bar(top, colour=colour):
                out.prism(_bar(part), top * unit, top * unit, colour)
    return out


@lru_cache(maxsize=512)
def _outline(shape: SlotShape, inset: float) -> tuple[complex, ...]:
    """A slot's sector, smaller by an inset, at angle 0; empty where that leaves nothing."""
    inner, outer = shape.inner_radius + inset, shape.outer_radius - inset
    halves = inset_half_angle(shape.half_angle, inner, inset), inset_half_angle(shape.half_angle, outer, inset)
    if inner >= outer or min(halves) <= 0.0:
        return ()
    steps = max(math.ceil(2.0 * halves[1] / _WIDEST), 1)
    shares = [2.0 * k / steps - 1.0 for k in range(steps + 1)]
    inside = [cmath.rect(inner, share * halves[0]) for share in shares]
    return (*inside, *[cmath.rect(outer, share * halves[1]) for share in reversed(shares)])


def _bar(bar: Bar) -> tuple[complex, ...]:
    """The corners of a bar on a top."""
    corners = ((bar.inner, -1.0), (bar.inner, 1.0), (bar.outer, 1.0), (bar.outer, -1.0))
    return tuple([cmath.rect(radius, offset + side * bar.half_width / radius) for (radius, offset), side in corners])


def _add_shadows(out: DisplayList, scene: Scene, camera: Camera, theme: Theme, contents: Contents) -> None:
    """Add the shadows on the ground: what the foot of every block passes over as it is moved down the light."""
    down_light = -LIGHT * SHADOW_SLANT * math.sin(camera.tilt) * LAYER_HEIGHT * scene.ground_radius
    for k, ring in enumerate(scene.rings):
        standing = [
            (ring.phase + angle, height(content))
            for content, (angle, _bearing) in zip(contents[k], _slots(ring.count), strict=True)
            if content.kind not in (ContentKind.EMPTY, ContentKind.GHOST)
        ]
        if standing:
            outline = _outline(slot_shape(ring, scene.tallest[k], 0.0), 0.0)
            out.shadows(outline, down_light, standing, theme.shadow)
