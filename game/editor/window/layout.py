"""How the editor's window is divided: the arena, the lines below it, and the side with the controls."""

from typing import NamedTuple

import pygame

from game.drawing.camera import Camera, layout, unit_of

_LETTERS = 0.7
"""Size of the controls' text in the game's."""
_LEAST = 12.6
"""Pixels: smaller letters are not legible at the usual distance from a screen."""
_SIDE, _LEAST_SIDE, _MOST_SIDE = 23.0, 0.24, 0.42
"""Width of the side in the controls' text, and the least and the most of it in the window's width."""
_FOOT, _MARGIN = 4.6, 0.8
"""Height of the lines below the arena, and around them, in the controls' text at its usual size."""
_MOST_FOOT = 0.22
"""Of the window's height."""
_FILLED = 0.97
"""Size of the ground as a share of the arena's box."""


class EditorLayout(NamedTuple):
    """Boxes of a surface, pixels.

    arena: for the arena. camera: that shows the arena there. foot: for the lines below the arena. side: for the controls.
    unit: size of text in the controls and in these lines.
    """

    arena: pygame.Rect
    camera: Camera
    foot: pygame.Rect
    side: pygame.Rect
    unit: float


def editor_layout(size: tuple[int, int], ground_radius: float, text: float = 1.0) -> EditorLayout:
    """The layout of a surface. size: pixels. ground_radius: world units. text: factor of the text size."""
    width, height = size
    usual = max(unit_of(size) * _LETTERS, _LEAST)
    unit, margin = usual * text, round(usual * _MARGIN)
    side_width = round(min(max(unit * _SIDE, width * _LEAST_SIDE), width * _MOST_SIDE))
    side = pygame.Rect(width - side_width, 0, side_width, height)
    foot_height = round(min(unit * _FOOT, height * _MOST_FOOT))
    foot = pygame.Rect(margin, height - foot_height - margin // 2, max(side.left - 2 * margin, 1), foot_height)
    arena = pygame.Rect(margin, margin, foot.width, max(foot.top - 2 * margin, 1))
    scale = min(arena.size) / 2.0 / ground_radius * _FILLED
    fitted = layout(arena.size, ground_radius).camera
    camera = fitted._replace(centre=complex(*arena.center), scale=max(scale, 1e-3))
    return EditorLayout(arena, camera, foot, side, unit)
