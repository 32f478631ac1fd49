"""From where the player looks at the arena: the flat view, the solid one, and the camera's path from one to the other.

The camera is the flat view's with some tilt, azimuth and perspective. All three are 0 in the flat view, and what the player
has chosen in the solid one.
"""

import math
from typing import NamedTuple

from game.drawing.camera import Camera, Layout
from game.input.actions import Action
from game.input.signals import (
    PAD_POSITIONS,
    Dragged,
    FocusLost,
    KeyboardState,
    Pointed,
    Pressed,
    Released,
    Signal,
    Zoomed,
)

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
ZOOM_STEP = 1.12
"""Factor of the zoom for a step of the wheel."""
_MOST_STEPS = 50.0
_ORBIT_SPEED, _TILT_SPEED = math.radians(110.0), math.radians(55.0)
"""Radians per second, of a key or a stick."""
_ZOOM_SPEED = 9.0
"""Steps of the wheel per second that a key is worth."""
_MOTIONS = {
    Action.ORBIT_LEFT: (-1.0, 0.0, 0.0),
    Action.ORBIT_RIGHT: (1.0, 0.0, 0.0),
    Action.TILT_UP: (0.0, 1.0, 0.0),
    Action.TILT_DOWN: (0.0, -1.0, 0.0),
    Action.ZOOM_IN: (0.0, 0.0, 1.0),
    Action.ZOOM_OUT: (0.0, 0.0, -1.0),
}
"""What a key that is held does: the camera to the right, up, and nearer."""


class Viewpoint(NamedTuple):
    """Where the player looks from.

    goal: 0.0 for the flat view from straight above, 1.0 for the solid one. tipped: how far the camera has come, 0.0 to 1.0.
    azimuth, tilt: of the solid view, radians. zoom: of the solid view, 1.0 shows the whole arena.
    held: keys and buttons that move the camera as long as they are down. stick: direction that a gamepad's right stick points
    to, which moves it too; 0 for none.
    """

    goal: float = 0.0
    tipped: float = 0.0
    azimuth: float = 0.0
    tilt: float = math.radians(52.0)
    zoom: float = 1.0
    held: tuple[Pressed, ...] = ()
    stick: complex = 0j

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
                return _turned(self, -offset.real / unit * _ORBIT, -offset.imag / unit * _ORBIT)
            case Zoomed(steps) if self.goal:
                return _zoomed(self, steps)
            case _:
                return self._holding(signal)

    def _holding(self, signal: Signal) -> "Viewpoint":
        """The view after a key that moves the camera as long as it is down, or after the right stick."""
        match signal:
            case Pressed(action) if action in _MOTIONS:
                return self._replace(held=(*[key for key in self.held if key.position != signal.position], signal))
            case Released(_, position) if self.held:
                return self._replace(held=tuple([key for key in self.held if key.position != position]))
            case KeyboardState(down) if self.held:
                still = [key for key in self.held if key.position in down or key.position >= PAD_POSITIONS]
                return self._replace(held=tuple(still))
            case Pointed(direction, aims=True):
                return self._replace(stick=direction)
            case FocusLost():
                return self._replace(held=(), stick=0j)
            case _:
                return self

    def later(self, seconds: float, *, smooth: bool = True) -> "Viewpoint":
        """The view some time later. smooth: False for players who want no camera to move."""
        step = max(seconds, 0.0) / TIP_SECONDS if smooth else 1.0
        change = min(max(self.goal - self.tipped, -step), step)
        return _moved(self._replace(tipped=self.tipped + change), max(seconds, 0.0))

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


def _moved(view: Viewpoint, seconds: float) -> Viewpoint:
    """The view after what is held has moved the camera for some time."""
    if not view.goal or not (view.held or view.stick):
        return view
    stick = (view.stick.real, view.stick.imag, 0.0)
    right, up, nearer = map(sum, zip(stick, *[_MOTIONS[key.action] for key in view.held], strict=True))
    turned = _turned(view, right * _ORBIT_SPEED * seconds, -up * _TILT_SPEED * seconds)
    return _zoomed(turned, nearer * _ZOOM_SPEED * seconds)


def _turned(view: Viewpoint, azimuth: float, tilt: float) -> Viewpoint:
    """The view with the camera turned around the arena and tilted further, radians."""
    around = (view.azimuth + azimuth + math.pi) % math.tau - math.pi
    return view._replace(azimuth=around, tilt=min(max(view.tilt + tilt, LEAST_TILT), MOST_TILT))


def _zoomed(view: Viewpoint, steps: float) -> Viewpoint:
    """The view from so many steps of the wheel nearer."""
    zoom = view.zoom * ZOOM_STEP ** min(max(steps, -_MOST_STEPS), _MOST_STEPS)
    return view._replace(zoom=min(max(zoom, LEAST_ZOOM), MOST_ZOOM))


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
