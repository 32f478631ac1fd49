"""The app on the dummy driver, at its title and in a game."""

import pygame
import pytest

from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from tests.support.windows.dummy_window import FRAME, Desk, shared


@pytest.fixture
def ticks():
    """What the recorder was told."""
    return []


@pytest.fixture
def desk(ticks):
    """The app at its title."""
    state = shared(recorder=lambda controls, after: ticks.append((controls, after)))
    found = Desk(state, Title(state))
    found.wait(FRAME)
    yield found
    found.close()


@pytest.fixture
def playing(desk):
    """The app in a game before its first serve."""
    desk.press(pygame.K_RETURN)
    assert isinstance(desk.screen, PlayScreen)
    return desk
