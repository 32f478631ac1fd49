"""The blocks of the solid view, from back to front, as polygons: prisms with lit sides and the slots' tops.

All blocks stand on the ground. Blocks of one ring are drawn from the far ones to the near ones. Of two rings the far parts of
the outer one come before the inner one, and its near parts after it: `game.drawing.solid.painters_order` says why.
"""

import cmath
import math
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.light import LIGHT, SHADOW_SLANT
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.slots.contents import ContentKind, Contents, SlotContent
from game.drawing.slots.parts import LAYER_HEIGHT, Bar, Slab, SlotShape, height, parts, slot_shape
from game.picture.display_list import DisplayList, inset_half_angle
from game.picture.moving import add_ball
from game.rules import PADDLES
from game.scene import Scene
from physics import Ball, Ring

_DIMMEST, _BRIGHTEST = 0.42, 0.78
"""Shares of its colour that a side shows when it is turned from the light, and towards it."""
_WIDEST = math.radians(6.0)
"""Angle from corner to corner of a prism's arcs, at most."""
_BLACK = (0, 0, 0)
_MOST_SLOTS = 4096


class _Piece(NamedTuple):
    """Something to be drawn: rings from the outermost inwards and out again, and within them from back to front."""

    rank: float
    depth: float
    picture: DisplayList


class SolidBlocks:
    """Draws blocks and balls; caches those of slots that have not moved."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._slots: dict[object, DisplayList] = {}

    def add(self, out: DisplayList, scene: Scene, camera: Camera, theme: Theme, contents: Contents) -> None:
        """Add the shadows, then all blocks and balls from back to front."""
        _add_shadows(out, scene, camera, theme, contents)
        order = sorted(range(len(scene.rings)), key=lambda k: scene.rings[k].radius)
        rank = {k: number + 1 for number, k in enumerate(order)}
        pieces = [_ball_piece(ball, scene, camera, theme, order) for ball in scene.balls]
        falling = {(stack.ring, stack.slot): stack.height for stack in scene.falling}
        recoils = {recoil.slot: recoil.out for recoil in scene.recoils}
        if len(self._slots) > _MOST_SLOTS:
            self._slots.clear()
        for k, ring in enumerate(scene.rings):
            shape = slot_shape(ring, scene.tallest[k], 0.0)
            for slot, content in enumerate(contents[k]):
                if content.kind is ContentKind.EMPTY:
                    continue
                moved = shape._replace(radius=shape.radius + recoils.get(slot, 0.0)) if k == PADDLES else shape
                angle, drop = ring.angle(slot), falling.get((k, slot), 0.0)
                near = -math.sin(angle - camera.azimuth)
                picture = self._slot(moved, content, drop, angle, scene.ground_radius, camera, theme)
                pieces.append(_Piece(rank[k] if _is_near(near, ring, camera) else -rank[k], near, picture))
        for piece in sorted(pieces, key=lambda piece: piece[:2]):
            out.extend(piece.picture)

    def _slot(
        self,
        shape: SlotShape,
        content: SlotContent,
        drop: float,
        angle: float,
        ground_radius: float,
        camera: Camera,
        theme: Theme,
    ) -> DisplayList:
        """The picture of what stands in a slot."""
        key = (shape, content, drop, angle, camera, theme)
        found = self._slots.get(key)
        if found is None:
            found = self._slots[key] = DisplayList()
            unit = LAYER_HEIGHT * ground_radius
            for part in parts(content, shape, drop, theme):
                match part:
                    case Slab():
                        _add_slab(found, part, shape, angle, unit, camera)
                    case Bar():
                        found.polygon(_bar(part, angle, unit, camera), part.colour)
        return found


def _is_near(near: float, ring: Ring, camera: Camera) -> bool:
    """Whether a block is on the near side of its ring, in front of what is within. near: its bearing's sine."""
    return math.sin(camera.tilt) * near > camera.closeness * ring.inner_radius


def _ball_piece(ball: Ball, scene: Scene, camera: Camera, theme: Theme, order: list[int]) -> _Piece:
    """A ball among the rings: in front of those that it is nearer than."""
    picture = DisplayList()
    add_ball(picture, ball, camera, theme)
    distance = abs(ball.position)
    passed = sum([distance > scene.rings[k].radius for k in order])
    bearing = math.atan2(ball.position.imag, ball.position.real) if distance else 0.0
    near = -math.sin(bearing - camera.azimuth)
    front = math.sin(camera.tilt) * near > camera.closeness * distance
    return _Piece(passed + 0.5 if front else -passed - 0.5, near, picture)


def _add_slab(out: DisplayList, slab: Slab, shape: SlotShape, angle: float, unit: float, camera: Camera) -> None:
    """Add a prism: its sides that face the eye, then its top."""
    inner, outer = shape.inner_radius + slab.inset, shape.outer_radius - slab.inset
    halves = inset_half_angle(shape.half_angle, inner, slab.inset), inset_half_angle(shape.half_angle, outer, slab.inset)
    if inner >= outer or min(halves) <= 0.0:
        return
    steps = max(math.ceil(2.0 * halves[1] / _WIDEST), 1)
    shares = [2.0 * k / steps - 1.0 for k in range(steps + 1)]
    inside = [cmath.rect(inner, angle + share * halves[0]) for share in shares]
    outside = [cmath.rect(outer, angle + share * halves[1]) for share in shares]
    foot = [*inside, *reversed(outside)]
    tops = [camera.project(point, slab.top * unit) for point in foot]
    if slab.top > slab.bottom:
        bottoms = [camera.project(point, slab.bottom * unit) for point in foot]
        sides = [(tops[k - 1], tops[k], bottoms[k], bottoms[k - 1]) for k, _ in enumerate(foot)]
        for k, side in enumerate(sides):
            if _faces_the_eye(side):
                shade = _shaded(slab.colour, (foot[k] - foot[k - 1]) * 1j)
                out.polygon(side, shade)
                if k and _faces_the_eye(sides[k - 1]):  # smooth edges of two sides let through what is behind their seam
                    out.line((tops[k - 1], bottoms[k - 1]), 1.0, shade)
    out.polygon(tops, slab.colour)


def _faces_the_eye(side: tuple[complex, complex, complex, complex]) -> bool:
    """Whether a side, its corners taken around the top's outline and back along the foot, is seen from outside."""
    along, down = side[1] - side[0], side[3] - side[0]
    return along.real * down.imag - along.imag * down.real < 0.0


def _shaded(colour: Colour, outward: complex) -> Colour:
    """A side's colour in the light. outward: a direction out of the block."""
    towards = (outward / max(abs(outward), 1e-12) * LIGHT.conjugate()).real
    return mixed(_BLACK, colour, _DIMMEST + (_BRIGHTEST - _DIMMEST) * (0.5 + 0.5 * towards))


def _bar(bar: Bar, angle: float, unit: float, camera: Camera) -> list[complex]:
    """The corners of a bar on a top, pixels."""
    corners = ((bar.inner, -1.0), (bar.inner, 1.0), (bar.outer, 1.0), (bar.outer, -1.0))
    points = [cmath.rect(radius, angle + offset + side * bar.half_width / radius) for (radius, offset), side in corners]
    return [camera.project(point, bar.top * unit) for point in points]


def _add_shadows(out: DisplayList, scene: Scene, camera: Camera, theme: Theme, contents: Contents) -> None:
    """Add the shadows on the ground: of every block its foot, moved down the light."""
    down_light = -LIGHT * SHADOW_SLANT * math.sin(camera.tilt) * LAYER_HEIGHT * scene.ground_radius
    for k, ring in enumerate(scene.rings):
        for slot, content in enumerate(contents[k]):
            if content.kind in (ContentKind.EMPTY, ContentKind.GHOST):
                continue
            angle, half = ring.angle(slot), min(ring.half_angle, math.pi)
            steps = max(math.ceil(half / _WIDEST), 1)
            shares = [2.0 * step / steps - 1.0 for step in range(steps + 1)]
            inside = [cmath.rect(ring.inner_radius, angle + share * half) for share in shares]
            outside = [cmath.rect(ring.outer_radius, angle + share * half) for share in reversed(shares)]
            moved = down_light * height(content)
            out.polygon([camera.project(point + moved) for point in (*inside, *outside)], _BLACK, theme.shadow)
