"""Seeking in a recording."""

import random

import pytest

from game.replays.file import played
from game.replays.playback import Playback
from tests.support.games.players import MousePlayer
from tests.support.games.recordings import TICKS, recorded


@pytest.fixture(scope="module")
def recording():
    """A recorded game."""
    return recorded(MousePlayer(9))[0]


def test_any_moment_is_the_one_of_straight_play(recording):
    """Seeking to and fro gives at every tick the game that playing from the start gives."""
    straight = [done.game for done in played(recording)]
    playback = Playback(recording)
    assert playback.ticks == TICKS
    chance = random.Random(1)
    for number in [TICKS, 0, 1, 239, 240, 241, 480, 479, *[int(chance.random() * TICKS) for _ in range(200)]]:
        game = playback.game(number)
        assert game.tick == number
        if number:
            assert game == straight[number - 1]


def test_stepping_gives_every_tick_with_its_events(recording):
    """Tick by tick, with jumps between, the same events and hits come out as in straight play."""
    straight = list(played(recording))
    playback = Playback(recording)
    for number in [*range(500), 100, 700, 3, *range(690, TICKS)]:
        assert playback.ticked(number) == straight[number]
