"""Gamepads: plugged in and pulled out at any time, their buttons, sticks and triggers as signals.

The left stick does two things: it points, as the paddles follow its angle; and pushed to one side it is a key of that
direction, as menus know it. The right stick points too: it aims the serve. Gamepads are known by SDL's table of them, which
names buttons by where they are on all.
"""

import contextlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import pygame
from pygame._sdl2 import controller

from game.input.keys import KEYS, Action
from game.input.signals import STICK, FocusLost, PadChanged, Pointed, Pressed, Released, Signal, Squeezed, pad_position
from game.input.sticks import beyond_slack, is_pushed

_FULL = 32767
"""Value of an axis at its end."""
_DIRECTIONS = {1: Action.RIGHT, 1j: Action.UP, -1: Action.LEFT, -1j: Action.DOWN}


@dataclass(slots=True)
class _Pad:
    """A gamepad that is plugged in.

    number: SDL's, new for every time that it is plugged in. index: the least that no other has. axes: their values by number.
    points, aims: whether the left and the right stick do. pushed: the direction of the left one as a key, 0 for none.
    """

    device: controller.Controller
    number: int
    index: int
    axes: dict[int, int] = field(default_factory=dict)
    points: bool = False
    aims: bool = False
    pushed: complex = 0

    def share(self, axis: int) -> float:
        """Value of an axis, -1.0 to 1.0."""
        return max(self.axes.get(axis, 0) / _FULL, -1.0)

    def position(self, control: int) -> int:
        """The position of a button, or of a direction of the stick."""
        return pad_position(self.index, control)


class Pads:
    """The gamepads that are plugged in."""

    def __init__(self) -> None:
        """None yet; they announce themselves by events once `listen` was called."""
        self._pads: dict[int, _Pad] = {}
        self._last: int | None = None  # the one that was used last

    def listen(self) -> None:
        """Let the system tell of gamepads; where it cannot, there are none."""
        with contextlib.suppress(pygame.error):
            controller.init()

    def close(self) -> None:
        """Let go of all gamepads, and of the system's part for them."""
        self._pads.clear()
        controller.quit()

    def signals(self, event: pygame.Event) -> Iterator[Signal]:
        """What an event means; nothing if it is not of a gamepad."""
        handlers: dict[int, Callable[[pygame.Event], Iterator[Signal]]] = {
            pygame.CONTROLLERDEVICEADDED: self._added,
            pygame.CONTROLLERDEVICEREMOVED: self._removed,
            pygame.CONTROLLERBUTTONDOWN: self._button,
            pygame.CONTROLLERBUTTONUP: self._button,
            pygame.CONTROLLERAXISMOTION: self._axis,
        }
        handler = handlers.get(event.type)
        return iter(()) if handler is None else handler(event)

    def left_alone(self) -> None:
        """The player uses something else: a gamepad may be pulled out."""
        self._last = None

    def _added(self, event: pygame.Event) -> Iterator[Signal]:
        """A gamepad is there."""
        try:
            device = controller.Controller(event.device_index)
        except pygame.error:  # gone again
            return
        number = device.as_joystick().get_instance_id()
        if number not in self._pads:
            self._pads[number] = _Pad(device, number, self._free_index())
            yield PadChanged(device.name, there=True)

    def _free_index(self) -> int:
        """The least index that no gamepad has."""
        taken = {pad.index for pad in self._pads.values()}
        return next(index for index in range(len(taken) + 1) if index not in taken)

    def _removed(self, event: pygame.Event) -> Iterator[Signal]:
        """A gamepad is gone, with all that was held on it."""
        pad = self._pads.pop(event.instance_id, None)
        if pad is None:
            return
        yield PadChanged(pad.device.name, there=False)
        if self._last == pad.number:
            yield FocusLost()

    def _button(self, event: pygame.Event) -> Iterator[Signal]:
        """A button went down or up."""
        pad, action = self._pads.get(event.instance_id), KEYS.button_action(event.button)
        if pad is None or action is None:
            return
        self._last = pad.number
        kind = Pressed if event.type == pygame.CONTROLLERBUTTONDOWN else Released
        yield kind(action, pad.position(event.button))

    def _axis(self, event: pygame.Event) -> Iterator[Signal]:
        """A stick or a trigger moved."""
        pad = self._pads.get(event.instance_id)
        if pad is None:
            return
        pad.axes[event.axis] = event.value
        if event.axis in (pygame.CONTROLLER_AXIS_LEFTX, pygame.CONTROLLER_AXIS_LEFTY):
            yield from self._stick(pad)
        elif event.axis in (pygame.CONTROLLER_AXIS_RIGHTX, pygame.CONTROLLER_AXIS_RIGHTY):
            yield from self._right_stick(pad)
        elif event.axis in (pygame.CONTROLLER_AXIS_TRIGGERLEFT, pygame.CONTROLLER_AXIS_TRIGGERRIGHT):
            left = beyond_slack(pad.share(pygame.CONTROLLER_AXIS_TRIGGERLEFT))
            right = beyond_slack(pad.share(pygame.CONTROLLER_AXIS_TRIGGERRIGHT))
            self._last = pad.number if left or right else self._last
            yield Squeezed(right - left, pad.index)

    def _right_stick(self, pad: _Pad) -> Iterator[Signal]:
        """The right stick moved."""
        at = complex(pad.share(pygame.CONTROLLER_AXIS_RIGHTX), -pad.share(pygame.CONTROLLER_AXIS_RIGHTY))
        aims = is_pushed(at, before=pad.aims)
        if aims or pad.aims:
            self._last = pad.number
            yield Pointed(at / abs(at) if aims else 0j, aims=True, pad=pad.index)
        pad.aims = aims

    def _stick(self, pad: _Pad) -> Iterator[Signal]:
        """The left stick moved."""
        at = complex(pad.share(pygame.CONTROLLER_AXIS_LEFTX), -pad.share(pygame.CONTROLLER_AXIS_LEFTY))
        points = is_pushed(at, before=pad.points)
        if points:
            self._last = pad.number
            yield Pointed(at / abs(at), pad=pad.index)
        elif pad.points:
            yield Pointed(0j, pad=pad.index)
        pad.points = points
        pushed = _main_direction(at, pad.pushed) if points else 0
        if pushed == pad.pushed:
            return
        if pad.pushed:
            yield Released(_DIRECTIONS[pad.pushed], pad.position(STICK + _index(pad.pushed)))
        if pushed:
            yield Pressed(_DIRECTIONS[pushed], pad.position(STICK + _index(pushed)))
        pad.pushed = pushed


def _main_direction(at: complex, before: complex) -> complex:
    """The one of the four directions that a stick is pushed to; it changes only once another is clearly nearer."""
    shares = {one: (at * one.conjugate()).real + (0.2 if one == before else 0.0) for one in map(complex, _DIRECTIONS)}
    return max(shares, key=shares.__getitem__)


def _index(direction: complex) -> int:
    """Number of a direction."""
    return [complex(one) for one in _DIRECTIONS].index(direction)
