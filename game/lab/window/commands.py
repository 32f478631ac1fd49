"""What keys and buttons of the lab ask for: one table binds them, and the help reads it."""

from enum import Enum
from typing import NamedTuple

import pygame

from game.lab.kit.picture import Toggle


class Command(Enum):
    """What can be asked for by a key alone. The value is the button's text."""

    PLAY = "Play"
    FORWARD = "Step"
    BACK = "Back"
    RESTART = "Restart"
    SLOWER = "-"
    FASTER = "+"
    DEFAULTS = "Defaults"
    COPY = "Copy line"
    SAVE = "Save case"
    WHOLE = "Whole scene"
    THEME = "Colours"
    HELP = "Help"
    PREVIOUS = "<"
    NEXT = ">"
    LEAVE = "Leave"


class KeyBinding(NamedTuple):
    """Keys that ask for the same command.

    keys: pygame's codes. written: how the help names them. meaning: what the command does, in a few words.
    """

    keys: tuple[int, ...]
    written: str
    command: Command
    meaning: str


KEYS = (
    KeyBinding((pygame.K_SPACE,), "Space", Command.PLAY, "run or pause"),
    KeyBinding((pygame.K_PERIOD, pygame.K_RIGHT), ".  Right", Command.FORWARD, "one step forward"),
    KeyBinding((pygame.K_COMMA, pygame.K_LEFT), ",  Left", Command.BACK, "one step back"),
    KeyBinding((pygame.K_MINUS, pygame.K_KP_MINUS), "-", Command.SLOWER, "slower"),
    KeyBinding((pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), "+", Command.FASTER, "faster"),
    KeyBinding((pygame.K_r,), "R", Command.RESTART, "restart; the settings stay"),
    KeyBinding((pygame.K_d,), "D", Command.DEFAULTS, "the scene's defaults"),
    KeyBinding((pygame.K_LEFTBRACKET, pygame.K_PAGEUP), "[", Command.PREVIOUS, "the scene before"),
    KeyBinding((pygame.K_RIGHTBRACKET, pygame.K_PAGEDOWN), "]", Command.NEXT, "the scene after"),
    KeyBinding((pygame.K_HOME,), "Home", Command.WHOLE, "show the whole scene again"),
    KeyBinding((pygame.K_c,), "C", Command.COPY, "copy the share line"),
    KeyBinding((pygame.K_s,), "S", Command.SAVE, "save as a case that pytest runs"),
    KeyBinding((pygame.K_t,), "T", Command.THEME, "dark or light colours"),
    KeyBinding((pygame.K_h, pygame.K_F1), "H  F1", Command.HELP, "this help"),
    KeyBinding((pygame.K_ESCAPE,), "Esc", Command.LEAVE, "leave the lab"),
)

TOGGLE_KEYS = {pygame.K_1 + number: toggle for number, toggle in enumerate(Toggle)}

MORE_HELP = (
    ("Drag a ring", "move what it stands on"),
    ("Drag elsewhere", "move the world"),
    ("Wheel", "zoom about the pointer"),
    ("1 to 7", "show or hide what is listed at the right"),
    ("F11", "full screen"),
)


def command_of(key: int) -> Command | None:
    """What a key, by pygame's code, asks for; None for nothing."""
    return next((one.command for one in KEYS if key in one.keys), None)
