"""The tail behind each ball: where it has just been."""

from itertools import pairwise

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, mixed
from game.drawing.raster.primitives import draw_dot
from game.effects import Trail
from game.scene import Scene

_WIDTH = 0.85
"""Half the tail's width at the ball, in the ball's radii."""
_LEAST_RADIUS = 0.5
"""Pixels; half the tail's width where it is thinnest."""
_STRENGTH = 0.5
"""At the ball, the tail's colour is this share of the way from the ground's to its own."""
_BEND = 0.02
"""Sine of the angle between two pieces from which a disc rounds the joint."""


def draw(canvas: Canvas, scene: Scene) -> None:
    """Tails that grow and brighten towards their balls, warmer with every brick in a row."""
    if scene.balls:
        for trail in scene.trails:
            _draw_trail(canvas, scene, trail)


def _draw_trail(canvas: Canvas, scene: Scene, trail: Trail) -> None:
    """One tail, from its thin end on."""
    theme, camera = canvas.theme, canvas.camera
    hottest = mixed(theme.trail, theme.accent, scene.heat)
    pixels = [camera.project(point) for point in trail]
    step = _WIDTH * scene.balls[0].radius * camera.scale / (len(pixels) + 1)
    before = 0j
    for index, (start, end) in enumerate(pairwise(pixels), 2):
        piece = end - start
        if not piece:
            continue
        colour = mixed(theme.ground, hottest, _STRENGTH * index / (len(pixels) + 1))
        radius = max(_LEAST_RADIUS, step * (index - 1))
        if abs((piece * before.conjugate()).imag) >= _BEND * abs(piece) * abs(before):
            draw_dot(canvas.surface, start, radius, colour)
        _draw_piece(canvas.surface, start, end, radius, max(_LEAST_RADIUS, step * index), colour)
        before = piece


def _draw_piece(
    surface: pygame.Surface, start: complex, end: complex, start_radius: float, end_radius: float, colour: Colour
) -> None:
    """A straight piece of a tail. Its ends are pixels; the radii are half its widths there, pixels."""
    aside = (end - start) / abs(end - start) * 1j
    left = start + aside * start_radius, end + aside * end_radius
    right = end - aside * end_radius, start - aside * start_radius
    pygame.draw.polygon(surface, colour, [(corner.real, corner.imag) for corner in (*left, *right)])
    for one, other in (left, right):
        pygame.draw.aaline(surface, colour, (one.real - 0.5, one.imag - 0.5), (other.real - 0.5, other.imag - 0.5))
