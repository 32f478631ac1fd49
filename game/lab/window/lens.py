"""The view of the world: moved by dragging, zoomed about the pointer, and back to the whole."""

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.drawing.camera import Camera
from game.lab.kit.scene import View
from game.lab.window.canvas import camera_for

_STEP = 1.15
"""Zoomed by one step of the wheel."""
_LEAST, _MOST = 0.05, 200.0
_ROOM = 0.12
"""Around a place that is to be shown, in halves of the view."""
_FARTHEST = 50.0
"""World units that the view's middle may be away from the whole view's."""


class Lens(NamedTuple):
    """How the view differs from the whole one."""

    aside: complex = 0j  # world units
    zoom: float = 1.0

    def camera(self, view: View, area: pygame.Rect) -> Camera:
        """The camera for an area."""
        half = view.half / self.zoom
        return camera_for(View(view.centre + self.aside, half), area)

    @classmethod
    def showing(cls, view: View, places: Sequence[complex]) -> "Lens":
        """The whole view, made wider if need be to show these places with some room around them."""
        half = view.half
        low, high = view.centre - half, view.centre + half
        xs = [low.real, high.real, *[place.real + side * half.real for place in places for side in (-_ROOM, _ROOM)]]
        ys = [low.imag, high.imag, *[place.imag + side * half.imag for place in places for side in (-_ROOM, _ROOM)]]
        middle = complex(max(xs) + min(xs), max(ys) + min(ys)) / 2.0
        zoom = 2.0 * min(half.real / (max(xs) - min(xs)), half.imag / (max(ys) - min(ys)))
        return cls(middle - view.centre, zoom) if zoom < 1.0 else cls()

    def dragged(self, camera: Camera, pixels: complex) -> "Lens":
        """Moved by so many pixels."""
        return self._kept(self.aside - pixels.conjugate() / camera.scale)

    def zoomed(self, camera: Camera, view: View, area: pygame.Rect, pixel: complex, steps: float) -> "Lens":
        """Zoomed by steps of the wheel; what is under the pixel stays there."""
        zoom = min(max(self.zoom * _STEP ** min(max(steps, -20.0), 20.0), _LEAST), _MOST)
        nearer = Lens(self.aside, zoom)
        slipped = camera.unproject(pixel) - nearer.camera(view, area).unproject(pixel)
        return nearer._kept(self.aside + slipped)

    def _kept(self, aside: complex) -> "Lens":
        """Moved, but not out of the world."""
        return Lens(aside if abs(aside) <= _FARTHEST else aside / abs(aside) * _FARTHEST, self.zoom)
