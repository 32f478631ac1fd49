"""The app at its title, which keeps what it has to keep in a folder of the test."""

import pytest

from game.editor import command
from game.levels.own import own_levels
from game.rules import Ruleset
from game.screens.editors import OpenEditors
from game.screens.title import Title
from game.storage import games as kept_games
from game.storage.storage import Storage
from tests.support.windows.dummy_window import FRAME, Desk, shared
from tests.support.windows.pad_desk import PadDesk


@pytest.fixture
def state(tmp_path, monkeypatch):
    """What the app begins with, and a folder for what it keeps."""
    monkeypatch.setattr(kept_games, "_SHORTEST", 0.1)
    made = shared()
    made.storage, made.ruleset = Storage(tmp_path), Ruleset()
    made.recorder, made.open_editor = made.storage.games, OpenEditors().opened
    monkeypatch.setattr(command, "own_levels_folder", lambda: tmp_path / "levels")
    made.own_levels = lambda: own_levels(tmp_path / "levels")
    return made


@pytest.fixture
def desk(state):
    """The app at its title."""
    found = Desk(state, Title(state), (640, 400))
    found.wait(FRAME)
    yield found
    found.close()


@pytest.fixture
def pad_desk(state):
    """The app at its title, with a gamepad alone."""
    found = PadDesk(state, Title(state), (320, 200))
    yield found
    found.close()
