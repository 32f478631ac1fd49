"""Keys, mouse, fingers and gamepads of a browser as the game's signals."""

import math
from collections.abc import Iterator

from game.drawing.camera import unit_of
from game.input.signals import (
    STICK,
    Clicked,
    Dragged,
    FocusLost,
    Moved,
    Pointed,
    Pressed,
    Released,
    Signal,
    Squeezed,
    Zoomed,
    pad_position,
)
from game.web.client.keys import BUTTONS, key_action, key_position
from game.web.client.messages import KeyChange, PadState, PageSignal, PointerChange, WentAway, WheelTurn

_MAIN, _SECOND = 1, 2
"""Bits of the mouse's buttons."""
_PUSHED, _LET_GO = 0.6, 0.4
"""Shares of a stick's reach: it means something from the first on, until it is below the second."""
_SLACK = 0.08
"""Share of a trigger's travel that does nothing."""
_DOWN = 0.5
"""From here on a button is pressed."""


class PageDevices:
    """Follows every device from message to message."""

    def __init__(self) -> None:
        """Nothing is held."""
        self._fingers: dict[int, complex] = {}  # where each came down, pixels; the newest last
        self._moved: set[int] = set()
        self._mouse = 0j
        self._dragging = False
        self._buttons: tuple[bool, ...] = (False,) * len(BUTTONS)
        self._pointing, self._aiming, self._spin = False, False, 0.0

    def signals(self, message: PageSignal, size: tuple[int, int]) -> Iterator[Signal]:
        """What a message means; nothing for most. size: of the canvas, pixels."""
        match message:
            case KeyChange():
                action = key_action(message.code, message.key)
                if action is not None:
                    kind = Pressed if message.down else Released
                    yield kind(action, key_position(message.code))
            case PointerChange():
                yield from self._finger(message, size) if message.touch else self._mouse_signals(message)
            case WheelTurn():
                yield Zoomed(message.steps)
            case PadState():
                yield from self._pad(message)
            case WentAway():
                self._fingers.clear()
                yield FocusLost()

    def _mouse_signals(self, message: PointerChange) -> Iterator[Signal]:
        """The mouse: its main button clicks, its second one drags the view."""
        pixel = complex(message.x, message.y)
        if message.phase == "down":
            self._dragging = bool(message.buttons & _SECOND)
            if message.buttons & _MAIN:
                yield Clicked(pixel)
        elif message.phase == "move":
            if self._dragging and message.buttons & _SECOND:
                yield Dragged(pixel - self._mouse)
            else:
                yield Moved(pixel, bool(message.buttons & _MAIN))
        self._mouse = pixel

    def _finger(self, message: PointerChange, size: tuple[int, int]) -> Iterator[Signal]:
        """A finger: the newest one points as the mouse does, and one lifted where it came down clicks."""
        pixel, finger = complex(message.x, message.y), message.id
        if message.phase == "down":
            self._fingers[finger] = pixel
            yield Moved(pixel, held=False)
        elif finger not in self._fingers:
            return
        elif message.phase == "move":
            if abs(pixel - self._fingers[finger]) > unit_of(size):
                self._moved.add(finger)
            if finger == next(reversed(self._fingers)):
                yield Moved(pixel, held=finger in self._moved)
        else:
            del self._fingers[finger]
            if finger not in self._moved and message.phase == "up":
                yield Clicked(pixel)
            self._moved.discard(finger)

    def _pad(self, pad: PadState) -> Iterator[Signal]:
        """A gamepad: its buttons, the sticks that point, the triggers that turn."""
        pressed = tuple([value > _DOWN for value in [*pad.buttons, *[0.0] * len(BUTTONS)][: len(BUTTONS)]])
        for number, (now, before, action) in enumerate(zip(pressed, self._buttons, BUTTONS, strict=True)):
            if now != before and action is not None:
                yield (Pressed if now else Released)(action, pad_position(0, min(number, STICK - 1)))
        self._buttons = pressed
        axes = [*pad.axes, 0.0, 0.0, 0.0, 0.0]
        for aims, at in ((False, complex(axes[0], -axes[1])), (True, complex(axes[2], -axes[3]))):
            before = self._aiming if aims else self._pointing
            points = abs(at) >= (_LET_GO if before else _PUSHED)
            if points or before:
                yield Pointed(at / abs(at) if points else 0j, aims)
            if aims:
                self._aiming = points
            else:
                self._pointing = points
        triggers = [*pad.buttons, *[0.0] * 8][6:8]
        left, right = (max(value - _SLACK, 0.0) / (1.0 - _SLACK) for value in triggers)
        if not math.isclose(right - left, self._spin):
            self._spin = right - left
            yield Squeezed(self._spin)
