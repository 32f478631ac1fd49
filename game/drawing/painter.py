"""A whole scene drawn through a camera: the order of drawing.

Over the picture, and not from here: the contact normals of both engines and panels (game/screens), figures (game/overlay).
"""

import pygame

from game.drawing import aim, debris, pops, waves
from game.drawing.arcade import drops, gauges, wells
from game.drawing.arcade.icons import PowerIcons
from game.drawing.balls import trail
from game.drawing.balls.ball import BallPictures
from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.flat.picture import FlatPicture
from game.drawing.glows import GlowPictures
from game.drawing.palettes import themed
from game.drawing.slots.contents import slot_contents
from game.drawing.solid.picture import SolidPicture
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
        self._glows = GlowPictures()
        self._icons = PowerIcons()

    def paint(self, canvas: Canvas, scene: Scene) -> None:
        """Draw a scene on a 32-bit surface, in its level's colours where the canvas' theme leaves them to the level."""
        canvas = canvas._replace(theme=themed(canvas.theme, scene.palette))
        if canvas.camera.flat:
            self._paint_flat(canvas, scene)
        else:
            self._paint_solid(canvas, scene)
        drops.draw(canvas, scene, self._icons)
        gauges.draw(canvas, scene, self._icons)
        _shake(canvas.surface, scene, canvas.camera)
        pops.draw(canvas, scene)

    def _paint_flat(self, canvas: Canvas, scene: Scene) -> None:
        """All but the words, from straight above: waves and trail are drawn over the rings, as nothing has height here."""
        self._flat.draw(canvas, scene, slot_contents(scene))
        _draw_on_ground(canvas, scene)
        self._glows.draw(canvas, scene)
        debris.draw(canvas, scene)
        self._balls.draw(canvas, scene)

    def _paint_solid(self, canvas: Canvas, scene: Scene) -> None:
        """All but the words, in 3D: first what lies on the ground, since a standing block can hide it, never the reverse."""
        self._solid.draw_ground(canvas, scene)
        _draw_on_ground(canvas, scene)
        self._glows.draw(canvas, scene)
        blocks = self._solid.draw_blocks(canvas, scene, slot_contents(scene))
        debris.draw(canvas, scene)
        self._balls.draw(canvas, scene, blocks)


def _draw_on_ground(canvas: Canvas, scene: Scene) -> None:
    """What lies on the ground."""
    wells.draw(canvas, scene)
    waves.draw(canvas, scene)
    trail.draw(canvas, scene)
    aim.draw(canvas, scene)


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
