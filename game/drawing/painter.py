"""A whole scene drawn through a camera: the order of drawing.

Over the picture, and not from here: the contact normals of both engines and panels (game/screens), figures (game/overlay).
"""

from collections.abc import Callable

import pygame

from game.drawing import debris
from game.drawing.balls.ball import BallPictures
from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.flat.picture import FlatPicture
from game.drawing.palettes import themed
from game.drawing.slots.contents import slot_contents
from game.drawing.solid.picture import SolidPicture
from game.picture.display_list import DisplayList
from game.picture.moving.layers import add_in_air, add_on_ground
from game.picture.moving.words import add_words
from game.picture.view import ArenaView
from game.scene import Scene

_SHAKEN = 1.25
"""From the centre to the left and right ends of what is shaken, in ground radii: the rim's glow is gone there."""


class Painter:
    """Draws scenes; caches pictures of what did not change since the last one."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._flat = FlatPicture()
        self._solid = SolidPicture()
        self._balls = BallPictures()
        self._lists = DisplayListPainter()

    def paint(self, canvas: Canvas, scene: Scene) -> None:
        """Draw a scene on a 32-bit surface, in its level's colours where the canvas' theme leaves them to the level."""
        canvas = canvas._replace(theme=themed(canvas.theme, scene.palette))
        if canvas.camera.flat:
            self._paint_flat(canvas, scene)
        else:
            self._paint_solid(canvas, scene)
        self._paint_list(canvas, scene, add_in_air)
        _shake(canvas.surface, scene, canvas.camera)
        self._paint_list(canvas, scene, add_words)

    def _paint_flat(self, canvas: Canvas, scene: Scene) -> None:
        """The arena from straight above: waves and trail are drawn over the rings, as nothing has height here."""
        self._flat.draw(canvas, scene, slot_contents(scene))
        self._paint_list(canvas, scene, add_on_ground)
        debris.draw(canvas, scene)
        self._balls.draw(canvas, scene)

    def _paint_solid(self, canvas: Canvas, scene: Scene) -> None:
        """The arena in 3D: first what lies on the ground, since a standing block can hide it, never the reverse."""
        self._solid.draw_ground(canvas, scene)
        self._paint_list(canvas, scene, add_on_ground)
        blocks = self._solid.draw_blocks(canvas, scene, slot_contents(scene))
        debris.draw(canvas, scene)
        self._balls.draw(canvas, scene, blocks)

    def _paint_list(self, canvas: Canvas, scene: Scene, add: Callable[[DisplayList, Scene, ArenaView], None]) -> None:
        """A part of the picture that a list describes. add: what adds it to a list."""
        picture = DisplayList()
        add(picture, scene, canvas.view)
        self._lists.paint(canvas.surface, canvas.type, picture)


def _shake(surface: pygame.Surface, scene: Scene, camera: Camera) -> None:
    """Move the arena and what is near it by whole pixels: nothing is drawn anew. What a mouse position means is not shifted.

    The offset is conjugated, since y points up in the world and down on the screen.
    """
    offset = scene.shaken.conjugate() * scene.ground_radius * camera.scale
    across, down = round(offset.real), round(offset.imag)
    if across or down:
        reach = _SHAKEN * scene.ground_radius
        left, right = (camera.project(side * reach / camera.turning).real for side in (-1.0, 1.0))
        before = surface.get_clip()
        surface.set_clip(before.clip((round(left), 0, round(right - left), surface.height)))
        surface.scroll(across, down)
        surface.set_clip(before)
