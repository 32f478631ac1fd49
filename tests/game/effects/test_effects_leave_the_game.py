"""Every effect on or off, held breath and camera moves included: the same game, to the last bit."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import random

import pygame
import pytest

from game.autopilot import Autopilot
from game.effects import ALL, EffectKind
from game.effects.hit_stop import SECONDS
from game.input.view import SOLID
from game.levels import classic
from game.replays.file import Recorder
from game.replays.state_hash import state_hash
from game.replays.verify import verified
from game.rules import EventKind, new_game, tick
from game.screens.play.screen import PlayScreen
from game.settings.values import Settings
from tests.support.windows.dummy_window import SIZE, shared

TICKS = 2600
LEVEL = 4


class TicksRecorder:
    """Records a game as the window does, up to TICKS."""

    def __init__(self):
        self.recorder = Recorder(classic()[LEVEL:], 7)
        self.last = None

    def __call__(self, controls, after):
        if self.recorder.ticks < TICKS:
            self.recorder.add(controls, after)
            self.last = after


def played(settings, view=None, seconds=1.0 / 60.0):
    """The recording of a game in its screen, drawn as it goes, and how many frames it took."""
    recorded = TicksRecorder()
    app = shared(LEVEL, 7, recorded, autopilot=True)
    app.change(settings)
    app.view = app.view if view is None else view
    screen, surface, frames = PlayScreen(app, classic()[LEVEL:]), pygame.Surface((96, 72), 0, 32), 0
    while recorded.recorder.ticks < TICKS:
        screen = screen.advance(seconds, SIZE)
        if frames % 10 == 0:
            screen.draw(surface)
        frames += 1
    return recorded.recorder.recording(), frames


@pytest.fixture(scope="module")
def bare():
    """The game played by the rules alone."""
    recorded, game, pilot = TicksRecorder(), new_game(classic()[LEVEL:], 7), Autopilot()
    for _ in range(TICKS):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        recorded(controls, game)
    return recorded.recorder.recording()


@pytest.mark.parametrize(
    "settings",
    [
        Settings(),
        Settings(effects=False),
        Settings(off=ALL),
        Settings(reduced_motion=True),
        *[Settings(off=ALL - {kind}) for kind in EffectKind],
    ],
    ids=["all", "none", "all off", "reduced motion", *EffectKind],
)
def test_a_recording_does_not_know_what_was_seen(bare, settings):
    """The recording is that of the rules alone, and Python's own generator is left alone."""
    chance = random.getstate()
    recording, _ = played(settings)
    assert recording == bare
    assert random.getstate() == chance


def test_tipped_and_at_another_frame_rate(bare):
    """A tipped camera and another frame rate change nothing in the recording, and it verifies."""
    for seconds in (1.0 / 144.0, 0.11):
        recording, _ = played(Settings(), SOLID, seconds)
        assert recording == bare
    assert verified(bare).divergence is None


def test_a_held_breath_takes_time_but_no_tick():
    """After a ball is lost no tick runs for the hit-stop's seconds; the ticks that follow are those of a game without it."""
    ends = {}
    for settings in (Settings(), Settings(off=frozenset({EffectKind.HIT_STOP}))):
        told = []
        app = shared(0, 1, lambda _controls, after, told=told: told.append(state_hash(after)))
        app.change(settings)
        screen = PlayScreen(app, classic())
        counts = []
        for _ in range(1500):
            screen._hands = screen._hands._replace(serve=len(told) > 50)
            before = screen._ticked.game.lives
            screen = screen.advance(1.0 / 240.0, SIZE)
            counts.append((len(told), screen._ticked.game.lives < before))
        ends[settings] = told, counts
    with_stop, without = (ends[settings] for settings in ends)
    common = min(len(with_stop[0]), len(without[0]))
    assert with_stop[0][:common] == without[0][:common]
    loss = next(k for k, (_, gone) in enumerate(with_stop[1]) if gone)
    stood = with_stop[1][loss][0]
    stop = round(240 * SECONDS[EventKind.BALL_LOST])
    assert stop >= 20
    assert with_stop[1][loss + stop - 2][0] == stood
    assert with_stop[1][loss + stop + 3][0] > stood
    assert without[1][loss + 4][0] > stood
