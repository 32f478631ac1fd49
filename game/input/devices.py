"""All that the player can have in hand: keyboard, mouse, touch screen and gamepads, as one stream of signals."""

from collections.abc import Iterator

import pygame

from game.input.events import translated
from game.input.fingers import Fingers
from game.input.pads import Pads
from game.input.signals import Signal

_OTHERS = (pygame.KEYDOWN, pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.FINGERDOWN)
"""Events that say that the player holds no gamepad."""
_NOT_FINGERS = (-1, 2**32 - 1, 2**64 - 1)
"""SDL's number, however it is read, of the device that stands for mice and trackpads."""


class Devices:
    """Follows every device from event to event."""

    def __init__(self) -> None:
        """Keyboard, mouse and touch screen; gamepads once `pads.listen` was called."""
        self.pads = Pads()
        self._fingers = Fingers()

    def signals(
        self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex, *, orbits: bool = False
    ) -> Iterator[Signal]:
        """What an event means, nothing for most. size: of the surface, pixels. pixels_per_point: as in `translated`.

        orbits: whether two fingers move the camera.
        """
        if event.type in _OTHERS:
            self.pads.left_alone()
        yield from self.pads.signals(event)
        yield from self._finger(event, size, orbits=orbits)
        if not getattr(event, "touch", False):  # what SDL makes of a finger for those who know mice only
            signal = translated(event, pixels_per_point)
            if signal is not None:
                yield signal

    def _finger(self, event: pygame.Event, size: tuple[int, int], *, orbits: bool) -> Iterator[Signal]:
        """What an event means for the touch screen; nothing if it is not of a finger."""
        if event.type not in (pygame.FINGERDOWN, pygame.FINGERMOTION, pygame.FINGERUP) or event.touch_id in _NOT_FINGERS:
            return
        finger, pixel = (event.touch_id, event.finger_id), complex(event.x * size[0], event.y * size[1])
        if event.type == pygame.FINGERDOWN:
            yield from self._fingers.down(finger, pixel, orbits=orbits)
        elif event.type == pygame.FINGERMOTION:
            yield from self._fingers.move(finger, pixel, size, orbits=orbits)
        else:
            yield from self._fingers.up(finger, pixel)
