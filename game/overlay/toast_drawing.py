"""Draws the words about what a key has changed on the desktop's surface; `game.picture.toast` describes them."""

import pygame

from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.palette import Theme
from game.drawing.raster.primitives import draw_box
from game.overlay.toast import Toast
from game.picture.display_list import DisplayList
from game.picture.toast import add_toast


def draw(canvas: Canvas, toast: Toast) -> None:
    """The words on their plate."""
    out = DisplayList()
    add_toast(out, toast, layout(canvas.size, 1.0), canvas.theme, canvas.unit)
    DisplayListPainter().paint(canvas.surface, canvas.type, out)


def draw_bar(surface: pygame.Surface, track: pygame.Rect, level: float, theme: Theme) -> None:
    """How full something is. track: the whole bar; level: 0 to 1."""
    draw_box(surface, track, track.height / 2.0, theme.panel_edge)
    done = track.copy()
    done.width = round(track.width * level)
    draw_box(surface, done, track.height / 2.0, theme.accent)
