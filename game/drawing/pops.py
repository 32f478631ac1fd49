"""Words that rise and fade where something happened."""

import math

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import mixed
from game.drawing.raster.primitives import draw_box
from game.drawing.text import stepped
from game.effects import Pop
from game.scene import Scene

_RISE = 0.9
"""World units that words rise in their life."""
_SPRING, _CALM = 0.9, 24.0
"""Share by which new words are larger than at rest, and how fast that dies away, per life."""
_SMALLEST, _LARGEST, _BAD_NEWS = 0.9, 1.7, 1.3
"""Sizes of words at rest, in units: for a single brick, for a brick of the best combo, and for bad news."""
_SEAM = 0.07
"""Width of the seam around words, in units; at least a pixel."""
_MARGIN = complex(2.0, 1.0)
"""Units from the surface's edges, across and down, that words stay away from."""
_PLATE_MARGIN, _PLATE_EDGE = (0.7, 0.25), 0.07
"""From words to the ends of their plate, across and down, and the width of its edge, in units."""
_FADING_AGE = 0.5
"""Words fade in the rest of their life from this age on."""


def draw(canvas: Canvas, scene: Scene) -> None:
    """All words, each with a seam in the ground's colour, none beyond the surface's edge."""
    for pop in scene.pops:
        _draw_pop(canvas, pop)


def _draw_pop(canvas: Canvas, pop: Pop) -> None:
    """The words of one event."""
    theme, size, pixel = canvas.theme, _size(pop), _pixel(canvas, pop)
    own = theme.danger if pop.bad else mixed(theme.text, theme.accent, pop.weight)
    fading = mixed(own, theme.ground, max(0.0, (pop.age - _FADING_AGE) / (1.0 - _FADING_AGE)))
    if pop.plate and pop.age < _FADING_AGE:
        words = canvas.type.rendered(pop.text, size * canvas.unit, own)
        _draw_plate(canvas, words.get_rect(center=(round(pixel.real), round(pixel.imag))))
    seam = max(1.0, _SEAM * canvas.unit)
    for offset in (-1.0, 1.0, -1j, 1j):
        canvas.write(pop.text, size, theme.ground, pixel + offset * seam, "center")
    canvas.write(pop.text, size, fading, pixel, "center")


def _draw_plate(canvas: Canvas, words: pygame.Rect) -> None:
    """A plate behind words, so that nothing strikes them through."""
    across, down = (round(2.0 * share * canvas.unit) for share in _PLATE_MARGIN)
    plate, theme = words.inflate(across, down), canvas.theme
    draw_box(canvas.surface, plate, plate.height / 2.0, theme.ground, theme.ground_line, _PLATE_EDGE * canvas.unit)


def _pixel(canvas: Canvas, pop: Pop) -> complex:
    """Where the words' middle is by now."""
    risen = canvas.camera.project(pop.position) - 1j * _RISE * pop.age * canvas.camera.scale
    (width, height), margin = canvas.size, _MARGIN * canvas.unit
    x = min(max(risen.real, margin.real), width - margin.real)
    return complex(x, min(max(risen.imag, margin.imag), height - margin.imag))


def _size(pop: Pop) -> float:
    """Size of the words in units: they spring up, larger the more they mean, and settle."""
    at_rest = _BAD_NEWS if pop.bad else _SMALLEST + (_LARGEST - _SMALLEST) * pop.weight
    spring = 1.0 + _SPRING * math.exp(-pop.age * _CALM) * math.sin(min(pop.age * _CALM, math.pi))
    return stepped(at_rest * spring)
