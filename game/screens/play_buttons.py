"""The buttons beside the arena, so that pause, help and settings can be reached by mouse and touch while the ball flies."""

from collections.abc import Callable

import pygame

from game.drawing.camera import Layout
from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, mixed
from game.drawing.raster.primitives import draw_box
from game.input.keys import Action
from game.screens.toolkit.icons import draw_bars, draw_cross, draw_gear, draw_question

# Lengths are in units of text.
_SIDE, _PITCH, _EDGE = 1.9, 2.3, 0.7
"""Side of a button, from one to the next, and to the surface's edge."""
_CORNER, _LINE = 0.45, 0.06
_FAINT = 0.55
"""A button that the mouse is not on has this share of the way from the background to its colours."""

Buttons = tuple[tuple[Action, Callable[[Canvas, pygame.Rect, Colour], None]], ...]
"""What each means, and what draws its sign in a box."""
PLAYING: Buttons = ((Action.PAUSE, draw_bars), (Action.HELP, draw_question), (Action.SETTINGS, draw_gear))
WATCHING: Buttons = ((Action.BACK, draw_cross), (Action.HELP, draw_question), (Action.SETTINGS, draw_gear))


def button_boxes(layout: Layout, buttons: Buttons = PLAYING) -> tuple[pygame.Rect, ...]:
    """Where they are, pixels: at the right edge, half way up; above the middle where the figures are above and below."""
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
    """What the button at a pixel means; None beside them."""
    for (action, _), box in zip(buttons, button_boxes(layout, buttons), strict=True):
        if box.collidepoint(pixel.real, pixel.imag):
            return action
    return None


def draw(canvas: Canvas, layout: Layout, hovered: Action | None, buttons: Buttons = PLAYING) -> None:
    """All of them, faint but for the one that the mouse is on."""
    theme, unit = canvas.theme, canvas.unit
    for (action, paint), box in zip(buttons, button_boxes(layout, buttons), strict=True):
        lit = action is hovered
        edge = theme.accent if lit else mixed(theme.background, theme.panel_edge, _FAINT)
        draw_box(canvas.surface, box, unit * _CORNER, theme.panel if lit else theme.background, edge, unit * _LINE)
        plain = canvas._replace(theme=theme if lit else theme._replace(panel=theme.background))
        paint(plain, box, theme.accent if lit else mixed(theme.background, theme.faint, _FAINT + 0.2))
