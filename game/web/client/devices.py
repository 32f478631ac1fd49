"""Keys, mouse, fingers and gamepads of a browser as the game's signals."""

import math
from collections.abc import Iterator

from game.input.fingers import Fingers
from game.input.key_names import use_layout
from game.input.keys import KEYS, KeyTable, PadButton
from game.input.signals import (
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
from game.input.sticks import beyond_slack, is_pushed
from game.web.client.keys import PAD_BUTTONS, code_of, layout_of, position_at
from game.web.client.messages import KeyChange, LayoutKnown, PadState, PageSignal, PointerChange, WentAway, WheelTurn

_MAIN, _SECOND = 1, 2
"""Bits of the mouse's buttons."""
_DOWN = 0.5
"""From here on a button is pressed."""
_TRIGGERS = slice(6, 8)
"""The left and the right one among the buttons."""


class PageDevices:
    """Follows every device from message to message."""

    def __init__(self) -> None:
        """Nothing is held."""
        self._fingers = Fingers()
        self._mouse = 0j
        self._dragging = False
        self._pads: dict[int, _Pad] = {}
        self._written: dict[str, str] = {}  # characters on the keys, by code

    def signals(
        self, message: PageSignal, size: tuple[int, int], *, orbits: bool = False, keys: KeyTable = KEYS
    ) -> Iterator[Signal]:
        """The signals of a message; most have none.

        size: of the canvas, pixels. orbits: whether two fingers orbit. keys: what keys mean.
        """
        match message:
            case KeyChange():
                position = position_at(message.code, message.key)
                action = keys.action(position, code_of(message.code, message.key))
                if action is not None:
                    kind = Pressed if message.down else Released
                    yield kind(action, position)
            case PointerChange():
                yield from self._finger(message, size, orbits=orbits) if message.touch else self._mouse_signals(message)
            case WheelTurn():
                yield Zoomed(message.steps)
            case PadState():
                yield from self._pad(message).signals(message)
            case WentAway():
                self._fingers.clear()
                yield FocusLost()

    def learn(self, message: PageSignal) -> None:
        """Note what is written on keys, for their names: what the browser tells, and letters when they are pressed."""
        match message:
            case LayoutKnown(written=written):
                self._written |= written
            case KeyChange(code=code, key=key) if len(key) == 1 and key.isalpha() and self._written.get(code) != key.lower():
                self._written[code] = key.lower()
            case _:
                return
        use_layout(layout_of(self._written))

    def pressed_buttons(self, message: PadState) -> list[PadButton]:
        """The buttons that have just been pressed on a gamepad, whatever they mean."""
        return [button for button, down in self._pad(message).changes(message) if down]

    def _pad(self, message: PadState) -> "_Pad":
        """The gamepad that a message is about."""
        return self._pads.setdefault(message.pad, _Pad(message.pad))

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

    def _finger(self, message: PointerChange, size: tuple[int, int], *, orbits: bool) -> Iterator[Signal]:
        """The signals of a finger."""
        pixel, finger = complex(message.x, message.y), message.id
        if message.phase == "down":
            yield from self._fingers.down(finger, pixel, orbits=orbits)
        elif message.phase == "move":
            yield from self._fingers.move(finger, pixel, size, orbits=orbits)
        else:
            yield from self._fingers.up(finger, pixel, cancelled=message.phase != "up")


class _Pad:
    """The state of one gamepad."""

    def __init__(self, number: int) -> None:
        """Start with nothing held. number: of the gamepad, 0 for the first."""
        self._number = number
        self._buttons: tuple[bool, ...] = (False,) * len(PAD_BUTTONS)
        self._pushed = {False: False, True: False}  # the left stick, which points, and the right one, which aims
        self._spin = 0.0

    def changes(self, pad: PadState) -> list[tuple[PadButton, bool]]:
        """The buttons that went down or up, and whether they are down now."""
        count, before = len(PAD_BUTTONS), self._buttons
        self._buttons = tuple([value > _DOWN for value in [*pad.buttons, *[0.0] * count][:count]])
        changed = zip(PAD_BUTTONS, before, self._buttons, strict=True)
        return [(button, now) for button, was, now in changed if button is not None and now != was]

    def signals(self, pad: PadState) -> Iterator[Signal]:
        """The signals of its buttons, of its sticks, which point, and of its triggers, which turn."""
        for button, down in self.changes(pad):
            action = KEYS.button_action(button)
            if action is not None:
                yield (Pressed if down else Released)(action, pad_position(self._number, button))
        axes = [*pad.axes, 0.0, 0.0, 0.0, 0.0]
        for aims, offset in ((False, complex(axes[0], -axes[1])), (True, complex(axes[2], -axes[3]))):
            before = self._pushed[aims]
            self._pushed[aims] = is_pushed(offset, before=before)
            if self._pushed[aims]:
                yield Pointed(offset / abs(offset), aims, self._number)
            elif before:
                yield Pointed(0j, aims, self._number)
        left, right = map(beyond_slack, [*pad.buttons, *[0.0] * _TRIGGERS.stop][_TRIGGERS])
        if not math.isclose(right - left, self._spin):
            self._spin = right - left
            yield Squeezed(self._spin, self._number)
