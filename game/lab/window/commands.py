"""What keys and buttons of the lab ask for: one table binds them, and the help reads it."""

from typing import NamedTuple

import pygame

from game.input.actions import Action
from game.lab.kit.picture import Toggle
from game.lab.session.commands import Command


class KeyBinding(NamedTuple):
    """Keys that ask for the same command.

    keys: pygame's codes. meaning: what the command does, in a few words.
    """

    keys: tuple[int, ...]
    command: Command
    meaning: str


KEYS = (
    KeyBinding((pygame.K_SPACE,), Command.PLAY, "next step; where all is shown, run or pause"),
    KeyBinding((pygame.K_BACKSPACE,), Command.UNDO_STEP, "hide the last step"),
    KeyBinding((pygame.K_v,), Command.REVEAL, "the first step alone, or all steps"),
    KeyBinding((pygame.K_g,), Command.PREDICT, "predict each step: drag the answer, then see it"),
    KeyBinding((pygame.K_e,), Command.COURSE, "the course: questions and exercises by the slides"),
    KeyBinding((pygame.K_PAGEDOWN,), Command.PAGE_DOWN, "next step, then next scene (a presenter's key)"),
    KeyBinding((pygame.K_PAGEUP,), Command.PAGE_UP, "the step or scene before (a presenter's key)"),
    KeyBinding((pygame.K_PERIOD, pygame.K_RIGHT), Command.FORWARD, "one step forward"),
    KeyBinding((pygame.K_COMMA, pygame.K_LEFT), Command.BACK, "one step back"),
    KeyBinding((pygame.K_MINUS, pygame.K_KP_MINUS), Command.SLOWER, "slower"),
    KeyBinding((pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), Command.FASTER, "faster"),
    KeyBinding((pygame.K_r,), Command.RESTART, "restart; the settings stay"),
    KeyBinding((pygame.K_d,), Command.DEFAULTS, "the scene's defaults"),
    KeyBinding((pygame.K_LEFTBRACKET,), Command.PREVIOUS, "the scene before; the task before, in the course"),
    KeyBinding((pygame.K_RIGHTBRACKET,), Command.NEXT, "the scene after; the task after, in the course"),
    KeyBinding((pygame.K_TAB,), Command.CONTROLS, "the next control, for arrows and Enter"),
    KeyBinding((pygame.K_w,), Command.SAVE_LEVEL, "save an arena of your own as a level"),
    KeyBinding((pygame.K_HOME,), Command.WHOLE, "show the whole scene again"),
    KeyBinding((pygame.K_c,), Command.COPY, "copy the share line"),
    KeyBinding((pygame.K_s,), Command.SAVE, "save as a case that pytest runs"),
    KeyBinding((pygame.K_t,), Command.THEME, "dark, light or high-contrast colours"),
    KeyBinding((pygame.K_p,), Command.PRESENT, "for a lecture room: large text, no sliders"),
    KeyBinding((pygame.K_UP,), Command.LARGER, "larger text, in a lecture room"),
    KeyBinding((pygame.K_DOWN,), Command.SMALLER, "smaller text, in a lecture room"),
    KeyBinding((pygame.K_F5,), Command.SAVE_PNG, "save as PNG, at the size of a slide"),
    KeyBinding((pygame.K_F6,), Command.SAVE_SVG, "save as SVG"),
    KeyBinding((pygame.K_F7,), Command.SAVE_GIF, "save as GIF: its steps, or its run"),
    KeyBinding((pygame.K_h, pygame.K_F1), Command.HELP, "this help"),
    KeyBinding((pygame.K_ESCAPE,), Command.LEAVE, "leave the lab"),
)

PAD_COMMANDS = {
    Action.SERVE: Command.PLAY,
    Action.CONFIRM: Command.PLAY,
    Action.GIVE_UP: Command.UNDO_STEP,
    Action.LEFT: Command.BACK,
    Action.RIGHT: Command.FORWARD,
    Action.UP: Command.LARGER,
    Action.DOWN: Command.SMALLER,
    Action.STEP_BACK: Command.PREVIOUS,
    Action.STEP: Command.NEXT,
    Action.HELP: Command.HELP,
    Action.BACK: Command.LEAVE,
    Action.PAUSE: Command.LEAVE,
}
"""What a gamepad's buttons ask for, unless the controls have its cross."""

TOGGLE_KEYS = {pygame.K_1 + number: toggle for number, toggle in enumerate(Toggle)}

BOUND = frozenset([*TOGGLE_KEYS, *[key for one in KEYS for key in one.keys]])
"""The codes of all keys that mean something."""

MORE_HELP = (
    ("Drag a handle", "move what the small ring marks"),
    ("Drag elsewhere", "move the picture"),
    ("Wheel", "zoom about the pointer"),
    ("1 to 7", "show or hide what is listed at the right"),
    ("1 to 3", "answer the question of the course"),
    ("F11", "full screen"),
    ("Gamepad", "A next step, Y next control, B back"),
)


def command_of(key: int) -> Command | None:
    """What a key, by pygame's code, asks for; None for nothing."""
    return next((one.command for one in KEYS if key in one.keys), None)
