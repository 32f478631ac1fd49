"""A whole scene drawn through a camera: the order of drawing.

Over the picture, and not from here: the contact normals of both engines and panels (game/screens), figures (game/overlay).
"""

from collections.abc import Callable

from game.drawing import debris
from game.drawing.balls.ball import BallPictures
from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.flat.picture import FlatPicture
from game.drawing.palettes import themed
from game.drawing.solid.picture import SolidPicture
from game.picture.display_list import DisplayList
from game.picture.moving.glints import add_glints
from game.picture.moving.layers import add_in_air, add_on_ground
from game.picture.moving.words import add_words
from game.picture.slots.contents import slot_contents
from game.picture.view import ArenaView
from game.scene import Scene


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
        still = canvas._replace(theme=themed(canvas.theme, scene.palette))
        canvas = still._replace(offset=_shaken(scene, canvas))
        if canvas.camera.flat:
            self._paint_flat(canvas, scene)
        else:
            self._paint_solid(canvas, scene)
        self._paint_list(canvas.moved, scene, add_in_air)
        self._paint_list(still, scene, add_words)

    def _paint_flat(self, canvas: Canvas, scene: Scene) -> None:
        """The arena from straight above: waves and trail are drawn over the rings, as nothing has height here."""
        self._flat.draw(canvas, scene, slot_contents(scene))
        self._paint_list(canvas.moved, scene, add_on_ground)
        self._paint_list(canvas.moved, scene, add_glints)
        debris.draw(canvas.moved, scene)
        self._balls.draw(canvas, scene)

    def _paint_solid(self, canvas: Canvas, scene: Scene) -> None:
        """The arena in 3D: first what lies on the ground, since a standing block can hide it, never the reverse."""
        self._solid.draw_ground(canvas, scene)
        self._paint_list(canvas.moved, scene, add_on_ground)
        blocks = self._solid.draw_blocks(canvas, scene, slot_contents(scene))
        self._paint_list(canvas.moved, scene, add_glints)
        debris.draw(canvas.moved, scene)
        self._balls.draw(canvas, scene, blocks)

    def _paint_list(self, canvas: Canvas, scene: Scene, add: Callable[[DisplayList, Scene, ArenaView], None]) -> None:
        """A part of the picture that a list describes. add: what adds it to a list."""
        picture = DisplayList()
        add(picture, scene, canvas.view)
        self._lists.paint(canvas.surface, canvas.type, picture)


def _shaken(scene: Scene, canvas: Canvas) -> tuple[int, int]:
    """Whole pixels by which the picture is off. What a mouse position means is not shifted.

    The offset is conjugated, since y points up in the world and down on the screen. From above all of the arena stays on the
    surface.
    """
    camera, radius = canvas.camera, scene.ground_radius * canvas.camera.scale
    offset, room = scene.shaken.conjugate() * radius, radius
    if camera.flat:
        (width, height), middle = canvas.size, camera.centre
        room = max(min(middle.real, width - middle.real, middle.imag, height - middle.imag) - radius, 0.0)
    across, down = (min(max(part, -room), room) for part in (offset.real, offset.imag))
    return round(across), round(down)
