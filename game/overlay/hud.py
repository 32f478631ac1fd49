"""Draws score, lives and level on the desktop's surface; `game.picture.figures` describes them."""

from functools import lru_cache

from game.drawing.camera import Layout
from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.input.key_names import key_name
from game.input.keys import Action
from game.language import current
from game.overlay.readings import Readings
from game.picture.display_list import DisplayList
from game.picture.figures import Corners, add_figures


def draw(canvas: Canvas, shown: Readings, layout: Layout) -> None:
    """The figures in the four corners of a layout."""
    keys = key_name(Action.HELP), key_name(Action.MUTE)
    picture = _picture(shown, Corners(layout, canvas.theme, canvas.unit, keys), current())
    DisplayListPainter().paint(canvas.surface, canvas.type, picture)


@lru_cache(maxsize=8)
def _picture(shown: Readings, corners: Corners, _language: str) -> DisplayList:
    """The list of primitives, cached, since it seldom changes from frame to frame."""
    out = DisplayList()
    add_figures(out, shown, corners)
    return out
