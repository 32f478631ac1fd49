"""What all panels over another screen look like."""

import pygame

from game.drawing.palette import Theme
from game.drawing.raster.primitives import draw_box

_CORNER, _EDGE_LINE = 0.8, 0.08
"""Radius of the panel's corners and width of its edge, in units of text."""
_VEIL = 150
"""How much the screen below is covered by the background's colour, of 255."""


def centred(size: tuple[int, int], width: float, height: float) -> pygame.Rect:
    """The box of a panel in the middle of a surface. All in pixels."""
    return pygame.Rect(round((size[0] - width) / 2), round((size[1] - height) / 2), round(width), round(height))


def dim(surface: pygame.Surface, theme: Theme) -> None:
    """Cover a surface with a veil of the background's colour."""
    veil = pygame.Surface(surface.get_size(), 0, surface)
    veil.fill(theme.background)
    veil.set_alpha(_VEIL)
    surface.blit(veil, (0, 0))


def draw_panel(surface: pygame.Surface, panel: pygame.Rect, theme: Theme, unit: float) -> None:
    """A plain rectangle with round corners and an edge. unit: size of text, pixels."""
    draw_box(surface, panel, unit * _CORNER, theme.panel, theme.panel_edge, unit * _EDGE_LINE)


def index_at(boxes: list[pygame.Rect], pixel: complex) -> int | None:
    """Index of the box that a pixel is in; None outside of all."""
    index = pygame.Rect(pixel.real, pixel.imag, 1, 1).collidelist(boxes)
    return None if index < 0 else index
