"""The top-down picture: a scene drawn through a camera onto a surface.

What rests is drawn once and kept: the ground with the rings that do not turn. When a brick there changes, only its
surroundings are drawn again. What moves is drawn afresh in every frame.
"""

import io
import math
from collections import OrderedDict
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import pygame

from game.drawing import debris as debris_picture
from game.drawing import waves as wave_picture
from game.drawing.ball import Light, ball_picture, light_on, without
from game.drawing.camera import Camera, Points, layout
from game.drawing.flat import recoil as recoil_picture
from game.drawing.flat.recoil import RecoilPicture
from game.drawing.flat.ring import RingPicture, Shape, shape_of
from game.drawing.flat.sector_colours import Look, terrace
from game.drawing.ground import ground_picture
from game.drawing.palette import DARK, Colour, Theme, mixed
from game.drawing.primitives import draw_arrow, draw_dot
from game.drawing.slots import paddle_looks, wall_looks
from game.drawing.solid.ball_occlusion import hiding
from game.drawing.solid.picture import SolidPicture
from game.drawing.text import Type, stepped
from game.effects import NOTHING, Effects, Flash, Pop, Trail
from game.input.view import FROM_ABOVE, Viewpoint
from game.overlay import hud
from game.rules import PADDLES, Game
from game.scene import Scene, scene_at, still
from game.system.files import write_whole
from physics import Ring

_AIM_REACH = 2.4
_BALL_PHASES = 4
"""Places within a pixel, each way, that the ball is drawn for."""
_BALL_SIZES = 4
"""Radii per pixel that it is drawn for."""
_BALL_PICTURES = 512
"""Pictures of it remembered: as it grows from the arena's far side to the near one, at all its places in a pixel."""
_TRAIL_WIDTH, _TRAIL_STRENGTH = 0.85, 0.5
_TRAIL_BEND = 0.02
"""Sine of the angle from which a bend of the tail is round."""
_POP_RISE = 0.9
_POP_SPRING, _POP_CALM = 0.9, 24.0
"""How much larger words are at first, and how soon they calm down, per age."""
_COMMON_LAYERS = 3
"""Stacks up to this height have terraces of the same width."""
_PICTURES = 96
"""Rings remembered; more than one arena may be on the screen."""


class _Kept(NamedTuple):
    """The picture of what rests, and what it shows."""

    size: tuple[int, int]
    camera: Camera
    theme: Theme
    ground_radius: float
    rings: tuple[tuple[int, Ring], ...]
    looks: tuple[tuple[Look, ...], ...]
    picture: pygame.Surface


class Painter:
    """Draws scenes; remembers pictures of what did not change since the last one."""

    def __init__(self, theme: Theme = DARK) -> None:
        """Start with nothing remembered. theme may be changed at any time."""
        self.theme = theme
        self._kept: _Kept | None = None
        self._rings: OrderedDict[Shape, RingPicture] = OrderedDict()
        self._balls: dict[tuple[object, ...], pygame.Surface] = {}
        self._solid = SolidPicture()
        self._recoil = RecoilPicture()

    def paint(self, surface: pygame.Surface, scene: Scene, camera: Camera, type_: Type, unit: float) -> None:
        """Draw a whole scene on a 32-bit surface. unit: pixels, size of body text."""
        flashes: dict[int, list[Flash]] = {}
        for flash in scene.flashes:
            flashes.setdefault(flash.ring, []).append(flash)
        if not camera.flat:
            self._paint_solid(surface, scene, camera, flashes)
        else:
            self._paint_flat(surface, scene, camera, flashes)
        _shake(surface, scene, camera)
        for pop in scene.pops:
            _paint_pop(surface, pop, camera, self.theme, type_, unit)

    def _paint_flat(self, surface: pygame.Surface, scene: Scene, camera: Camera, flashes: dict[int, list[Flash]]) -> None:
        """All but the words, from straight above."""
        self._paint_resting(surface, scene, camera, flashes)
        for k, ring in enumerate(scene.rings):
            if k != PADDLES and ring.spin:
                self.paint_ring(surface, camera, ring, wall_looks(scene.layers[k], flashes.get(k, [])), scene.tallest[k])
        self._paint_paddles(surface, scene, camera, paddle_looks(scene, flashes.get(PADDLES, [])))
        wave_picture.draw(surface, scene.waves, scene.ground_radius, camera, self.theme)
        for trail in scene.trails:
            _paint_trail(surface, trail, scene, camera, self.theme)
        if scene.aim is not None:
            draw_arrow(surface, camera, scene.aim.origin, scene.aim.direction, self.theme, _AIM_REACH)
        debris_picture.draw(surface, scene.bursts, scene, camera, self.theme)
        for ball in scene.balls:
            self._paint_ball(surface, camera.project(ball.position), ball.radius * camera.scale, light_on(camera))

    def _paint_solid(self, surface: pygame.Surface, scene: Scene, camera: Camera, flashes: dict[int, list[Flash]]) -> None:
        """All but the words, tipped: first what lies on the ground, for nothing that stands there can be behind it."""
        self._solid.draw_ground(surface, scene, camera, self.theme)
        wave_picture.draw(surface, scene.waves, scene.ground_radius, camera, self.theme)
        for trail in scene.trails:
            _paint_trail(surface, trail, scene, camera, self.theme)
        if scene.aim is not None:
            draw_arrow(surface, camera, scene.aim.origin, scene.aim.direction, self.theme, _AIM_REACH)
        looks = tuple(
            [
                paddle_looks(scene, flashes.get(k, [])) if k == PADDLES else wall_looks(layers, flashes.get(k, []))
                for k, layers in enumerate(scene.layers)
            ]
        )
        things = self._solid.draw_blocks(surface, scene, looks, camera, self.theme)
        debris_picture.draw(surface, scene.bursts, scene, camera, self.theme)
        for ball in sorted(scene.balls, key=lambda ball: -(ball.position * camera.turning).imag):
            place = camera.project(ball.position, ball.radius)
            radius = ball.radius * camera.scale_at(ball.position, ball.radius)
            hidden = hiding(things, camera, ball.position, place, radius + 2.0)
            self._paint_ball(surface, place, radius, light_on(camera), hidden)

    def _paint_paddles(self, surface: pygame.Surface, scene: Scene, camera: Camera, looks: tuple[Look, ...]) -> None:
        """The paddles from straight above, those that were struck out of their place."""
        paddles = scene.rings[PADDLES]
        self.paint_ring(surface, camera, paddles, recoil_picture.without(looks, scene.recoils), 0)
        for recoil in scene.recoils:
            self._recoil.draw(surface, paddles, recoil, looks[recoil.slot], camera, self.theme)

    def paint_ring(self, surface: pygame.Surface, camera: Camera, ring: Ring, looks: tuple[Look, ...], tallest: int) -> None:
        """Draw one ring and the ground in its gaps. tallest: layers of the highest stack that may ever stand there."""
        step = terrace(ring.half_width, ring.half_angle, ring.inner_radius, max(tallest, _COMMON_LAYERS))
        shape = shape_of(surface, camera, ring, step, self.theme)
        picture = self._rings.get(shape)
        if picture is None:
            picture = self._rings[shape] = RingPicture(shape)
            if len(self._rings) > _PICTURES:
                self._rings.popitem(last=False)
        picture.draw(surface, ring.phase, looks)

    def _paint_resting(self, surface: pygame.Surface, scene: Scene, camera: Camera, flashes: dict[int, list[Flash]]) -> None:
        """The ground and the rings at rest, from memory as far as they are the same."""
        resting = tuple([(k, ring) for k, ring in enumerate(scene.rings) if k != PADDLES and not ring.spin])
        looks = tuple([wall_looks(scene.layers[k], flashes.get(k, [])) for k, _ in resting])
        key = (surface.get_size(), camera, self.theme, scene.ground_radius, resting)
        kept = self._kept
        if kept is None or kept[:5] != key:
            self._rings.clear()
            ground = ground_picture(surface, scene.ground_radius, camera, self.theme)
            kept = _Kept(*key, ((),) * len(resting), ground)
        if kept.looks != looks:  # all of them, for the borders of close rings overlap and the last one drawn wins
            for (k, ring), now in zip(resting, looks, strict=True):
                self.paint_ring(kept.picture, camera, ring, now, scene.tallest[k])
        kept = kept._replace(looks=looks)
        self._kept = kept
        surface.blit(kept.picture, (0, 0))

    def _paint_ball(
        self, surface: pygame.Surface, place: complex, radius: float, light: Light, hidden: Points | None = None
    ) -> None:
        """A ball, placed to a fraction of a pixel. hidden: quadrilaterals on the screen that cover it."""
        left, top = math.floor(place.real), math.floor(place.imag)
        across, down = int((place.real - left) * _BALL_PHASES), int((place.imag - top) * _BALL_PHASES)
        size = round(radius * _BALL_SIZES)
        key = (self.theme, light, size, across, down)
        if key not in self._balls:
            if len(self._balls) >= _BALL_PICTURES:
                self._balls.clear()
            middle = (across + 0.5) / _BALL_PHASES, (down + 0.5) / _BALL_PHASES
            self._balls[key] = ball_picture(size / _BALL_SIZES, *middle, light, self.theme)
        picture = self._balls[key]
        reach = picture.get_width() // 2
        if hidden is not None and len(hidden):
            picture = without(picture, hidden - complex(left - reach, top - reach))
        surface.blit(picture, (left - reach, top - reach))


def save_screenshot(
    game: Game,
    path: Path,
    size: tuple[int, int],
    theme: Theme = DARK,
    view: Viewpoint = FROM_ABOVE,
    effects: Effects = NOTHING,
) -> None:
    """Draw a game as the window shows it, and save it as PNG; OSError where it cannot be written. Needs no display."""
    surface = pygame.Surface(size, 0, 32)
    place = view.seen(layout(size, game.level.ground_radius))
    type_ = Type()
    Painter(theme).paint(surface, scene_at(still(game), 1.0, effects), place.camera, type_, place.unit)
    hud.draw(surface, place, hud.readings(game, effects.streak), theme, type_)
    picture = io.BytesIO()
    pygame.image.save(surface, picture, "screenshot.png")
    write_whole(path, picture.getvalue())


def _shake(surface: pygame.Surface, scene: Scene, camera: Camera) -> None:
    """Move the whole picture by whole pixels: nothing is drawn anew, and the mouse means the same places as before."""
    off = scene.shaken.conjugate() * scene.ground_radius * camera.scale
    across, down = round(off.real), round(off.imag)
    if across or down:
        surface.scroll(across, down)


def _paint_trail(surface: pygame.Surface, trail: Trail, scene: Scene, camera: Camera, theme: Theme) -> None:
    """A tail that grows and brightens towards the ball, warmer with every brick in a row."""
    if not scene.balls:
        return
    hottest = mixed(theme.trail, theme.accent, scene.heat)
    widest = _TRAIL_WIDTH * scene.balls[0].radius * camera.scale
    places = [camera.project(point) for point in trail]
    step = widest / (len(places) + 1)
    before = 0j
    for index, (place, following) in enumerate(pairwise(places), 2):
        way = following - place
        if not way:
            continue
        tint = mixed(theme.ground, hottest, _TRAIL_STRENGTH * index / (len(places) + 1))
        radius = max(0.5, step * (index - 1))
        if abs((way * before.conjugate()).imag) >= _TRAIL_BEND * abs(way) * abs(before):
            draw_dot(surface, place, radius, tint)
        _paint_wedge(surface, place, following, (radius, max(0.5, step * index)), tint)
        before = way


def _paint_wedge(surface: pygame.Surface, start: complex, end: complex, radii: tuple[float, float], colour: Colour) -> None:
    """The piece of a tail between two of its places. radii: half widths at start and end, pixels."""
    way = end - start
    side = way / abs(way) * 1j
    left, right = (start + side * radii[0], end + side * radii[1]), (end - side * radii[1], start - side * radii[0])
    pygame.draw.polygon(surface, colour, [(corner.real, corner.imag) for corner in (*left, *right)])
    for one, other in (left, right):
        pygame.draw.aaline(surface, colour, (one.real - 0.5, one.imag - 0.5), (other.real - 0.5, other.imag - 0.5))


def _pop_size(pop: Pop) -> float:
    """Size of the words in units of text: they spring up, larger the more they mean, and settle."""
    spring = 1.0 + _POP_SPRING * math.exp(-pop.age * _POP_CALM) * math.sin(min(pop.age * _POP_CALM, math.pi))
    return stepped((1.3 if pop.bad else 0.9 + 0.8 * pop.weight) * spring)


def _paint_pop(surface: pygame.Surface, pop: Pop, camera: Camera, theme: Theme, type_: Type, unit: float) -> None:
    """Words that rise and fade, kept on the surface."""
    place = camera.project(pop.position) - 1j * _POP_RISE * pop.age * camera.scale
    width, height = surface.get_size()
    place = complex(min(max(place.real, 2.0 * unit), width - 2.0 * unit), min(max(place.imag, unit), height - unit))
    own = theme.danger if pop.bad else mixed(theme.text, theme.accent, pop.weight)
    fading = mixed(own, theme.ground, max(0.0, 2.0 * pop.age - 1.0))
    size = unit * _pop_size(pop)
    for beside in (-1.0, 1.0, -1j, 1j):
        type_.write(surface, pop.text, size, theme.ground, place + beside * max(1.0, 0.07 * unit), "center")
    type_.write(surface, pop.text, size, fading, place, "center")
