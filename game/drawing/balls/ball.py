"""Balls as any camera sees them: shaded discs at fractions of a pixel, without what blocks in front of them hide."""

import math
from typing import NamedTuple

import numpy as np
import pygame

from game.array_maths import ARRAYS
from game.drawing.balls.shading import shaded
from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.light import ScreenLight, ball_light
from game.drawing.palette import Theme
from game.drawing.raster.arrays import Points
from game.drawing.solid.ball_occlusion import occluding_quads
from game.drawing.solid.faces import ProjectedBlocks
from game.scene import Scene
from physics import Ball

_OFFSETS = 4
"""Positions within a pixel, across and down each, that a ball has a picture for."""
_SIZES, _LARGE_SIZES, _LARGE = 4, 2, 12.0
"""Pictures for different radii within a pixel: of small balls, and of balls with a radius of at least `_LARGE` pixels."""
_MOST_PICTURES = 512
"""Pictures cached: of every radius from the arena's far side to the near one, at every position within a pixel."""
_MARGIN = 2.0
"""Blocks this many pixels around a ball are looked at, for they may hide it."""
_FINER = 4
"""Rows and columns per pixel of the drawing that tells how much of a pixel is hidden."""


class _BallLook(NamedTuple):
    """What a ball's picture depends on.

    theme, light: of the picture. skin: its name.
    radius: pixels.
    across, down: offset of the centre within its pixel, in steps of 1 / _OFFSETS pixel.
    """

    theme: Theme
    light: ScreenLight
    skin: str
    radius: float
    across: int
    down: int


class BallPictures:
    """Draws balls; caches their pictures."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._pictures: dict[_BallLook, pygame.Surface] = {}

    def draw(self, canvas: Canvas, scene: Scene, blocks: ProjectedBlocks | None = None) -> None:
        """All balls of a scene, from back to front. blocks: what may hide them."""
        camera = canvas.camera
        for ball in sorted(scene.balls, key=lambda ball: -(ball.position * camera.turning).imag):
            self.draw_ball(canvas, ball, blocks)

    def draw_ball(self, canvas: Canvas, ball: Ball, blocks: ProjectedBlocks | None = None) -> None:
        """Draw a ball. blocks: those that may hide it."""
        camera = canvas.camera
        centre, radius = _on_screen(ball, camera)
        left, top = math.floor(centre.real), math.floor(centre.imag)
        across, down = int((centre.real - left) * _OFFSETS), int((centre.imag - top) * _OFFSETS)
        picture = self._picture(_BallLook(canvas.theme, ball_light(camera), canvas.ball, _stepped(radius), across, down))
        corner = complex(left - picture.get_width() // 2, top - picture.get_height() // 2)
        if blocks is not None:
            hidden = occluding_quads(blocks, camera, ball.position, centre, radius + _MARGIN)
            if len(hidden):
                picture = _without(picture, hidden - corner)
        canvas.surface.blit(picture, (corner.real + canvas.offset[0], corner.imag + canvas.offset[1]))

    def _picture(self, look: _BallLook) -> pygame.Surface:
        """The picture of a ball, drawn once."""
        if look not in self._pictures:
            if len(self._pictures) >= _MOST_PICTURES:
                self._pictures.clear()
            self._pictures[look] = _ball_picture(look)
        return self._pictures[look]


def _on_screen(ball: Ball, camera: Camera) -> tuple[complex, float]:
    """Centre and radius of a ball, pixels. It lies on the ground, so its centre is as high as its radius."""
    return camera.project(ball.position, ball.radius), ball.radius * camera.scale_at(ball.position, ball.radius)


def _stepped(radius: float) -> float:
    """The radius rounded to the steps in which pictures are drawn, pixels: radii that look the same share a picture."""
    steps = _SIZES if radius < _LARGE else _LARGE_SIZES
    return round(radius * steps) / steps


def _ball_picture(look: _BallLook) -> pygame.Surface:
    """A shaded ball on a transparent square with an odd side, its centre in the middle pixel."""
    theme, light, radius = look.theme, look.light, look.radius
    reach = math.ceil(radius) + 2
    side = 2 * reach + 1
    pixels = np.arange(side, dtype=np.float32) + np.float32(0.5 - reach)
    right = (pixels - np.float32((look.across + 0.5) / _OFFSETS))[:, None] / np.float32(max(radius, 0.5))
    up = (np.float32((look.down + 0.5) / _OFFSETS) - pixels)[None, :] / np.float32(max(radius, 0.5))
    picture = pygame.Surface((side, side), pygame.SRCALPHA)
    pygame.surfarray.pixels3d(picture)[:] = np.stack(shaded(ARRAYS, look.skin, theme, light, right, up), axis=2)
    cover = np.clip((1.0 - np.hypot(right, up)) * radius + 0.5, 0.0, 1.0)
    pygame.surfarray.pixels_alpha(picture)[:] = cover * 255.0
    return picture


def _without(picture: pygame.Surface, hidden: Points) -> pygame.Surface:
    """A picture without what quadrilaterals cover, four of its pixels a row, their edges anti-aliased."""
    width, height = picture.get_size()
    fine = pygame.Surface((width * _FINER, height * _FINER), 0, 32)
    fine.fill((255, 255, 255))
    for corners in np.floor(hidden.view(np.float64) * _FINER).astype(int).reshape(-1, 4, 2).tolist():
        pygame.draw.polygon(fine, (0, 0, 0), corners)
    left = picture.copy()
    share = pygame.surfarray.array3d(pygame.transform.smoothscale(fine, (width, height)))[:, :, 0]
    alpha = pygame.surfarray.pixels_alpha(left)
    alpha[:] = alpha * (share / 255.0)
    return left
