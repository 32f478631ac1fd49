"""Fingers on a touch screen as signals: the newest one points as the mouse does, and one lifted where it came down clicks.

It clicks only at the end: a finger that comes down to move the paddles must not serve the ball. Where there is a camera to be
moved, two fingers move it: by dragging both, and by pinching.
"""

from collections.abc import Iterator

import pygame

from game.drawing.camera import unit_of
from game.input.signals import Clicked, Moved, Signal
from game.input.two_fingers import two_fingers

_STILL = 1.0
"""Units of text that a finger may move and still click."""
_NOT_FINGERS = (-1, 2**32 - 1, 2**64 - 1)
"""SDL's number, however it is read, of the device that stands for mice and trackpads."""
_PAIR = 2


class Fingers:
    """The fingers that are down."""

    def __init__(self) -> None:
        """None."""
        self._down: dict[tuple[int, int], complex] = {}  # where each came down, pixels; the newest last
        self._now: dict[tuple[int, int], complex] = {}  # where each is
        self._moved: set[tuple[int, int]] = set()

    def signals(self, event: pygame.Event, size: tuple[int, int], *, orbits: bool = False) -> Iterator[Signal]:
        """What an event means; nothing if it is not of a finger. size: of the surface, pixels. orbits: two move the camera."""
        if event.type not in (pygame.FINGERDOWN, pygame.FINGERMOTION, pygame.FINGERUP) or event.touch_id in _NOT_FINGERS:
            return
        finger, pixel = (event.touch_id, event.finger_id), complex(event.x * size[0], event.y * size[1])
        if event.type == pygame.FINGERDOWN:
            self._down[finger] = self._now[finger] = pixel
            if orbits and len(self._down) == _PAIR:
                self._moved |= set(self._down)  # neither of them clicks
            else:
                yield Moved(pixel, held=False)
        elif finger not in self._down:
            return
        elif event.type == pygame.FINGERMOTION:
            yield from self._motion(finger, pixel, size, orbits=orbits)
            self._now[finger] = pixel
        else:
            del self._down[finger], self._now[finger]
            if finger not in self._moved:
                yield Clicked(pixel)
            self._moved.discard(finger)

    def _motion(self, finger: tuple[int, int], pixel: complex, size: tuple[int, int], *, orbits: bool) -> Iterator[Signal]:
        """What a finger's motion means."""
        if abs(pixel - self._down[finger]) > _STILL * unit_of(size):
            self._moved.add(finger)
        if orbits and len(self._down) == _PAIR:
            (other,) = [at for number, at in self._now.items() if number != finger]
            yield from two_fingers(self._now[finger], pixel, other)
        elif finger == next(reversed(self._down)):
            yield Moved(pixel, held=finger in self._moved)
