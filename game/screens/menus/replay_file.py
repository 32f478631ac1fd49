"""Opening the replay of a finished game."""

from game.language import tr
from game.replays.file import load
from game.replays.playback import Playback
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.watch import Watch
from game.system.errors import BadInputError


def opened_replay(state: AppState, under: Screen, name: str) -> Screen | str:
    """The screen of a finished game's replay, or a line why there is none. name: of the file; under: the screen below."""
    folder = state.storage.games.folder
    if folder is None:
        return tr("This game was not kept.")
    try:
        return Watch(state, Playback(load(folder / name)), lambda: under)
    except BadInputError as error:
        return str(error).removeprefix(f"{folder}/")
