"""The buttons beside the arena: pause, help and settings by mouse and touch while the ball flies."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
import pygame

from game.drawing.camera import Camera, Layout
from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.raster.primitives import draw_box
from game.drawing.text import Type
from game.input.keys import Action
from game.screens.toolkit.icons import draw_bars, draw_cross, draw_gear, draw_question

# Lengths are in units of text.
_SIDE, _PITCH, _EDGE = 1.9, 2.3, 0.7
"""Side of a button, from one to the next, and to the surface's edge."""
_CORNER, _LINE = 0.45, 0.06
_FINER = 3
"""A button is drawn so much larger and scaled down."""
_FAINT = 0.55
"""A button that the mouse is not on has this share of the way from the background to its colours."""

_PIXELS = Camera(0j, 1.0)
"""For what is no picture of the world."""

Sign = Callable[[Canvas, pygame.Rect, Colour], None]
Buttons = tuple[tuple[Action, Sign], ...]
"""What each means, and what draws its sign in a box."""
PLAYING: Buttons = ((Action.PAUSE, draw_bars), (Action.HELP, draw_question), (Action.SETTINGS, draw_gear))
WATCHING: Buttons = ((Action.BACK, draw_cross), (Action.HELP, draw_question), (Action.SETTINGS, draw_gear))


def button_boxes(layout: Layout, buttons: Buttons = PLAYING) -> tuple[pygame.Rect, ...]:
    """The boxes of the buttons, pixels: half way up the right edge, or higher if the figures are above and below the arena."""
    width, height = layout.size
    side, pitch = max(round(layout.unit * _SIDE), 1), layout.unit * _PITCH
    boxes = []
    for index in range(len(buttons)):
        offset = (index - (len(buttons) - 1) / 2.0) * pitch
        box = pygame.Rect(0, 0, side, side)
        if layout.beside:
            box.midright = (round(width - layout.unit * _EDGE), round(height / 2.0 + offset))
        else:
            box.midtop = (round(width / 2.0 + offset), round(layout.unit * _EDGE))
        boxes.append(box)
    return tuple(boxes)


def action_at(layout: Layout, pixel: complex, buttons: Buttons = PLAYING) -> Action | None:
    """The action of the button at a pixel; None beside the buttons."""
    for (action, _), box in zip(buttons, button_boxes(layout, buttons), strict=True):
        if box.collidepoint(pixel.real, pixel.imag):
            return action
    return None


def draw(canvas: Canvas, layout: Layout, hovered: Action | None, buttons: Buttons = PLAYING) -> None:
    """Draw all buttons, faint except the one under the mouse."""
    for (action, paint), box in zip(buttons, button_boxes(layout, buttons), strict=True):
        canvas.surface.blit(_button(paint, box.size, canvas.theme, canvas.unit, lit=action is hovered), box)


@lru_cache(maxsize=32)
def _button(paint: Sign, size: tuple[int, int], theme: Theme, unit: float, *, lit: bool) -> pygame.Surface:
    """A button's picture with transparent corners. Cached: drawing it takes a millisecond on a large surface."""
    grounds = []
    for ground in ((0, 0, 0), (255, 255, 255)):
        picture = pygame.Surface((size[0] * _FINER, size[1] * _FINER), 0, 32)
        picture.fill(ground)
        edge = theme.accent if lit else mixed(theme.background, theme.panel_edge, _FAINT)
        fill = theme.panel if lit else theme.background
        draw_box(picture, picture.get_rect(), unit * _FINER * _CORNER, fill, edge, unit * _FINER * _LINE)
        canvas = Canvas(picture, _PIXELS, theme._replace(panel=fill), Type(), unit * _FINER)
        paint(canvas, picture.get_rect(), theme.accent if lit else mixed(theme.background, theme.faint, _FAINT + 0.2))
        grounds.append(pygame.surfarray.array3d(pygame.transform.smoothscale(picture, size)).astype(float))
    dark, light = grounds
    cover = 1.0 - (light - dark).mean(axis=2) / 255.0
    cut = pygame.Surface(size, pygame.SRCALPHA, 32)
    pygame.surfarray.blit_array(cut, (dark / np.maximum(cover, 1e-3)[:, :, None]).clip(0.0, 255.0).astype(int))
    pygame.surfarray.pixels_alpha(cut)[:] = np.rint(cover * 255.0).astype(np.uint8)
    return cut
