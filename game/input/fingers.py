"""Fingers on a touch screen as signals: the newest one points as the mouse does, and one lifted where it came down clicks.

It clicks only at the end: a finger that comes down to move the paddles must not serve the ball. Where there is a camera to be
moved, two fingers move it: by dragging both, and by pinching. Needs no pygame.
"""

import math
from collections.abc import Hashable, Iterator

from game.drawing.camera import unit_of
from game.input.signals import Clicked, Dragged, Moved, Signal, Zoomed
from game.input.view import ZOOM_STEP

_STILL = 1.0
"""Units of text that a finger may move and still click."""
_PAIR = 2
"""Number of fingers that move the camera."""


class Fingers:
    """The fingers that are down.

    Each has an id of any kind. orbits: whether two fingers move the camera, here and below.
    """

    def __init__(self) -> None:
        """None."""
        self._down: dict[Hashable, complex] = {}  # where each came down, pixels; the newest last
        self._now: dict[Hashable, complex] = {}  # the pixel of each
        self._moved: set[Hashable] = set()

    def down(self, finger: Hashable, pixel: complex, *, orbits: bool) -> Iterator[Signal]:
        """The signals of a finger that comes down."""
        self._down[finger] = self._now[finger] = pixel
        if orbits and len(self._down) == _PAIR:
            self._moved |= set(self._down)  # neither of them clicks
        else:
            yield Moved(pixel, held=False)

    def move(self, finger: Hashable, pixel: complex, size: tuple[int, int], *, orbits: bool) -> Iterator[Signal]:
        """The signals of a finger that moves; none if it never came down. size: of the surface, pixels."""
        if finger not in self._down:
            return
        if abs(pixel - self._down[finger]) > _STILL * unit_of(size):
            self._moved.add(finger)
        if orbits and len(self._down) == _PAIR:
            (other,) = [at for known, at in self._now.items() if known != finger]
            yield from _camera_moves(self._now[finger], pixel, other)
        elif finger == next(reversed(self._down)):
            yield Moved(pixel, held=finger in self._moved)
        self._now[finger] = pixel

    def up(self, finger: Hashable, pixel: complex, *, cancelled: bool = False) -> Iterator[Signal]:
        """The signals of a finger that is lifted; none if it never came down. cancelled: whether the system took it away."""
        if finger not in self._down:
            return
        del self._down[finger], self._now[finger]
        if finger not in self._moved and not cancelled:
            yield Clicked(pixel)
        self._moved.discard(finger)

    def clear(self) -> None:
        """Forget all fingers: nobody will tell when they are lifted."""
        self._down.clear()
        self._now.clear()
        self._moved.clear()


def _camera_moves(before: complex, now: complex, other: complex) -> Iterator[Signal]:
    """The signals of a movement by one of two fingers. before, now: its pixels; other: the pixel of the finger at rest."""
    yield Dragged((now - before) / 2.0)
    apart, later = abs(before - other), abs(now - other)
    if apart > 0.0 and later > 0.0:
        yield Zoomed(math.log(later / apart) / math.log(ZOOM_STEP))
