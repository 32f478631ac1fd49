"""What keys and buttons mean: one table from them to actions, read by the window, the help and the tests alike.

A key is known by two numbers. Its *position* (a scancode) says where it is on the keyboard, whatever the layout. Its *code*
says what the layout writes on it. Steering goes by position, so that the two keys lie beside each other on every layout;
commands go by what is written on the key, so that P pauses wherever P is. A key that the player has chosen goes by position
(game/input/rebinding.py).
"""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

import pygame

from game.input.actions import Action

__all__ = [
    "BINDINGS",
    "CONTROL_CODES",
    "KEYS",
    "NAMED_KEY",
    "US_CODES",
    "Action",
    "Binding",
    "KeyTable",
    "code_among",
    "position_in",
    "position_of",
]


class Binding(NamedTuple):
    """The keys and buttons of one action.

    codes: pygame.K_*, what is written on its keys; the first is the one that the help names.
    positions: pygame.KSCAN_*, keys that mean the action wherever they are found there, whatever is written on them.
    buttons: pygame.CONTROLLER_BUTTON_*, of a gamepad.
    """

    action: Action
    codes: tuple[int, ...] = ()
    positions: tuple[int, ...] = ()
    buttons: tuple[int, ...] = ()


BINDINGS = (
    Binding(Action.LEFT, positions=(pygame.KSCAN_LEFT, pygame.KSCAN_A), buttons=(pygame.CONTROLLER_BUTTON_DPAD_LEFT,)),
    Binding(Action.RIGHT, positions=(pygame.KSCAN_RIGHT, pygame.KSCAN_D), buttons=(pygame.CONTROLLER_BUTTON_DPAD_RIGHT,)),
    Binding(Action.UP, (pygame.K_UP, pygame.K_w), buttons=(pygame.CONTROLLER_BUTTON_DPAD_UP,)),
    Binding(Action.DOWN, (pygame.K_DOWN, pygame.K_s), buttons=(pygame.CONTROLLER_BUTTON_DPAD_DOWN,)),
    Binding(Action.SERVE, (pygame.K_SPACE,), buttons=(pygame.CONTROLLER_BUTTON_A,)),
    Binding(Action.CONFIRM, (pygame.K_RETURN, pygame.K_KP_ENTER)),
    Binding(Action.PAUSE, (pygame.K_p, pygame.K_PAUSE), buttons=(pygame.CONTROLLER_BUTTON_START,)),
    Binding(Action.RESTART, (pygame.K_r,)),
    Binding(Action.BACK, (pygame.K_ESCAPE,), buttons=(pygame.CONTROLLER_BUTTON_B,)),
    Binding(Action.HELP, (pygame.K_h, pygame.K_F1), buttons=(pygame.CONTROLLER_BUTTON_BACK,)),
    Binding(Action.FULL_SCREEN, (pygame.K_F11,)),
    Binding(Action.MUTE, (pygame.K_m,)),
    Binding(Action.THEME, (pygame.K_t,)),
    Binding(Action.EFFECTS, (pygame.K_e,)),
    Binding(Action.SETTINGS, (pygame.K_o,)),
    Binding(Action.NORMALS, (pygame.K_n,)),
    Binding(Action.LAB, (pygame.K_l,)),
    Binding(Action.GIVE_UP, (pygame.K_g,), buttons=(pygame.CONTROLLER_BUTTON_X,)),
    Binding(Action.STEP_BACK, (pygame.K_COMMA,), buttons=(pygame.CONTROLLER_BUTTON_LEFTSHOULDER,)),
    Binding(Action.STEP, (pygame.K_PERIOD,), buttons=(pygame.CONTROLLER_BUTTON_RIGHTSHOULDER,)),
    Binding(Action.LESS, (pygame.K_MINUS, pygame.K_KP_MINUS)),
    Binding(Action.MORE, (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS)),
    Binding(Action.START, (pygame.K_HOME,)),
    Binding(Action.END, (pygame.K_END,)),
    Binding(Action.TIP, (pygame.K_TAB,), buttons=(pygame.CONTROLLER_BUTTON_Y,)),
    Binding(Action.FLAT, (pygame.K_1, pygame.K_KP_1)),
    Binding(Action.SOLID, (pygame.K_2, pygame.K_KP_2)),
    Binding(Action.ORBIT_LEFT, positions=(pygame.KSCAN_Z,)),
    Binding(Action.ORBIT_RIGHT, positions=(pygame.KSCAN_X,)),
    Binding(Action.TILT_UP, positions=(pygame.KSCAN_V,)),
    Binding(Action.TILT_DOWN, positions=(pygame.KSCAN_C,)),
    Binding(Action.ZOOM_IN, (pygame.K_PAGEUP,), buttons=(pygame.CONTROLLER_BUTTON_RIGHTSTICK,)),
    Binding(Action.ZOOM_OUT, (pygame.K_PAGEDOWN,), buttons=(pygame.CONTROLLER_BUTTON_LEFTSTICK,)),
)

US_CODES: Mapping[int, int] = {
    **{pygame.KSCAN_A + number: pygame.K_a + number for number in range(26)},
    **{pygame.KSCAN_1 + number: pygame.K_1 + number for number in range(9)},
    pygame.KSCAN_0: pygame.K_0,
    pygame.KSCAN_COMMA: pygame.K_COMMA,
    pygame.KSCAN_PERIOD: pygame.K_PERIOD,
    pygame.KSCAN_MINUS: pygame.K_MINUS,
    pygame.KSCAN_EQUALS: pygame.K_EQUALS,
    pygame.KSCAN_LEFTBRACKET: pygame.K_LEFTBRACKET,
    pygame.KSCAN_RIGHTBRACKET: pygame.K_RIGHTBRACKET,
}
"""Position to code of the printing keys that are bound to anything, on the US layout."""

CONTROL_CODES: Mapping[int, int] = {
    pygame.KSCAN_RETURN: pygame.K_RETURN,
    pygame.KSCAN_ESCAPE: pygame.K_ESCAPE,
    pygame.KSCAN_BACKSPACE: pygame.K_BACKSPACE,
    pygame.KSCAN_TAB: pygame.K_TAB,
    pygame.KSCAN_SPACE: pygame.K_SPACE,
    pygame.KSCAN_DELETE: pygame.K_DELETE,
}
"""Position to code of the keys whose codes are below those of characters: the same on all layouts."""

NAMED_KEY = 1 << 30
"""Set in the code of a key without a character; the rest of such a code is the key's position."""


def position_of(code: int) -> int:
    """Where the US layout has a code; 0 where that is not known."""
    if code & NAMED_KEY:
        return code & ~NAMED_KEY
    return next((position for position, known in (*CONTROL_CODES.items(), *US_CODES.items()) if known == code), 0)


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


def code_among(event: pygame.Event, known: Iterable[int]) -> int:
    """The code of a key event, or what the US layout has at its position where the own one is not known."""
    code = int(event.key)
    return code if code in known else US_CODES.get(position_in(event), code)


def position_in(event: pygame.Event) -> int:
    """The position of a key event; 0 where it is not known. An event that was not made by SDL may have none."""
    return int(getattr(event, "scancode", 0)) or position_of(event.key)
