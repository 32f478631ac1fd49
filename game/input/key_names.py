"""What the keys are called on the player's own keyboard layout, and the help that is written with these names.

The window asks the system for the layout, the page the browser; until then it is the US layout.
"""

from collections.abc import Iterable, Mapping

from game.input.keys import KEYS, Action, PadButton
from game.input.scancodes import CONTROL_CODES, NAMED_KEY, SCANCODES, US_CODES, code_at, position_of
from game.language import tr, tr_noop

CHARACTERS = range(ord("!"), 0x600)
"""Codes of keys with a character: Latin, Greek, Cyrillic, Armenian, Hebrew."""
_WORDS = {
    "Enter": tr_noop("Enter"),
    "NumpadEnter": tr_noop("Keypad Enter"),
    "Escape": tr_noop("Esc"),
    "Space": tr_noop("Space"),
    "Tab": tr_noop("Tab"),
    "Backspace": tr_noop("Backspace"),
    "Delete": tr_noop("Del"),
    "Insert": tr_noop("Ins"),
    "ArrowLeft": tr_noop("Left"),
    "ArrowRight": tr_noop("Right"),
    "ArrowUp": tr_noop("Up"),
    "ArrowDown": tr_noop("Down"),
    "Home": tr_noop("Home"),
    "End": tr_noop("End"),
    "PageUp": tr_noop("Page up"),
    "PageDown": tr_noop("Page down"),
    "Pause": tr_noop("Pause"),
    "ShiftLeft": tr_noop("Left Shift"),
    "ShiftRight": tr_noop("Right Shift"),
    "ControlLeft": tr_noop("Left Ctrl"),
    "ControlRight": tr_noop("Right Ctrl"),
    "AltLeft": tr_noop("Left Alt"),
    "AltRight": tr_noop("Right Alt"),
    "CapsLock": tr_noop("Caps Lock"),
}
"""What keys without a character are called, where it is not what browsers call them."""
_KEYPAD = {"Decimal": ".", "Divide": "/", "Multiply": "*", "Subtract": "-", "Add": "+"}
"""What is written on keys of the keypad that have no digit."""
_NAMES = {position: name for name, position in SCANCODES.items()}
_BUTTONS: Mapping[int, str] = {
    PadButton.A: tr_noop("A"),
    PadButton.B: tr_noop("B"),
    PadButton.X: tr_noop("X"),
    PadButton.Y: tr_noop("Y"),
    PadButton.BACK: tr_noop("View"),
    PadButton.START: tr_noop("Menu"),
    PadButton.LEFTSHOULDER: tr_noop("LB"),
    PadButton.RIGHTSHOULDER: tr_noop("RB"),
    PadButton.LEFTSTICK: tr_noop("L3"),
    PadButton.RIGHTSTICK: tr_noop("R3"),
    PadButton.DPAD_LEFT: tr_noop("D-pad left"),
    PadButton.DPAD_RIGHT: tr_noop("D-pad right"),
    PadButton.DPAD_UP: tr_noop("D-pad up"),
    PadButton.DPAD_DOWN: tr_noop("D-pad down"),
}
"""What a gamepad's buttons are called."""
NO_KEY = "–"
"""Stands for the key of an action that has none."""
_layout = dict(US_CODES)
"""Position to code of the keys with a character, on the present layout."""


def positions_in_use(action: Action) -> tuple[int, ...]:
    """An action's keys on the present layout, positions; the usual one first."""
    binding = KEYS.binding(action)
    written = [position for code in binding.codes for position in (*_positions_with(code), position_of(code))]
    candidates = dict.fromkeys([*binding.positions, *written])
    return tuple([one for one in candidates if one and KEYS.action(one, code_at(one, _layout)) is action])


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
    return _label(code_at(position, _layout)) or tr("Key {number}").format(number=position)


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


def use_layout(codes: Mapping[int, int]) -> None:
    """Let a layout hold. codes: what it writes on its keys, by position."""
    _layout.clear()
    _layout.update(codes)


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
    keypad = tr(_WORDS["NumpadEnter"])
    return tuple(dict.fromkeys([name for name in names if len(name) == 1 or not (name.startswith("[") or name == keypad)]))


def _all(*actions: Action) -> str:
    """The usual keys of some actions, in one cell of the help."""
    return "   ".join([key_name(action) for action in actions])


def _positions_with(code: int) -> list[int]:
    """Where the present layout has a code."""
    return [position for keys in (CONTROL_CODES, _layout) for position, known in keys.items() if known == code]


def _name_of(code: int) -> str:
    """What the layout calls the key that means a code: the code itself, or what is written where the US layout has it."""
    return _label(code) if _is_written(code) else position_name(position_of(code))


def _is_written(code: int) -> bool:
    """Whether the layout writes a code on a key of its own."""
    return bool(code & NAMED_KEY) or code < CHARACTERS.start or code in _layout.values()


def _label(code: int) -> str:
    """The name of a code, as keys are labelled; empty for a key without a name."""
    if not code & NAMED_KEY and code >= CHARACTERS.start and chr(code).isprintable():
        return chr(code).upper()
    name = _NAMES.get(position_of(code), "")
    if name in _WORDS:
        return tr(_WORDS[name])
    written = name.removeprefix("Numpad")
    return name if written == name else f"[{_KEYPAD.get(written, written)}]"
