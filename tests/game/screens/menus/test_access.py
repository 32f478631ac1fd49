"""The game fits its player: slower, and a score says so."""

import pygame
import pytest

from game.rules import TICK
from game.screens.play.screen import PlayScreen
from game.settings.values import Settings
from tests.support.windows.dummy_window import shared

SIZE = (320, 200)


@pytest.fixture
def play():
    """A game before its first serve."""
    pygame.display.init()
    state = shared()
    yield PlayScreen(state, state.catalogue)
    pygame.quit()


def ticks_of(play, seconds):
    """Ticks of the game that some frames take."""
    before = play._ticked.game.tick
    for _ in range(round(seconds * 60)):
        play.advance(1.0 / 60.0, SIZE)
    return play._ticked.game.tick - before


def test_a_slower_game_runs_fewer_of_the_same_ticks(play):
    """Half as many at 50 %; the least speed is remembered for the score, whatever it is later."""
    usual = ticks_of(play, 0.5)
    assert usual == pytest.approx(0.5 / TICK, abs=2)
    play._state.change(Settings(speed=50))
    assert ticks_of(play, 0.5) == pytest.approx(usual / 2, abs=2)
    play._state.change(Settings())
    ticks_of(play, 0.1)
    assert play._record.speed == 50
