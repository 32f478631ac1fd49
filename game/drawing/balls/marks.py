"""What shows on a ball which power-ups act on it: marks around it that differ in shape as well as in colour."""

import cmath
import math

import pygame

from game.drawing.arcade.signs import power_colour
from game.drawing.canvas import Canvas
from game.drawing.palette import Colour
from game.rules import PowerUp
from game.scene import Scene
from physics import Ball

_SPIKE, _SPIKE_FOOT, _SPIKE_HALF = 1.75, 1.12, 0.34
"""Of a ball that pierces: tip and foot of a spike, and half its foot's angle: radii of the ball, and radians."""
_SPIKES = 4
_CHEVRON, _CHEVRON_APART, _CHEVRON_ARM = 1.5, 0.55, 0.55
"""Of a fast ball: from its middle back to the first chevron, to the second, and half the chevron's width."""
_RING, _RING_PIECES = 1.55, 6
"""Of a slow ball: radius of the broken ring around it, and its pieces."""
_LEAST_LINE, _LINE = 1.5, 0.16
"""Width of lines: pixels, and radii of the ball."""


def draw(canvas: Canvas, scene: Scene, ball: Ball) -> None:
    """The marks of every power-up that acts on balls."""
    camera = canvas.camera
    middle = camera.project(ball.position, ball.radius)
    radius = ball.radius * camera.scale_at(ball.position, ball.radius)
    ahead = camera.project(ball.position + ball.velocity * 1e-3, ball.radius) - middle
    heading = ahead / abs(ahead) if ahead else 1 + 0j
    for power in scene.powers:
        colour = power_colour(power.kind, canvas.theme)
        match power.kind:
            case PowerUp.PIERCE:
                _spikes(canvas.surface, middle, radius, heading, colour)
            case PowerUp.FAST:
                _chevrons(canvas.surface, middle, radius, heading, colour)
            case PowerUp.SLOW:
                _broken_ring(canvas.surface, middle, radius, heading, colour)


def _spikes(surface: pygame.Surface, middle: complex, radius: float, heading: complex, colour: Colour) -> None:
    """Spikes all around, one of them ahead."""
    for k in range(_SPIKES):
        out = heading * cmath.exp(2j * math.pi * k / _SPIKES) * radius
        foot = [out * _SPIKE_FOOT * cmath.exp(1j * side * _SPIKE_HALF) for side in (-1.0, 1.0)]
        _fill(surface, [middle + out * _SPIKE, middle + foot[0], middle + foot[1]], colour)


def _chevrons(surface: pygame.Surface, middle: complex, radius: float, heading: complex, colour: Colour) -> None:
    """Two arrows behind the ball that point ahead."""
    thick = max(_LINE * 1.6, _LEAST_LINE / max(radius, 1.0))
    for away in (_CHEVRON, _CHEVRON + _CHEVRON_APART):
        shape = (-away + 0j, -away - 0.5 + _CHEVRON_ARM * 1j, -away - 0.5 - thick + _CHEVRON_ARM * 1j, -away - thick + 0j)
        for side in (shape, tuple([point.conjugate() for point in shape])):
            _fill(surface, [middle + heading * radius * point for point in side], colour)


def _broken_ring(surface: pygame.Surface, middle: complex, radius: float, heading: complex, colour: Colour) -> None:
    """A ring in pieces around the ball."""
    half = max(_LINE * radius, _LEAST_LINE) / 2.0
    span = math.tau / _RING_PIECES
    for k in range(_RING_PIECES):
        around = [heading * cmath.exp(1j * (k * span + span * 0.6 * step / 4.0)) for step in range(5)]
        outer = [middle + out * (_RING * radius + half) for out in around]
        _fill(surface, [*outer, *[middle + out * (_RING * radius - half) for out in reversed(around)]], colour)


def _fill(surface: pygame.Surface, outline: list[complex], colour: Colour) -> None:
    """A polygon with smooth edges."""
    pygame.draw.polygon(surface, colour, [(point.real, point.imag) for point in outline])
    pygame.draw.aalines(surface, colour, True, [(point.real - 0.5, point.imag - 0.5) for point in outline])
