"""What the keys are called on the player's own keyboard layout, and the help that is written with these names."""

from collections.abc import Iterable, Mapping
from functools import cache

import pygame

from game.input.keys import CONTROL_CODES, KEYS, NAMED_KEY, US_CODES, Action, position_of
from game.language import tr, tr_noop

_CHARACTERS = range(ord("!"), 0x600)
"""Codes of keys with a character: Latin, Greek, Cyrillic, Armenian, Hebrew."""
_WORDS = {
    "return": tr_noop("Enter"),
    "enter": tr_noop("Keypad Enter"),
    "escape": tr_noop("Esc"),
    "space": tr_noop("Space"),
    "tab": tr_noop("Tab"),
    "backspace": tr_noop("Backspace"),
    "delete": tr_noop("Del"),
    "insert": tr_noop("Ins"),
    "left": tr_noop("Left"),
    "right": tr_noop("Right"),
    "up": tr_noop("Up"),
    "down": tr_noop("Down"),
    "home": tr_noop("Home"),
    "end": tr_noop("End"),
    "page up": tr_noop("Page up"),
    "page down": tr_noop("Page down"),
    "break": tr_noop("Pause"),
    "left shift": tr_noop("Left Shift"),
    "right shift": tr_noop("Right Shift"),
    "left ctrl": tr_noop("Left Ctrl"),
    "right ctrl": tr_noop("Right Ctrl"),
    "left alt": tr_noop("Left Alt"),
    "right alt": tr_noop("Right Alt"),
    "caps lock": tr_noop("Caps Lock"),
}
"""What keys without a character are called, where the system's name is not it."""
_BUTTONS = {
    pygame.CONTROLLER_BUTTON_A: tr_noop("A"),
    pygame.CONTROLLER_BUTTON_B: tr_noop("B"),
    pygame.CONTROLLER_BUTTON_X: tr_noop("X"),
    pygame.CONTROLLER_BUTTON_Y: tr_noop("Y"),
    pygame.CONTROLLER_BUTTON_BACK: tr_noop("View"),
    pygame.CONTROLLER_BUTTON_START: tr_noop("Menu"),
    pygame.CONTROLLER_BUTTON_LEFTSHOULDER: tr_noop("LB"),
    pygame.CONTROLLER_BUTTON_RIGHTSHOULDER: tr_noop("RB"),
    pygame.CONTROLLER_BUTTON_LEFTSTICK: tr_noop("L3"),
    pygame.CONTROLLER_BUTTON_RIGHTSTICK: tr_noop("R3"),
    pygame.CONTROLLER_BUTTON_DPAD_LEFT: tr_noop("D-pad left"),
    pygame.CONTROLLER_BUTTON_DPAD_RIGHT: tr_noop("D-pad right"),
    pygame.CONTROLLER_BUTTON_DPAD_UP: tr_noop("D-pad up"),
    pygame.CONTROLLER_BUTTON_DPAD_DOWN: tr_noop("D-pad down"),
}
"""What a gamepad's buttons are called."""
NO_KEY = "–"
"""Stands for the key of an action that has none."""


def positions_in_use(action: Action) -> tuple[int, ...]:
    """An action's keys on the present layout, positions; the usual one first."""
    binding = KEYS.binding(action)
    written = [position for code in binding.codes for position in (*_positions_with(code), position_of(code))]
    candidates = dict.fromkeys([*binding.positions, *written])
    return tuple([one for one in candidates if one and KEYS.action(one, _code_at(one)) is action])


def second_player_positions() -> tuple[int, ...]:
    """The keys of the second player, where two play: to the left and to the right the second that the action has, and on."""
    return tuple([position for action in (Action.LEFT, Action.RIGHT) for position in positions_in_use(action)[1:]])


def players_keys() -> tuple[str, str]:
    """The names of the keys of the first and of the second player, where two play."""
    first = [key_name(action) for action in (Action.LEFT, Action.RIGHT)]
    second = [position_name(position) for position in second_player_positions()]
    return ", ".join(first), ", ".join(second) or NO_KEY


def key_names(action: Action) -> tuple[str, ...]:
    """The names of an action's keys as this layout writes them, the usual one first; the keypad's only where all are its."""
    names = [position_name(position) for position in positions_in_use(action)]
    return _without_keypad(names) or tuple(names) or (NO_KEY,)


def position_name(position: int) -> str:
    """What the layout calls the key at a position."""
    return _said(_code_at(position)) or tr("Key {number}").format(number=position)


def button_name(button: int) -> str:
    """What a gamepad's button is called."""
    return tr(_BUTTONS[button]) if button in _BUTTONS else tr("Button {number}").format(number=button)


def button_names(*actions: Action) -> str:
    """The gamepad's usual buttons for some actions, in one cell of a help."""
    buttons = [KEYS.binding(action).buttons[:1] for action in actions]
    return "   ".join([button_name(button) for own in buttons for button in own]) or NO_KEY


def code_names(codes: Iterable[int]) -> tuple[str, ...]:
    """The names of the keys that mean some codes, as this layout writes them; none for a key it has not, nor the keypad's."""
    known = [code for code in codes if _is_written(code) or position_of(code)]
    return _without_keypad([_name_of(code) for code in known])


def key_name(action: Action) -> str:
    """The name of an action's usual key as this layout writes it."""
    return key_names(action)[0]


def layout_changed() -> None:
    """Forget the layout: the player has switched to another."""
    _present_codes.cache_clear()


def play_help() -> tuple[tuple[str, str], ...]:
    """Pairs of keys and what they do in a game."""
    left, right = key_names(Action.LEFT), key_names(Action.RIGHT)
    return (
        (f"{left[0]}, {right[0]}   {left[-1]} {right[-1]}", tr("turn the paddles")),
        (tr("Mouse"), tr("the nearest paddle follows")),
        (f"{key_name(Action.SERVE)}   {tr('Click')}", tr("serve along the arrow; go on")),
        (_all(Action.PAUSE, Action.BACK), tr("pause; its menu leads out")),
        (_all(Action.RESTART), tr("restart (asks first)")),
        (_all(Action.GIVE_UP), tr("give up a ball that no paddle reaches")),
        (_all(Action.TIP, Action.FLAT, Action.SOLID), tr("tip the camera; from above; in 3D")),
        *_camera_help(),
        (_all(Action.FULL_SCREEN), tr("full screen")),
        (_all(Action.MUTE, Action.LESS, Action.MORE), tr("sound off / on; quieter; louder")),
        (_all(Action.THEME, Action.EFFECTS), tr("next colours; effects off / on")),
        (_all(Action.SETTINGS), tr("settings: every effect, reduced motion")),
        (_all(Action.NORMALS), tr("normals: ours thick, pymunk's thin")),
        (_all(Action.LAB), tr("the lab: try out the collision detection")),
        ("   ".join(key_names(Action.HELP)), tr("this help")),
    )


def watch_help() -> tuple[tuple[str, str], ...]:
    """Pairs of keys and what they do while a recorded game is watched."""
    others = _all(Action.FULL_SCREEN, Action.MUTE, Action.THEME, Action.EFFECTS, Action.SETTINGS)
    return (
        (_all(Action.SERVE, Action.PAUSE), tr("play / stop")),
        (_all(Action.STEP, Action.STEP_BACK), tr("one tick forward / back")),
        (_all(Action.LEFT, Action.RIGHT), tr("5 seconds back / forward")),
        (_all(Action.MORE, Action.LESS), tr("faster / slower, 1/8 to 8 times")),
        (_all(Action.START, Action.END), tr("to the beginning / the end")),
        (tr("Mouse"), tr("click or drag on the timeline")),
        (_all(Action.TIP, Action.FLAT, Action.SOLID), tr("tip the camera; from above; in 3D")),
        *_camera_help(),
        (others, tr("full screen, sound, colours, effects, settings")),
        (_all(Action.NORMALS), tr("normals: ours thick, pymunk's thin")),
        (_all(Action.LAB), tr("the lab: try out the collision detection")),
        (_all(Action.BACK), tr("leave")),
        ("   ".join(key_names(Action.HELP)), tr("this help")),
    )


def _camera_help() -> tuple[tuple[str, str], ...]:
    """Pairs of keys and what they do to the camera in 3D."""
    zoom = button_names(Action.ZOOM_IN, Action.ZOOM_OUT)
    return (
        (_all(Action.ORBIT_LEFT, Action.ORBIT_RIGHT, Action.TILT_UP, Action.TILT_DOWN), tr("in 3D: orbit and tilt")),
        (_all(Action.ZOOM_IN, Action.ZOOM_OUT), tr("in 3D: zoom")),
        (tr("Right drag   Wheel"), tr("in 3D: orbit and tilt; zoom; so do two fingers")),
        (f"{tr('Right stick')}   {zoom}", tr("the same by gamepad; while a ball waits, the stick aims")),
    )


def _without_keypad(names: Iterable[str]) -> tuple[str, ...]:
    """The names, each once, but for those of the keypad: they are in brackets."""
    keypad = tr(_WORDS["enter"])
    return tuple(dict.fromkeys([name for name in names if len(name) == 1 or not (name.startswith("[") or name == keypad)]))


def _all(*actions: Action) -> str:
    """The usual keys of some actions, in one cell of the help."""
    return "   ".join([key_name(action) for action in actions])


def _code_at(position: int) -> int:
    """The code of the key at a position."""
    return CONTROL_CODES.get(position) or _codes_by_position().get(position, position | NAMED_KEY)


def _positions_with(code: int) -> list[int]:
    """Where the present layout has a code."""
    return [position for keys in (CONTROL_CODES, _codes_by_position()) for position, known in keys.items() if known == code]


def _name_of(code: int) -> str:
    """What the layout calls the key that means a code: the code itself, or what is written where the US layout has it."""
    return _said(code) if _is_written(code) else position_name(position_of(code))


def _is_written(code: int) -> bool:
    """Whether the layout writes a code on a key of its own."""
    return bool(code & NAMED_KEY) or code < _CHARACTERS.start or code in _codes_by_position().values()


def _said(code: int) -> str:
    """The name of a code, as keys are labelled; empty for a key without a name."""
    if code in _CHARACTERS:
        return chr(code).upper()
    name = pygame.key.name(code)
    return tr(_WORDS[name]) if name in _WORDS else name.capitalize()


def _codes_by_position() -> Mapping[int, int]:
    """Code of every printing key of the present layout; of the US layout before there is a display."""
    return _present_codes() if pygame.display.get_init() else US_CODES


@cache
def _present_codes() -> Mapping[int, int]:
    """The same, asked of the system.

    The library gives positions for codes only: a table of key states takes a code for an index and looks at its position.
    """
    positions = pygame.key.ScancodeWrapper(range(len(pygame.key.get_pressed())))  # type: ignore[arg-type]
    found = {int(positions[code]): code for code in reversed(_CHARACTERS)}
    found.pop(0, None)
    return found
