"""The lab's help: what the mouse does, and what the keys do."""

from game.input.key_names import code_names
from game.lab.window.commands import KEYS, MORE_HELP
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.key_help import HelpWords, KeyHelp


def lab_help(state: AppState, under: Screen) -> KeyHelp:
    """The help panel over the lab."""
    lines = (*MORE_HELP, *[("  ".join(code_names(key.keys)), key.meaning) for key in KEYS])
    return KeyHelp(state, under, HelpWords("The lab", "Back"), (("", lines),))
