"""What keys and buttons of the lab mean: one table binds them, and the help reads it."""

from enum import Enum
from typing import NamedTuple

import pygame

from game.lab.kit.picture import Toggle


class Command(Enum):
    """What can be asked for without a number. The value is the button's text."""

    PLAY = "Play"
    FORWARD = "Step"
    BACK = "Back"
    RESTART = "Restart"
    SLOWER = "-"
    FASTER = "+"
    DEFAULTS = "Defaults"
    COPY = "Copy line"
    SAVE = "Save case"
    VIEW = "Whole view"
    THEME = "Colours"
    HELP = "Help"
    PREVIOUS = "<"
    NEXT = ">"
    LEAVE = "Leave"


class Key(NamedTuple):
    """Keys and what they do."""

    keys: tuple[int, ...]
    command: Command
    meaning: str


KEYS = (
    Key((pygame.K_SPACE,), Command.PLAY, "run or pause"),
    Key((pygame.K_PERIOD, pygame.K_RIGHT), Command.FORWARD, "one step forward"),
    Key((pygame.K_COMMA, pygame.K_LEFT), Command.BACK, "one step back"),
    Key((pygame.K_MINUS, pygame.K_KP_MINUS), Command.SLOWER, "slower"),
    Key((pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), Command.FASTER, "faster"),
    Key((pygame.K_r,), Command.RESTART, "restart; the settings stay"),
    Key((pygame.K_d,), Command.DEFAULTS, "the scene's defaults"),
    Key((pygame.K_LEFTBRACKET, pygame.K_PAGEUP), Command.PREVIOUS, "the scene before"),
    Key((pygame.K_RIGHTBRACKET, pygame.K_PAGEDOWN), Command.NEXT, "the scene after"),
    Key((pygame.K_HOME,), Command.VIEW, "the whole view again"),
    Key((pygame.K_c,), Command.COPY, "copy the share line"),
    Key((pygame.K_s,), Command.SAVE, "save as a case that pytest runs"),
    Key((pygame.K_t,), Command.THEME, "dark or light colours"),
    Key((pygame.K_h, pygame.K_F1), Command.HELP, "this help"),
    Key((pygame.K_ESCAPE,), Command.LEAVE, "leave the lab"),
)

TOGGLE_KEYS = {pygame.K_1 + number: toggle for number, toggle in enumerate(Toggle)}

BOUND = frozenset([*TOGGLE_KEYS, *[key for one in KEYS for key in one.keys]])
"""The codes of all keys that mean something."""

MOUSE_HELP = (
    ("Drag a ring", "move what it is on"),
    ("Drag elsewhere", "move the view"),
    ("Wheel", "zoom about the pointer"),
    ("1 to 7", "show or hide what is listed at the right"),
)


def command_of(key: int) -> Command | None:
    """What a key asks for."""
    return next((one.command for one in KEYS if key in one.keys), None)
