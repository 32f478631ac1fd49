"""All that the player can have in hand: keyboard, mouse, touch screen and gamepads, as one stream of signals."""

from collections.abc import Iterator

import pygame

from game.input.events import translated
from game.input.fingers import Fingers
from game.input.pads import Pads
from game.input.signals import Signal

_OTHERS = (pygame.KEYDOWN, pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.FINGERDOWN)
"""Events that say that the player holds no gamepad."""


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
        yield from self._fingers.signals(event, size, orbits=orbits)
        if not getattr(event, "touch", False):  # what SDL makes of a finger for those who know mice only
            signal = translated(event, pixels_per_point)
            if signal is not None:
                yield signal
