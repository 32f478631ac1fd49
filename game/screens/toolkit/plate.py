"""Drawing functions of panels: the plate, the focus frame, and text that fits."""

from functools import lru_cache

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.raster.primitives import draw_box

_CORNER, _EDGE_LINE = 0.8, 0.08
"""Radius of the panel's corners and width of its edge, in units of text."""
_VEIL = 165
"""How much the screen below is covered by the background's colour, of 255."""
_FOCUS_CORNER, _FOCUS_EDGE = 0.5, 0.1
"""Of the box around the item that has the focus: radius of its corners, width of its edge; units of text."""
_FOCUS_TINT, _TINT, _RESTING_EDGE = 0.24, 0.12, 0.06
"""Share of the edge's colour in the box with the focus and in one without it, and the edge of the latter, units of text."""
LABEL, _ITEM_MARGIN = 1.15, 0.7
"""Size of the letters of what an item is called, and from them to the item's edge, units of text."""
_SMALLEST = 0.55
"""Letters are made smaller to fit, but not below this share of their size; the rest of the words is then cut off."""
_SHRINK = 0.96
"""From one try to the next."""


def centred(size: tuple[int, int], width: float, height: float) -> pygame.Rect:
    """The box of a panel in the middle of a surface. All in pixels."""
    return pygame.Rect(round((size[0] - width) / 2), round((size[1] - height) / 2), round(width), round(height))


def dim(surface: pygame.Surface, theme: Theme) -> None:
    """Dim a surface towards the background's colour: by two fills, which take a fifth of the time of a blit."""
    veil = [round(channel * _VEIL / 255) for channel in theme.background]
    surface.fill((255 - _VEIL,) * 3, special_flags=pygame.BLEND_RGB_MULT)
    surface.fill(veil, special_flags=pygame.BLEND_RGB_ADD)


def draw_panel(surface: pygame.Surface, panel: pygame.Rect, theme: Theme, unit: float) -> None:
    """A plain rectangle with round corners and an edge. unit: size of text, pixels."""
    draw_box(surface, panel, unit * _CORNER, theme.panel, theme.panel_edge, unit * _EDGE_LINE)


def draw_focus(canvas: Canvas, box: pygame.Rect, *, focused: bool, resting: bool = False) -> None:
    """The box of an item that has the focus. resting: one without it has a box too."""
    theme, unit = canvas.theme, canvas.unit
    if focused:
        fill = mixed(theme.panel, theme.panel_edge, _FOCUS_TINT)
        draw_box(canvas.surface, box, unit * _FOCUS_CORNER, fill, theme.accent, unit * _FOCUS_EDGE)
    elif resting:
        canvas.surface.blit(_resting_box(box.size, theme, unit), box)


@lru_cache(maxsize=64)
def _resting_box(size: tuple[int, int], theme: Theme, unit: float) -> pygame.Surface:
    """The box of an item without the focus, on the panel's colour: there are many of a size, and round corners take time."""
    picture = pygame.Surface((max(size[0], 1), max(size[1], 1)), 0, 32)
    picture.fill(theme.panel)
    fill = mixed(theme.panel, theme.panel_edge, _TINT)
    draw_box(picture, picture.get_rect(), unit * _FOCUS_CORNER, fill, theme.panel_edge, unit * _RESTING_EDGE)
    return picture


def write_fitting(
    canvas: Canvas, text: str, size: float, colour: Colour, pixel: complex, anchor: str, room: float
) -> pygame.Rect:
    """Write a line, with smaller letters and at last with fewer where it is wider than `room` pixels; its box."""

    def wide() -> int:
        return canvas.type.rendered(text, canvas.unit * size, colour).get_width()

    if wide() > room > 0.0:
        smallest = size * _SMALLEST
        size = max(size * room / wide(), smallest)
        while size > smallest and wide() > room:  # letters have whole pixels
            size = max(size * _SHRINK, smallest)
        while len(text) > 1 and wide() > room:
            text = text[:-2].rstrip() + "…"
    return canvas.write(text, size, colour, pixel, anchor)


def draw_label(canvas: Canvas, label: str, box: pygame.Rect, right: float, *, focused: bool) -> None:
    """Draw an item's label, in smaller letters if it would not fit. right: pixels, the end of its room."""
    colour = canvas.theme.accent if focused else canvas.theme.text
    left = box.left + canvas.unit * _ITEM_MARGIN
    write_fitting(canvas, label, LABEL, colour, complex(left, box.centery), "midleft", right - canvas.unit * 0.6 - left)


def index_at(boxes: list[pygame.Rect], pixel: complex) -> int | None:
    """Index of the box that a pixel is in; None outside of all."""
    index = pygame.Rect(pixel.real, pixel.imag, 1, 1).collidelist(boxes)
    return None if index < 0 else index
