"""How a pane's world lies on the screen, for whatever paints it. Needs neither pygame nor numpy."""

import cmath
import math
from typing import Protocol

from game.drawing.camera import Camera
from game.drawing.palette import Theme
from game.lab.kit.picture import Toggle

FAR = 1e6
"""Pixels: nothing is drawn farther out, as coordinates beyond it overflow."""
_PIXELS_PER_CHORD = 3.0
_MOST_CHORDS = 720


class SeenPane(Protocol):
    """What the shapes of a pane depend on.

    corner, extent: of its part of the surface, pixels. unit: pixels, the measure of lines and points. shown: the toggles that
    are on.
    """

    @property
    def corner(self) -> complex:
        """The upper left one."""

    @property
    def extent(self) -> complex:
        """Width and height."""

    @property
    def camera(self) -> Camera:
        """The projection."""

    @property
    def theme(self) -> Theme:
        """The colours."""

    @property
    def unit(self) -> float:
        """Pixels."""

    @property
    def size(self) -> float:
        """Size of words in the world, pixels."""

    @property
    def shown(self) -> frozenset[Toggle]:
        """The toggles that are on."""


def is_near(pixel: complex) -> bool:
    """Whether a pixel is one that can be drawn to."""
    return abs(pixel.real) < FAR and abs(pixel.imag) < FAR


def arc_pixels(camera: Camera, centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    """Pixels along an arc, close enough to look round. centre, radius: world units; start, sweep: radians."""
    chords = min(max(math.ceil(abs(sweep) * radius * camera.scale / _PIXELS_PER_CHORD), 8), _MOST_CHORDS)
    return [camera.project(centre + cmath.rect(radius, start + sweep * k / chords)) for k in range(chords + 1)]
