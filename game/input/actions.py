"""What keys and buttons can mean, and which of them the player has chosen for it. Needs no pygame, as the settings' file."""

from enum import Enum, auto
from typing import NamedTuple


class Action(Enum):
    """What a key or a button means."""

    LEFT = auto()
    RIGHT = auto()
    UP = auto()
    DOWN = auto()
    SERVE = auto()
    CONFIRM = auto()
    PAUSE = auto()
    RESTART = auto()
    BACK = auto()
    HELP = auto()
    FULL_SCREEN = auto()
    MUTE = auto()
    THEME = auto()
    EFFECTS = auto()
    SETTINGS = auto()
    NORMALS = auto()
    STEP_BACK = auto()
    STEP = auto()
    LESS = auto()
    MORE = auto()
    START = auto()
    END = auto()
    TIP = auto()
    FLAT = auto()
    SOLID = auto()
    LAB = auto()
    GIVE_UP = auto()
    ORBIT_LEFT = auto()
    ORBIT_RIGHT = auto()
    TILT_UP = auto()
    TILT_DOWN = auto()
    ZOOM_IN = auto()
    ZOOM_OUT = auto()


Choice = tuple[Action, tuple[int, ...]]
"""An action and its keys, or its buttons; the usual one first."""


class OwnKeys(NamedTuple):
    """What the player has chosen, for the actions where it is not the default.

    keys: pygame.KSCAN_*, physical keys. buttons: pygame.CONTROLLER_BUTTON_*, of a gamepad. No key or button is in two choices.
    """

    keys: tuple[Choice, ...] = ()
    buttons: tuple[Choice, ...] = ()


DEFAULT_KEYS = OwnKeys()
