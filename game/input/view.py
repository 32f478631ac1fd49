"""From where the player looks at the arena: the flat view, the solid one, and the camera's path from one to the other.

The camera is the flat view's with some tilt, azimuth and perspective. All three are 0 in the flat view, and what the player
has chosen in the solid one.
"""

import math
from typing import NamedTuple

from game.drawing.camera import Camera, Layout
from game.input.actions import Action
from game.input.signals import Dragged, Pressed, Signal, Zoomed

TIP_SECONDS = 0.9
"""From one end to the other."""
LEAST_TILT, MOST_TILT = math.radians(12.0), math.radians(76.0)
LEAST_ZOOM, MOST_ZOOM = 0.6, 3.0

_CLOSENESS = 0.34
"""The ground's radius over the eye's distance, all tipped."""
_TALLEST = (0.25, 0.3)
"""A high stack to leave room for: its distance behind the centre and its height, as fractions of the ground's radius."""
_SIDE = 2.8
"""Room to the left and to the right of the arena, units of text: for the buttons, where they stand beside it."""
_WIDEST = 0.94
"""Fraction of the surface's width that the arena may fill where they stand above it."""
_ORBIT = math.radians(9.0)
"""Turned by a drag of one unit of text."""
_ZOOM_STEP = 1.12
_MOST_STEPS = 50.0


class Viewpoint(NamedTuple):
    """Where the player looks from.

    goal: 0.0 for the flat view from straight above, 1.0 for the solid one. tipped: how far the camera has come, 0.0 to 1.0.
    azimuth, tilt: of the solid view, radians. zoom: of the solid view, 1.0 shows the whole arena.
    """

    goal: float = 0.0
    tipped: float = 0.0
    azimuth: float = 0.0
    tilt: float = math.radians(52.0)
    zoom: float = 1.0

    def after(self, signal: Signal, unit: float) -> "Viewpoint":
        """The view after a key, a drag or a turn of the wheel. unit: size of text, pixels."""
        match signal:
            case Pressed(Action.TIP):
                return self._replace(goal=1.0 - self.goal)
            case Pressed(Action.FLAT):
                return self._replace(goal=0.0)
            case Pressed(Action.SOLID):
                return self._replace(goal=1.0)
            case Dragged(offset) if self.goal:
                azimuth = (self.azimuth - offset.real / unit * _ORBIT + math.pi) % math.tau - math.pi
                tilt = min(max(self.tilt - offset.imag / unit * _ORBIT, LEAST_TILT), MOST_TILT)
                return self._replace(azimuth=azimuth, tilt=tilt)
            case Zoomed(steps) if self.goal:
                return self._replace(
                    zoom=min(max(self.zoom * _ZOOM_STEP ** min(max(steps, -_MOST_STEPS), _MOST_STEPS), LEAST_ZOOM), MOST_ZOOM)
                )
            case _:
                return self

    def later(self, seconds: float, *, smooth: bool = True) -> "Viewpoint":
        """The view some time later. smooth: False for players who want no camera to move."""
        step = max(seconds, 0.0) / TIP_SECONDS if smooth else 1.0
        change = min(max(self.goal - self.tipped, -step), step)
        return self._replace(tipped=self.tipped + change)

    def seen(self, flat: Layout) -> Layout:
        """The layout with this view's camera in place of the flat one, the arena fitted into the same room."""
        return flat if self.tipped == 0.0 else flat._replace(camera=self._camera(flat))

    def _camera(self, flat: Layout) -> Camera:
        """The camera of a view that is not flat."""
        share = self.tipped * self.tipped * (3.0 - 2.0 * self.tipped)
        camera, tilt = flat.camera, share * self.tilt
        closeness = share * _CLOSENESS / flat.ground_radius
        fitting, low = _fitted(flat, tilt, closeness)
        scale, zoom = camera.scale + (fitting - camera.scale) * share, self.zoom**share
        centre = camera.centre + 1j * low * scale * share * min(
            zoom, 1.0 / zoom
        )  # the nearer, the more it is the wall's middle
        return Camera(centre, scale * zoom, share * self.azimuth, tilt, closeness)


def _fitted(flat: Layout, tilt: float, closeness: float) -> tuple[float, float]:
    """Pixels per world unit for which the arena fits, and how far below the room's middle its centre belongs, world units."""
    radius = flat.ground_radius
    sine, cosine, near = math.sin(tilt), math.cos(tilt), closeness * radius
    across = radius / math.sqrt(1.0 - (near * sine) ** 2)
    below = radius * cosine / (1.0 - near * sine)
    rim = radius * cosine / (1.0 + near * sine)
    behind, height = _TALLEST
    stacks = radius * (behind * cosine + height * sine) / (1.0 + near * (behind * sine - height * cosine))
    above = max(rim, stacks)
    wide = flat.size[0] - 2.0 * _SIDE * flat.unit if flat.beside else _WIDEST * flat.size[0]
    scale = min(2.0 * flat.camera.scale * radius / (below + above), wide / (2.0 * across))
    return max(scale, 1e-3), (above - below) / 2.0


FLAT, SOLID = Viewpoint(), Viewpoint(1.0, 1.0)
