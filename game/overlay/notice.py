"""Draws the line that says what to do now on the desktop's surface; `game.picture.notice` describes it."""

from game.drawing.camera import Layout
from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.overlay.notice_words import Notice
from game.picture.display_list import DisplayList
from game.picture.notice import add_notice, around
from game.scene import Scene


def draw(canvas: Canvas, shown: Notice, scene: Scene, layout: Layout) -> None:
    """The words on a plate at the upper edge of the arena, at the lower one while a ball is at the upper: never over bricks."""
    out = DisplayList()
    add_notice(out, shown, layout, canvas.theme, canvas.unit, around(scene, canvas.camera))
    DisplayListPainter().paint(canvas.surface, canvas.type, out)
