"""Fingers on a touch screen as signals: the newest one points as the mouse does, and one lifted where it came down clicks.

It clicks only at the end: a finger that comes down to move the paddles must not serve the ball.
"""

from collections.abc import Iterator

import pygame

from game.drawing.camera import unit_of
from game.input.signals import Clicked, Moved, Signal

_STILL = 1.0
"""Units of text that a finger may move and still click."""
_NOT_FINGERS = (-1, 2**32 - 1, 2**64 - 1)
"""SDL's number, however it is read, of the device that stands for mice and trackpads."""


class Fingers:
    """The fingers that are down."""

    def __init__(self) -> None:
        """None."""
        self._down: dict[tuple[int, int], complex] = {}  # where each came down, pixels; the newest last
        self._moved: set[tuple[int, int]] = set()

    def signals(self, event: pygame.Event, size: tuple[int, int]) -> Iterator[Signal]:
        """What an event means; nothing if it is not of a finger. size: of the surface, pixels."""
        if event.type not in (pygame.FINGERDOWN, pygame.FINGERMOTION, pygame.FINGERUP) or event.touch_id in _NOT_FINGERS:
            return
        finger, pixel = (event.touch_id, event.finger_id), complex(event.x * size[0], event.y * size[1])
        if event.type == pygame.FINGERDOWN:
            self._down[finger] = pixel
            yield Moved(pixel, held=False)
        elif finger not in self._down:
            return
        elif event.type == pygame.FINGERMOTION:
            if abs(pixel - self._down[finger]) > _STILL * unit_of(size):
                self._moved.add(finger)
            if finger == next(reversed(self._down)):
                yield Moved(pixel, held=finger in self._moved)
        else:
            del self._down[finger]
            if finger not in self._moved:
                yield Clicked(pixel)
            self._moved.discard(finger)
