"""The blocks of the solid view, from back to front, as polygons: prisms with lit sides and the slots' tops.

All blocks stand on the ground. Blocks of one ring are drawn from the far ones to the near ones. Of two rings the far parts of
the outer one come before the inner one, and its near parts after it: `game.drawing.solid.painters_order` says why.
"""

import cmath
import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.light import LIGHT, SHADOW_SLANT
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.slots.contents import ContentKind, Contents, SlotContent
from game.drawing.slots.parts import LAYER_HEIGHT, Bar, Slab, SlotShape, height, parts, slot_shape
from game.picture.display_list import DisplayList, inset_half_angle
from game.picture.moving.balls import add_ball
from game.rules import PADDLES
from game.scene import Scene
from physics import Ball, Ring

_DIMMEST, _BRIGHTEST = 0.42, 0.78
"""Shares of its colour that a side shows when it is turned from the light, and towards it."""
_SHADES = 16
"""Steps from the dimmest to the brightest shade."""
_WIDEST = math.radians(6.0)
"""Angle from corner to corner of a prism's arcs, at most."""
_BLACK = (0, 0, 0)
_MOST_SLOTS = 4096


class _Prism(NamedTuple):
    """A slab, or something painted on a top, of a slot at angle 0.

    outline: seen from above, world units, clockwise on the screen. normals: of its sides, unit, out of it; the side k ends at
    the corner k. bottom, top: world units; of what is only painted, both are the same. colour: of the top.
    """

    outline: tuple[complex, ...]
    normals: tuple[complex, ...]
    bottom: float
    top: float
    colour: Colour


class _Eye(NamedTuple):
    """A camera's numbers, for projecting many points. The points are turned so that the screen's right is their real axis."""

    centre: complex
    scale: float
    sine: float
    cosine: float
    closeness: float

    def pixels(self, points: Sequence[complex], height: float) -> list[complex]:
        """Pixels of points at one height: as `Camera.project`, which is slower for many."""
        centre, scale, sine, cosine, closeness = self
        x, y = centre.real, centre.imag
        near, up = 1.0 - closeness * height * cosine, height * sine
        found = []
        for point in points:
            away = point.imag
            size = scale / (near + closeness * away * sine)
            found.append(complex(x + point.real * size, y - (away * cosine + up) * size))
        return found


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
        eye = _Eye(camera.centre, camera.scale, math.sin(camera.tilt), math.cos(camera.tilt), camera.closeness)
        _add_shadows(out, scene, camera, eye, theme, contents)
        order = sorted(range(len(scene.rings)), key=lambda k: scene.rings[k].radius)
        rank = {k: number + 1 for number, k in enumerate(order)}
        pieces = [_ball_piece(ball, scene, camera, theme, order) for ball in scene.balls]
        falling = {(stack.ring, stack.slot): stack.height for stack in scene.falling}
        recoils = {recoil.slot: recoil.out for recoil in scene.recoils}
        unit = LAYER_HEIGHT * scene.ground_radius
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
                key = (moved, content, drop, angle, eye, camera.azimuth, theme)
                picture = self._slots.get(key)
                if picture is None:
                    picture = self._slots[key] = DisplayList()
                    turn = cmath.rect(1.0, angle)
                    for prism in _prisms(content, moved, drop, unit, theme):
                        _add_prism(picture, prism, turn, camera.turning, eye)
                pieces.append(_Piece(rank[k] if _is_near(near, ring, camera) else -rank[k], near, picture))
        for piece in sorted(pieces, key=lambda piece: piece[:2]):
            out.extend(piece.picture)


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


@lru_cache(maxsize=512)
def _prisms(content: SlotContent, shape: SlotShape, drop: float, unit: float, theme: Theme) -> tuple[_Prism, ...]:
    """What stands in a slot at angle 0, from the lowest part to the highest. unit: height of a layer, world units."""
    found = []
    for part in parts(content, shape, drop, theme):
        match part:
            case Slab(bottom, top, inset, colour):
                outline = _outline(shape, inset)
                if outline:
                    sides = [(outline[k] - outline[k - 1]) * 1j for k in range(len(outline))]
                    normals = tuple([side / max(abs(side), 1e-12) for side in sides])
                    found.append(_Prism(outline, normals, bottom * unit, top * unit, colour))
            case Bar(top, colour=colour):
                found.append(_Prism(_bar(part), (), top * unit, top * unit, colour))
    return tuple(found)


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


def _add_prism(out: DisplayList, prism: _Prism, turn: complex, turning: complex, eye: _Eye) -> None:
    """Add a prism: its sides that face the eye, then its top. turn: of its slot; turning: of the camera."""
    whole = turn * turning
    outline = [point * whole for point in prism.outline]
    tops = eye.pixels(outline, prism.top)
    if prism.top > prism.bottom:
        _add_sides(out, prism, (turn * LIGHT.conjugate()), tops, eye.pixels(outline, prism.bottom))
    out.polygon(tops, prism.colour)


def _add_sides(out: DisplayList, prism: _Prism, light: complex, tops: list[complex], bottoms: list[complex]) -> None:
    """Add the sides that face the eye; neighbours of one shade are one polygon. light: towards it, conjugated."""
    shades, run, shade = _shades(prism.colour), list[int](), -1
    for k, normal in enumerate(prism.normals):
        along, down = tops[k] - tops[k - 1], bottoms[k - 1] - tops[k - 1]
        own = round((0.5 + 0.5 * (normal * light).real) * _SHADES) if along.real * down.imag < along.imag * down.real else -1
        if own != shade:
            if shade >= 0:
                _add_run(out, run, shades[shade], tops, bottoms)
            if own >= 0 and shade >= 0:  # the smooth edges of two polygons let through what is behind their seam
                out.line((tops[k - 1], bottoms[k - 1]), 1.0, shades[own])
            run, shade = [k - 1], own
        run.append(k)
    if shade >= 0:
        _add_run(out, run, shades[shade], tops, bottoms)


def _add_run(out: DisplayList, run: list[int], colour: Colour, tops: list[complex], bottoms: list[complex]) -> None:
    """Add neighbouring sides of one shade, from corner to corner."""
    out.polygon([*[tops[k] for k in run], *[bottoms[k] for k in reversed(run)]], colour)


@lru_cache(maxsize=256)
def _shades(colour: Colour) -> tuple[Colour, ...]:
    """A colour's shades, from turned away from the light to turned towards it."""
    steps = [_DIMMEST + (_BRIGHTEST - _DIMMEST) * k / _SHADES for k in range(_SHADES + 1)]
    return tuple([mixed(_BLACK, colour, step) for step in steps])


def _add_shadows(out: DisplayList, scene: Scene, camera: Camera, eye: _Eye, theme: Theme, contents: Contents) -> None:
    """Add the shadows on the ground: what the foot of every block passes over as it is moved down the light."""
    down_light = -LIGHT * camera.turning * SHADOW_SLANT * eye.sine * LAYER_HEIGHT * scene.ground_radius
    for k, ring in enumerate(scene.rings):
        outline = _outline(slot_shape(ring, scene.tallest[k], 0.0), 0.0)
        for slot, content in enumerate(contents[k]):
            if content.kind not in (ContentKind.EMPTY, ContentKind.GHOST):
                turn = cmath.rect(1.0, ring.angle(slot)) * camera.turning
                moved = down_light * height(content)
                out.polygon(eye.pixels(swept([point * turn for point in outline], moved), 0.0), _BLACK, theme.shadow)


def swept(outline: list[complex], moved: complex) -> list[complex]:
    """The outline of what a foot passes over as it is moved: the sides that face that direction are at its end.

    outline: its corners, clockwise in the world. Where it is concave, the block itself covers what is left out.
    """
    ahead = [((outline[k] - outline[k - 1]) * 1j * moved.conjugate()).real > 0.0 for k in range(len(outline))]
    found = []
    for k, point in enumerate(outline):
        before, after = ahead[k], ahead[(k + 1) % len(outline)]
        here, there = point, point + moved
        found += [there if before else here] if before == after else [there, here] if before else [here, there]
    return found
