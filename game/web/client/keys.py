"""What a browser's keys and a gamepad's buttons mean: the desktop's table in the browser's names.

`tests/web/test_client.py` holds it to `game.input.keys`. Tab stays the browser's: it moves between the page's controls.
"""

from game.input.actions import Action

BY_CODE = {
    "ArrowLeft": Action.LEFT,
    "KeyA": Action.LEFT,
    "ArrowRight": Action.RIGHT,
    "KeyD": Action.RIGHT,
    "KeyZ": Action.ORBIT_LEFT,
    "KeyX": Action.ORBIT_RIGHT,
    "KeyV": Action.TILT_UP,
    "KeyC": Action.TILT_DOWN,
}
"""Keys that mean something wherever they are, by where they are."""
BY_KEY = {
    "ArrowUp": Action.UP,
    "w": Action.UP,
    "ArrowDown": Action.DOWN,
    "s": Action.DOWN,
    " ": Action.SERVE,
    "Enter": Action.CONFIRM,
    "p": Action.PAUSE,
    "Pause": Action.PAUSE,
    "r": Action.RESTART,
    "Escape": Action.BACK,
    "h": Action.HELP,
    "F1": Action.HELP,
    "m": Action.MUTE,
    "t": Action.THEME,
    "e": Action.EFFECTS,
    "o": Action.SETTINGS,
    "l": Action.LAB,
    "g": Action.GIVE_UP,
    ",": Action.STEP_BACK,
    ".": Action.STEP,
    "-": Action.LESS,
    "+": Action.MORE,
    "=": Action.MORE,
    "Home": Action.START,
    "End": Action.END,
    "1": Action.FLAT,
    "2": Action.SOLID,
    "PageUp": Action.ZOOM_IN,
    "PageDown": Action.ZOOM_OUT,
}
"""Keys that mean something by what is written on them."""
SECOND_PLAYER = ("KeyA", "KeyD")
"""The second player's keys if two play; the first player has the other keys of the same actions."""
PLAYERS_KEYS = ("←, →", "A, D")
"""Names of both players' keys."""
BUTTONS = (
    Action.SERVE,
    Action.BACK,
    Action.GIVE_UP,
    Action.TIP,
    Action.STEP_BACK,
    Action.STEP,
    None,
    None,
    Action.HELP,
    Action.PAUSE,
    None,
    None,
    Action.UP,
    Action.DOWN,
    Action.LEFT,
    Action.RIGHT,
)
"""Of a gamepad in the standard layout."""
_POSITIONS: dict[str, int] = {}


def key_action(code: str, key: str) -> Action | None:
    """What a key means; None for one that means nothing."""
    return BY_CODE.get(code) or BY_KEY.get(key if len(key) > 1 else key.lower())


def key_position(code: str) -> int:
    """A number for a key, the same for the same key, from 1 on."""
    return _POSITIONS.setdefault(code, len(_POSITIONS) + 1)


def second_player_positions() -> tuple[int, ...]:
    """The numbers of the second player's keys."""
    return tuple([key_position(code) for code in SECOND_PLAYER])
