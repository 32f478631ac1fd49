"""What the player holds down, so that every tick can be given its controls."""

import math
from typing import NamedTuple

from game.drawing.camera import Camera, bearing
from game.input.keys import Action
from game.input.signals import Clicked, FocusLost, KeyboardState, Moved, Pressed, Released, Signal
from game.rules import POINTER_STEPS, Controls

_TURNS = (Action.LEFT, Action.RIGHT)


class Hands(NamedTuple):
    """What the player holds down, and where the mouse last took over.

    held: the steering keys that are down, in the order in which they were pressed. Keys, not actions: two keys can mean the
    same, and one of them may come up while the other stays down.
    pointer: pixels; None while the keyboard has the paddles.
    serve, give_up: whether that was asked for since the last tick.
    """

    held: tuple[Pressed, ...] = ()
    pointer: complex | None = None
    serve: bool = False
    give_up: bool = False

    def after(self, signal: Signal) -> "Hands":
        """What is held after one more signal.

        A turning key takes the paddles from the mouse; the mouse takes them back when it moves and no such key is held.
        """
        hands = self
        match signal:
            case Pressed(action) if action in _TURNS:
                hands = self._replace(held=(*self._without(signal.position), signal), pointer=None)
            case Released(_, position):
                hands = self._replace(held=self._without(position))
            case KeyboardState(down):
                hands = self._replace(held=tuple([key for key in self.held if key.position in down]))
            case Pressed(Action.SERVE) | Clicked():
                hands = self._replace(serve=True)
            case Pressed(Action.GIVE_UP):
                hands = self._replace(give_up=True)
            case Moved(pixel) if not self.held:
                hands = self._replace(pointer=pixel)
            case FocusLost():
                hands = Hands()
        return hands

    def controls(self, camera: Camera) -> Controls:
        """The controls of the next tick. The last turning key pressed wins."""
        if self.held:
            return Controls(1 if self.held[-1].action is Action.RIGHT else -1, None, self.serve, self.give_up)
        return Controls(0, _steps(self.pointer, camera), self.serve, self.give_up)

    def after_tick(self) -> "Hands":
        """What is still held once a tick has been given its controls: what is asked for once is asked for no more."""
        return self._replace(serve=False, give_up=False)

    def _without(self, position: int) -> tuple[Pressed, ...]:
        """The held keys but one."""
        return tuple([key for key in self.held if key.position != position])


def _steps(pointer: complex | None, camera: Camera) -> int | None:
    """The pointer's bearing as the rules count it."""
    angle = None if pointer is None else bearing(camera, pointer)
    return None if angle is None else int(angle % math.tau / math.tau * POINTER_STEPS) % POINTER_STEPS
