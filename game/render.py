"""The top-down picture: a scene drawn through a camera onto a surface.

What rests is drawn once and kept: the ground with the rings that do not turn. When a brick there changes, only its
surroundings are drawn again. What moves is drawn afresh in every frame.
"""

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pygame

from game import hud
from game.camera import Camera, layout
from game.effects import Effects
from game.outlines import disc, sector
from game.palette import DARK, Theme, mixed
from game.rules import PADDLES, Game
from game.scene import Scene, scene_at, still
from game.shapes2d import draw_arrow, draw_bricks, draw_dot, draw_flash, draw_paddles, fill_outline
from game.text import Type
from physics import Ring

_AIM_REACH = 2.4
_BALL_PHASES = 4
"""Places within a pixel, each way, that the ball is drawn for."""
_POP_RISE = 0.9
_ZERO = np.zeros(1)


class _Kept(NamedTuple):
    """The picture of what rests, and what it shows."""

    size: tuple[int, int]
    camera: Camera
    theme: Theme
    ground_radius: float
    track: tuple[float, float]
    rings: tuple[tuple[int, Ring], ...]
    layers: tuple[tuple[int, ...], ...]
    ground: pygame.Surface
    picture: pygame.Surface


class Painter:
    """Draws scenes; remembers pictures of what did not change since the last one."""

    def __init__(self, theme: Theme = DARK) -> None:
        """Start with nothing remembered. theme may be changed at any time."""
        self.theme = theme
        self._kept: _Kept | None = None
        self._balls: dict[tuple[Theme, int, int, int], pygame.Surface] = {}

    def paint(self, surface: pygame.Surface, scene: Scene, camera: Camera, type_: Type, unit: float) -> None:
        """Draw a whole scene. unit: pixels, size of body text."""
        self._paint_resting(surface, scene, camera)
        for trail in scene.trails:
            _paint_trail(surface, trail, scene, camera, self.theme)
        for ring, layers in zip(scene.rings[PADDLES + 1 :], scene.layers[PADDLES + 1 :], strict=True):
            if ring.spin:
                draw_bricks(surface, camera, ring, layers, self.theme, range(ring.count))
        for flash in scene.flashes:
            if flash.ring != PADDLES:
                ring = scene.rings[flash.ring]
                draw_flash(surface, camera, ring, flash.slot, flash.layers, flash.age, self.theme)
        glow = {flash.slot: 1.0 - flash.age for flash in scene.flashes if flash.ring == PADDLES}
        draw_paddles(surface, camera, scene.rings[PADDLES], self.theme, glow)
        if scene.aim is not None:
            draw_arrow(surface, camera, scene.aim.origin, scene.aim.direction, self.theme, _AIM_REACH)
        for ball in scene.balls:
            self._paint_ball(surface, camera.project(ball.position), ball.radius * camera.scale)
        for pop in scene.pops:
            place = camera.project(pop.position) - 1j * _POP_RISE * pop.age * camera.scale
            colour = mixed(self.theme.text, self.theme.ground, max(0.0, 2.0 * pop.age - 1.0))
            type_.write(surface, pop.text, unit * 0.9, colour, place, "center")

    def _paint_resting(self, surface: pygame.Surface, scene: Scene, camera: Camera) -> None:
        """The ground and the rings at rest, from memory as far as they are the same."""
        paddles = scene.rings[PADDLES]
        resting = [(k, ring) for k, ring in enumerate(scene.rings) if k != PADDLES and not ring.spin]
        layers = tuple([scene.layers[k] for k, _ in resting])
        track = (paddles.inner_radius, paddles.outer_radius)
        key = (surface.get_size(), camera, self.theme, scene.ground_radius, track, tuple(resting))
        kept = self._kept
        if kept is None or kept[:6] != key:
            ground = _ground(surface, scene.ground_radius, track, camera, self.theme)
            picture = ground.copy()
            for (_, ring), stacks in zip(resting, layers, strict=True):
                draw_bricks(picture, camera, ring, stacks, self.theme, range(ring.count))
            kept = _Kept(*key, layers, ground, picture)
        elif kept.layers != layers:
            _repaint_changed(kept, layers, camera)
            kept = kept._replace(layers=layers)
        self._kept = kept
        surface.blit(kept.picture, (0, 0))

    def _paint_ball(self, surface: pygame.Surface, place: complex, radius: float) -> None:
        """A ball, placed to a fraction of a pixel."""
        left, top = math.floor(place.real), math.floor(place.imag)
        across, down = int((place.real - left) * _BALL_PHASES), int((place.imag - top) * _BALL_PHASES)
        size = round(radius * 8.0)
        key = (self.theme, size, across, down)
        if key not in self._balls:
            if len(self._balls) > 4 * _BALL_PHASES**2:
                self._balls.clear()
            self._balls[key] = _ball(size / 8.0, (across + 0.5) / _BALL_PHASES, (down + 0.5) / _BALL_PHASES, self.theme)
        picture = self._balls[key]
        reach = picture.get_width() // 2
        surface.blit(picture, (left - reach, top - reach))


def save_screenshot(game: Game, path: Path, size: tuple[int, int], theme: Theme = DARK) -> None:
    """Draw a game as the window shows it, and save it as PNG. Needs no window and no display."""
    surface = pygame.Surface(size)
    ticked = still(game)
    place = layout(size, game.level.ground_radius)
    type_ = Type()
    Painter(theme).paint(surface, scene_at(ticked, 1.0, Effects()), place.camera, type_, place.unit)
    hud.draw(surface, place, hud.readings(game), theme, type_)
    pygame.image.save(surface, path, "screenshot.png")


def _ground(surface: pygame.Surface, radius: float, track: tuple[float, float], camera: Camera, theme: Theme) -> pygame.Surface:
    """The ground with its rim and the paddles' track, on the background."""
    picture = pygame.Surface(surface.get_size(), 0, surface)
    picture.fill(theme.background)
    rim = max(2.0, 0.07 * camera.scale)
    fill_outline(picture, camera, disc(radius * camera.scale + rim), _ZERO, theme.rim)
    fill_outline(picture, camera, disc(radius * camera.scale), _ZERO, theme.ground)
    middle = (track[0] + track[1]) / 2.0 * camera.scale
    fill_outline(picture, camera, disc(middle + 0.75), _ZERO, theme.ground_line)
    fill_outline(picture, camera, disc(middle - 0.75), _ZERO, theme.ground)
    return picture


def _repaint_changed(kept: _Kept, layers: tuple[tuple[int, ...], ...], camera: Camera) -> None:
    """Draw again what lies around the slots that changed."""
    boxes = [_boxes(ring, camera) for _, ring in kept.rings]
    for which, (before, after) in enumerate(zip(kept.layers, layers, strict=True)):
        for slot in [slot for slot in range(len(after)) if before[slot] != after[slot]]:
            dirty = boxes[which][slot]
            kept.picture.set_clip(dirty)
            kept.picture.blit(kept.ground, dirty, dirty)
            for (_, ring), stacks, around in zip(kept.rings, layers, boxes, strict=True):
                touched = [other for other in range(ring.count) if around[other].colliderect(dirty)]
                if touched:
                    draw_bricks(kept.picture, camera, ring, stacks, kept.theme, touched)
    kept.picture.set_clip(None)


def _boxes(ring: Ring, camera: Camera) -> list[pygame.Rect]:
    """Per slot the rectangle of pixels it may touch."""
    outline = sector(ring.inner_radius * camera.scale, ring.outer_radius * camera.scale, ring.half_angle, 0.0)
    if outline is None:
        return [pygame.Rect(0, 0, 0, 0)] * ring.count
    angles = ring.phase + np.arange(ring.count, dtype=np.float64) * (math.tau / ring.count)
    boxes = []
    for points in camera.placed(outline.edge, angles):
        xs, ys = [x for x, _ in points], [y for _, y in points]
        left, top = math.floor(min(xs)) - 2, math.floor(min(ys)) - 2
        boxes.append(pygame.Rect(left, top, math.ceil(max(xs)) + 3 - left, math.ceil(max(ys)) + 3 - top))
    return boxes


def _paint_trail(surface: pygame.Surface, trail: tuple[complex, ...], scene: Scene, camera: Camera, theme: Theme) -> None:
    """A tail of discs that grow and brighten towards the ball."""
    if not scene.balls:
        return
    radius = scene.balls[0].radius * camera.scale
    for index, point in enumerate(trail, 1):
        share = index / (len(trail) + 1)
        draw_dot(surface, camera.project(point), max(1.0, radius * 0.85 * share), mixed(theme.ground, theme.ball, 0.28 * share))


def _ball(radius: float, across: float, down: float, theme: Theme) -> pygame.Surface:
    """A shaded ball on a transparent square with an odd side, its centre (across, down) into the middle pixel."""
    reach = math.ceil(radius) + 2
    side = 2 * reach + 1
    pixels = np.arange(side) + 0.5 - reach
    away = np.hypot(pixels[:, None] - across, pixels[None, :] - down)
    lit = np.hypot(pixels[:, None] - across + 0.3 * radius, pixels[None, :] - down + 0.35 * radius)
    cover = np.clip(radius + 0.5 - away, 0.0, 1.0)
    shade = np.clip(lit / (1.6 * max(radius, 0.5)), 0.0, 1.0)[:, :, None] ** 1.5
    dark = np.array(mixed(theme.ball, theme.rim, 0.75), dtype=np.float64)
    light = np.array(theme.ball, dtype=np.float64)
    picture = pygame.Surface((side, side), pygame.SRCALPHA)
    rgb = (light * (1.0 - shade) + dark * shade).astype(np.uint8)
    pygame.surfarray.pixels3d(picture)[:] = rgb
    pygame.surfarray.pixels_alpha(picture)[:] = (cover * 255.0).astype(np.uint8)
    return picture
