"""Where a point of the world is on the screen, and back.

The one place that knows the screen's y grows downwards. Seen from straight above, a height changes nothing.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.complex128]

_MARGIN = 0.035
_SQUARE = 1.2
"""Aspect ratios up to this leave no room beside the arena: the head-up display gets bands above and below."""
_BAND = 0.11


class Camera(NamedTuple):
    """Looks straight down. Pixels are continuous: the first pixel's centre is at (0.5, 0.5)."""

    centre: complex  # pixels, of the world's origin; x to the right, y down
    scale: float  # pixels per world unit

    def project(self, point: complex) -> complex:
        """Pixel of a point of the world."""
        return self.centre + point.conjugate() * self.scale

    def unproject(self, pixel: complex) -> complex:
        """Point of the world at a pixel."""
        return ((pixel - self.centre) / self.scale).conjugate()

    def placed(self, outline: Points, angles: NDArray[np.float64]) -> list[Any]:
        """An outline in pixels about angle 0, turned to every angle: per angle a list of [x, y]."""
        turned = outline.conjugate()[None, :] * np.exp(-1j * angles)[:, None] + self.centre
        return turned.view(np.float64).reshape(len(angles), len(outline), 2).tolist()  # type: ignore[no-any-return]


class Layout(NamedTuple):
    """How a surface is divided."""

    size: tuple[int, int]
    camera: Camera
    unit: float  # pixels; text and spacing are multiples of it
    beside: bool  # the head-up display stands beside the arena, else above and below


def layout(size: tuple[int, int], ground_radius: float, below: float = 0.0) -> Layout:
    """The arena as large as the surface allows, with room for the head-up display.

    below: pixels at the bottom to leave free for something else.
    """
    width, height = max(size[0], 1), max(round(size[1] - below), 1)
    beside = width / height > _SQUARE
    free = height if beside else height * (1.0 - 2.0 * _BAND)
    diameter = min(width, free) * (1.0 - 2.0 * _MARGIN)
    camera = Camera(complex(width, height) / 2.0, max(diameter / 2.0 / ground_radius, 1e-3))
    return Layout((width, height), camera, unit_of(size), beside)


def unit_of(size: tuple[int, int]) -> float:
    """Size of body text, pixels: a 34th of the height, less where the window is narrow."""
    return max(min(size[1] / 34.0, size[0] / 44.0), 4.0)


def bearing(camera: Camera, pixel: complex) -> float | None:
    """Direction from the arena's centre to a pixel, radians; None too near to the centre to tell."""
    point = camera.unproject(pixel)
    if abs(point) * camera.scale < 4.0:
        return None
    return math.atan2(point.imag, point.real)
