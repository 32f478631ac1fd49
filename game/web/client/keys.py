"""Keys and gamepads' buttons of a browser, in the numbers of the game's own tables; and which keys are left to the browser."""

from collections.abc import Mapping

from game.input.actions import Action, OwnKeys
from game.input.keys import Binding, PadButton
from game.input.rebinding import bindings, checked
from game.input.scancodes import SCANCODES, US_CODES, code_at, position_of

BROWSERS_KEYS = (
    "Tab",
    *[f"F{number}" for number in range(2, 13)],
    *[f"{name}{side}" for name in ("Control", "Alt", "Meta") for side in ("Left", "Right")],
)
"""Keys that stay the browser's: Tab moves between the page's controls."""
NOT_ON_PAGES = frozenset({Action.NORMALS})
"""Actions without a meaning on the page: no second engine is there while one plays."""
PAD_BUTTONS = (
    PadButton.A,
    PadButton.B,
    PadButton.X,
    PadButton.Y,
    PadButton.LEFTSHOULDER,
    PadButton.RIGHTSHOULDER,
    None,
    None,
    PadButton.BACK,
    PadButton.START,
    PadButton.LEFTSTICK,
    PadButton.RIGHTSTICK,
    PadButton.DPAD_UP,
    PadButton.DPAD_DOWN,
    PadButton.DPAD_LEFT,
    PadButton.DPAD_RIGHT,
    PadButton.GUIDE,
)
"""Of a gamepad in the browser's standard layout; two of them are triggers."""
_KEYPAD = "Numpad"
BROWSERS_POSITIONS = frozenset([SCANCODES[name] for name in BROWSERS_KEYS])
_BROWSERS_CODES = frozenset([code_at(position) for position in BROWSERS_POSITIONS])


def page_bindings(own: OwnKeys) -> tuple[Binding, ...]:
    """The desktop's bindings with the player's choices, without the keys that stay the browser's. own: of any content."""
    return tuple([_without_browsers_keys(one) for one in bindings(checked(own))])


def position_at(code: str, key: str) -> int:
    """The position of a key; 0 where it is not known. code, key: where it is and what is written on it, as browsers say it."""
    return SCANCODES.get(code) or SCANCODES.get(key) or (position_of(_character(key)) if len(key) == 1 else 0)


def code_of(code: str, key: str) -> int:
    """The code of a key: what is written on it. Arguments as of `position_at`."""
    if len(key) == 1 and not code.startswith(_KEYPAD):
        return _character(key)
    return code_at(position_at(code, key))


def layout_of(written: Mapping[str, str]) -> dict[int, int]:
    """What is written on the keys: as on the US layout where nothing else is known. written: characters by code."""
    known = {code: key for code, key in written.items() if code in SCANCODES and len(key) == 1}
    return {**US_CODES, **{SCANCODES[code]: _character(key) for code, key in known.items()}}


def _character(key: str) -> int:
    """The number of the character on a key, in lower case: the first where that is two characters, as of İ."""
    return ord(key.lower()[0])


def _without_browsers_keys(binding: Binding) -> Binding:
    """A binding without the keys that stay the browser's; without any if its action means nothing on the page."""
    if binding.action in NOT_ON_PAGES:
        return Binding(binding.action)
    return binding._replace(
        codes=tuple([code for code in binding.codes if code not in _BROWSERS_CODES]),
        positions=tuple([position for position in binding.positions if position not in BROWSERS_POSITIONS]),
    )
