"""What keys and buttons mean: one table from them to actions, read by the window, the help and the tests alike.

A key is known by two numbers. Its *position* (a scancode) says where it is on the keyboard, whatever the layout. Its *code*
says what the layout writes on it. Steering goes by position, so that the two keys lie beside each other on every layout;
commands go by what is written on the key, so that P pauses wherever P is. A key that the player has chosen goes by position
(game/input/rebinding.py).
"""

from collections.abc import Iterable
from enum import IntEnum
from typing import NamedTuple

from game.input.actions import Action
from game.input.scancodes import SCANCODES, US_CODES, code_at

__all__ = ["BINDINGS", "KEYS", "Action", "Binding", "KeyTable", "PadButton"]


class PadButton(IntEnum):
    """Buttons of a gamepad, as SDL counts and names them: by where they are, whatever is written on them."""

    A = 0
    B = 1
    X = 2
    Y = 3
    BACK = 4
    GUIDE = 5
    START = 6
    LEFTSTICK = 7
    RIGHTSTICK = 8
    LEFTSHOULDER = 9
    RIGHTSHOULDER = 10
    DPAD_UP = 11
    DPAD_DOWN = 12
    DPAD_LEFT = 13
    DPAD_RIGHT = 14


class Binding(NamedTuple):
    """The keys and buttons of one action.

    codes: what is written on its keys, as SDL counts it; the first is the one that the help names.
    positions: scancodes, keys that mean the action wherever they are found there, whatever is written on them.
    buttons: of a gamepad.
    """

    action: Action
    codes: tuple[int, ...] = ()
    positions: tuple[int, ...] = ()
    buttons: tuple[int, ...] = ()


def _written(*names: str) -> tuple[int, ...]:
    """Codes: of characters, and of keys without one by the browsers' names."""
    return tuple([ord(name) if len(name) == 1 else code_at(SCANCODES[name]) for name in names])


def _at(*names: str) -> tuple[int, ...]:
    """Positions by the browsers' names."""
    return tuple([SCANCODES[name] for name in names])


BINDINGS = (
    Binding(Action.LEFT, positions=_at("ArrowLeft", "KeyA"), buttons=(PadButton.DPAD_LEFT,)),
    Binding(Action.RIGHT, positions=_at("ArrowRight", "KeyD"), buttons=(PadButton.DPAD_RIGHT,)),
    Binding(Action.UP, _written("ArrowUp", "w"), buttons=(PadButton.DPAD_UP,)),
    Binding(Action.DOWN, _written("ArrowDown", "s"), buttons=(PadButton.DPAD_DOWN,)),
    Binding(Action.SERVE, _written("Space"), buttons=(PadButton.A,)),
    Binding(Action.CONFIRM, _written("Enter", "NumpadEnter")),
    Binding(Action.PAUSE, _written("p", "Pause"), buttons=(PadButton.START,)),
    Binding(Action.RESTART, _written("r")),
    Binding(Action.BACK, _written("Escape"), buttons=(PadButton.B,)),
    Binding(Action.HELP, _written("h", "F1"), buttons=(PadButton.BACK,)),
    Binding(Action.FULL_SCREEN, _written("F11")),
    Binding(Action.MUTE, _written("m")),
    Binding(Action.THEME, _written("t")),
    Binding(Action.EFFECTS, _written("e")),
    Binding(Action.SETTINGS, _written("o")),
    Binding(Action.NORMALS, _written("n")),
    Binding(Action.LAB, _written("l")),
    Binding(Action.GIVE_UP, _written("g"), buttons=(PadButton.X,)),
    Binding(Action.STEP_BACK, _written(","), buttons=(PadButton.LEFTSHOULDER,)),
    Binding(Action.STEP, _written("."), buttons=(PadButton.RIGHTSHOULDER,)),
    Binding(Action.LESS, _written("-", "NumpadSubtract")),
    Binding(Action.MORE, _written("+", "=", "NumpadAdd")),
    Binding(Action.START, _written("Home")),
    Binding(Action.END, _written("End")),
    Binding(Action.TIP, _written("Tab"), buttons=(PadButton.Y,)),
    Binding(Action.FLAT, _written("1", "Numpad1")),
    Binding(Action.SOLID, _written("2", "Numpad2")),
    Binding(Action.ORBIT_LEFT, positions=_at("KeyZ")),
    Binding(Action.ORBIT_RIGHT, positions=_at("KeyX")),
    Binding(Action.TILT_UP, positions=_at("KeyV")),
    Binding(Action.TILT_DOWN, positions=_at("KeyC")),
    Binding(Action.ZOOM_IN, _written("PageUp"), buttons=(PadButton.RIGHTSTICK,)),
    Binding(Action.ZOOM_OUT, _written("PageDown"), buttons=(PadButton.LEFTSTICK,)),
)


class KeyTable:
    """What keys and buttons mean, built from bindings; another set of bindings gives another table."""

    def __init__(self, bindings: Iterable[Binding]) -> None:
        """bindings: those that hold from now on."""
        self.change(bindings)

    def change(self, bindings: Iterable[Binding]) -> None:
        """Let other bindings hold; of two that claim the same key, the later one has it."""
        self.bindings = tuple(bindings)
        self._by_position = {position: one.action for one in self.bindings for position in one.positions}
        self._by_code = {code: one.action for one in self.bindings for code in one.codes}
        self._by_button = {button: one.action for one in self.bindings for button in one.buttons}

    def action(self, position: int, code: int) -> Action | None:
        """What a key means; None for one that means nothing. position: 0 where the system does not know it.

        In this order: its position, what is written on it, and where that means nothing, what the US layout writes there.
        The last is how letters work on layouts without Latin letters, and digits where they need the shift key.
        """
        found = self._by_position.get(position) or self._by_code.get(code)
        return found or self._by_code.get(US_CODES.get(position, code))

    def button_action(self, button: int) -> Action | None:
        """What a gamepad's button means; None for one that means nothing."""
        return self._by_button.get(button)

    def binding(self, action: Action) -> Binding:
        """The keys of an action; KeyError for an action without one."""
        for one in self.bindings:
            if one.action is action:
                return one
        raise KeyError(action)


KEYS = KeyTable(BINDINGS)
"""The keys and buttons that hold now."""
