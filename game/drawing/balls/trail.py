"""The tail behind each ball: where it has just been."""

from collections.abc import Callable
from itertools import pairwise

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, mixed
from game.drawing.raster.primitives import draw_dot
from game.scene import Scene

_WIDTH = 0.85
"""Half the tail's width at the ball, in the ball's radii."""
_LEAST_RADIUS = 0.5
"""Pixels; half the tail's width where it is thinnest."""
_RIBBON = 0.42
"""Half a ribbon's width, in shares of half a tail's at the ball."""
_BEAD, _BEADS_EVERY = 0.6, 3
"""Radius of the bead at the ball, in the same shares, and positions of a trail from one bead to the next."""
_STRENGTH = 0.5
"""At the ball, the tail's colour is this share of the way from the ground's to its own."""
_BEND = 0.02
"""Sine of the angle between two pieces from which a disc rounds the joint."""


def draw(canvas: Canvas, scene: Scene) -> None:
    """Tails that grow and brighten towards their balls, warmer with every brick in a row."""
    if scene.balls:
        for trail in scene.trails:
            pixels = [canvas.camera.project(point) for point in trail]
            _STYLES[canvas.trail](canvas, scene, pixels, _WIDTH * scene.balls[0].radius * canvas.camera.scale)


def _comet(canvas: Canvas, scene: Scene, pixels: list[complex], width: float) -> None:
    """A tail from its thin end on. pixels: of the trail; width: half the tail's at the ball, pixels."""
    _draw_tail(canvas, pixels, width, lambda share: _fading(canvas, _hottest(canvas, scene), share))


def _spectrum(canvas: Canvas, scene: Scene, pixels: list[complex], width: float) -> None:
    """A tail in the colours of a stack's layers."""
    del scene
    colours = canvas.theme.layers
    _draw_tail(canvas, pixels, width, lambda share: _fading(canvas, colours[min(int(share * 7.0), 6)], 0.4 + 0.6 * share))


def _draw_tail(canvas: Canvas, pixels: list[complex], width: float, colour: Callable[[float], Colour]) -> None:
    """A tail that grows wider towards the ball. colour: at a share, 0 to 1, of the way to it."""
    step = width / (len(pixels) + 1)
    before = 0j
    for index, (start, end) in enumerate(pairwise(pixels), 2):
        piece = end - start
        if not piece:
            continue
        own = colour(index / (len(pixels) + 1))
        radius = max(_LEAST_RADIUS, step * (index - 1))
        if abs((piece * before.conjugate()).imag) >= _BEND * abs(piece) * abs(before):
            draw_dot(canvas.surface, start, radius, own)
        _draw_piece(canvas.surface, start, end, radius, max(_LEAST_RADIUS, step * index), own)
        before = piece


def _ribbon(canvas: Canvas, scene: Scene, pixels: list[complex], width: float) -> None:
    """A band of one width."""
    half = max(_RIBBON * width, _LEAST_RADIUS)
    for index, (start, end) in enumerate(pairwise(pixels), 2):
        if start != end:
            own = _fading(canvas, _hottest(canvas, scene), index / (len(pixels) + 1))
            draw_dot(canvas.surface, start, half, own)
            _draw_piece(canvas.surface, start, end, half, half, own)


def _beads(canvas: Canvas, scene: Scene, pixels: list[complex], width: float) -> None:
    """Dots that grow towards the ball."""
    for index, pixel in enumerate(pixels[::-_BEADS_EVERY][::-1], 1):
        share = index * _BEADS_EVERY / (len(pixels) + 1)
        radius = max(_BEAD * width * share, 2.0 * _LEAST_RADIUS)
        draw_dot(canvas.surface, pixel, radius, _fading(canvas, _hottest(canvas, scene), 0.3 + 0.7 * share))


def _rings(canvas: Canvas, scene: Scene, pixels: list[complex], width: float) -> None:
    """Circles that grow away from the ball, as on water."""
    for index, pixel in enumerate(pixels[::-_BEADS_EVERY][::-1], 1):
        share = index * _BEADS_EVERY / (len(pixels) + 1)
        radius, line = max(width * (1.5 - 0.9 * share), 2.0), max(round(width * 0.16), 1)
        corner = (pixel.real - 0.5, pixel.imag - 0.5)
        pygame.draw.aacircle(canvas.surface, _fading(canvas, _hottest(canvas, scene), share), corner, radius, line)


_STYLES: dict[str, Callable[[Canvas, Scene, list[complex], float], None]] = {
    "comet": _comet,
    "ribbon": _ribbon,
    "beads": _beads,
    "rings": _rings,
    "spectrum": _spectrum,
}


def _hottest(canvas: Canvas, scene: Scene) -> Colour:
    """The colour at the ball, warmer with every brick in a row."""
    return mixed(canvas.theme.trail, canvas.theme.accent, scene.heat)


def _fading(canvas: Canvas, colour: Colour, share: float) -> Colour:
    """A tail's colour at a share, 0 to 1, of the way to the ball."""
    return mixed(canvas.theme.ground, colour, _STRENGTH * min(share, 1.0))


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
