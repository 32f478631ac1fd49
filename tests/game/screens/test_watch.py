"""Watching a recorded game."""

import pygame
import pytest

from game.effects import NOTHING
from game.headless import autopilot_game
from game.lab.window.screen import Lab
from game.levels import classic
from game.loop import app
from game.replays.file import Recorder
from game.replays.playback import Playback
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play import buttons as play_buttons
from game.screens.watch import SPEEDS, Watch
from game.settings.values import Settings
from tests.support.windows.dummy_window import FRAME, SIZE, Desk, shared

TICKS = 2400


@pytest.fixture(scope="module")
def recording():
    """Ten seconds of the autopilot."""
    recorder = Recorder(classic()[3:], 4)
    autopilot_game(classic()[3:], 4, TICKS, recorder)
    return recorder.recording()


@pytest.fixture
def desk(recording):
    """A window that shows it."""
    state = shared(3)
    found = Desk(state, Watch(state, Playback(recording)))
    yield found
    found.close()


def shown(desk):
    """The moment on the screen, in ticks."""
    return desk.screen._at


def test_it_plays_in_real_time_and_stops_at_the_end(desk):
    """A second is 240 ticks; it stops after the last tick, and Space then plays from the beginning."""
    desk.wait(1.0)
    assert shown(desk) == pytest.approx(240.0, abs=1e-6)
    desk.wait(12.0)
    assert shown(desk) == TICKS
    assert not desk.screen._playing
    desk.press(pygame.K_SPACE)
    assert desk.screen._playing
    assert shown(desk) < 10.0


def test_it_stops_and_steps(desk):
    """Space stops it; full stop shows the next tick and comma the one before."""
    desk.wait(0.5)
    desk.press(pygame.K_SPACE)
    before = shown(desk)
    desk.wait(0.5)
    assert shown(desk) == before
    desk.press(pygame.K_PERIOD)
    assert shown(desk) == int(before) + 1
    desk.press(pygame.K_COMMA, pygame.K_COMMA)
    assert shown(desk) == int(before) - 1


def test_the_speed_can_be_chosen(desk):
    """The lowest speed is an eighth of the game's, the highest eight times the game's."""
    for _ in SPEEDS:
        desk.press(pygame.K_MINUS)
    desk.press(pygame.K_HOME)
    before = shown(desk)
    desk.wait(1.0)
    assert shown(desk) - before == pytest.approx(30.0, abs=1e-6)
    for _ in SPEEDS:
        desk.press(pygame.K_PLUS)
    desk.press(pygame.K_HOME)
    before = shown(desk)
    desk.wait(0.5)
    assert shown(desk) - before == pytest.approx(960.0, abs=1e-6)


def test_seeking_stays_within_the_recording(desk):
    """Arrows skip five seconds, Home and End go to the ends, and nothing goes beyond them."""
    desk.press(pygame.K_SPACE, pygame.K_RIGHT)
    assert shown(desk) == pytest.approx(1200.0, abs=5.0)
    desk.press(pygame.K_LEFT, pygame.K_LEFT)
    assert shown(desk) == 0.0
    desk.press(pygame.K_END, pygame.K_RIGHT, pygame.K_PERIOD)
    assert shown(desk) == TICKS
    desk.press(pygame.K_HOME, pygame.K_COMMA)
    assert shown(desk) == 0.0


def test_the_timeline_answers_to_the_mouse(desk):
    """A click or a drag on the bar shows that moment; elsewhere, or without a button held, it does nothing."""
    desk.press(pygame.K_SPACE)
    bar = desk.screen._timeline(SIZE)
    desk.click((bar.left + bar.width // 2, bar.centery))
    assert shown(desk) == pytest.approx(TICKS / 2, abs=TICKS / bar.width)
    desk.move((bar.left + bar.width // 4, bar.centery), held=True)
    desk.wait(FRAME)
    assert shown(desk) == pytest.approx(TICKS / 4, abs=TICKS / bar.width)
    before = shown(desk)
    desk.move((bar.right, bar.centery))
    desk.wait(FRAME)
    assert shown(desk) == before


def test_the_mouse_alone_plays_stops_and_leaves(desk):
    """A click on the arena stops and goes on, one on the speed takes the next one, and the cross leaves."""
    desk.click((SIZE[0] // 2, 60))
    assert not desk.screen._playing
    desk.click((SIZE[0] // 2, 60))
    assert desk.screen._playing
    desk.click((SIZE[0] - 20, desk.screen._timeline(SIZE).centery))
    assert SPEEDS[desk.screen._speed] == 2.0
    box = play_buttons.button_boxes(desk.screen._layout(SIZE), play_buttons.WATCHING)[0]
    desk.click(box.center)
    assert desk.screen is None


def test_a_moment_looks_the_same_however_one_gets_there(desk):
    """A tick that is played to and one that is sought have the same picture, trail and flashes included."""
    desk.wait(4.0)
    desk.press(pygame.K_SPACE)
    tick = int(shown(desk))
    desk.screen._seek(tick)
    desk.wait(FRAME)
    before = pygame.image.tobytes(desk.window.get_surface(), "RGB")
    desk.press(pygame.K_END, pygame.K_HOME)
    desk.screen._seek(tick)
    desk.wait(FRAME)
    assert pygame.image.tobytes(desk.window.get_surface(), "RGB") == before


def test_the_game_shown_is_the_recorded_one(desk, recording):
    """After seeking, the tick on the screen is the recording's."""
    playback = Playback(recording)
    for number in (0, 7, 1300, 241, TICKS - 1):
        desk.screen._seek(number)
        assert desk.screen._shown == playback.ticked(number)


def test_help_and_leaving(desk):
    """H opens the help and Space closes it; Esc leaves."""
    desk.press(pygame.K_h)
    assert not isinstance(desk.screen, Watch)
    desk.press(pygame.K_SPACE)
    assert isinstance(desk.screen, Watch)
    desk.press(pygame.K_ESCAPE)
    assert desk.screen is None


def test_the_lab_opens_over_a_recording_and_leads_back(desk):
    """L opens the lab, and Esc leads back to the same tick."""
    desk.shared.open_lab = app._lab_opener(None)
    watching = desk.screen
    desk.press(pygame.K_PERIOD, pygame.K_l)
    assert isinstance(desk.screen, Lab)
    shown = watching._shown
    desk.wait(0.3)
    desk.press(pygame.K_ESCAPE)
    assert desk.screen is watching
    assert watching._shown is shown


def test_watch_opens_and_closes(monkeypatch, recording):
    """`watch` returns 0 when its window is closed by the first event."""
    real = app.frame

    def closing(*args):
        pygame.event.post(pygame.Event(pygame.QUIT))
        return real(*args)

    monkeypatch.setattr(app, "frame", closing)
    assert app.watch(recording) == 0


def test_settings_open_over_a_recording_and_stop_it(desk):
    """O opens the settings and Esc closes them. There + changes the volume, and over the recording its speed."""
    desk.wait(0.5)
    volume = desk.shared.settings.volume
    desk.press(pygame.K_EQUALS)
    assert desk.shared.settings.volume == volume
    desk.press(pygame.K_o)
    assert isinstance(desk.screen, SettingsPanel)
    desk.press(pygame.K_EQUALS)
    assert desk.shared.settings.volume == volume + 10
    desk.press(pygame.K_ESCAPE)
    assert isinstance(desk.screen, Watch)
    assert not desk.screen._playing


def test_a_recording_is_shown_without_what_is_not_wanted(desk):
    """With effects off a recording shows the trail alone."""
    desk.shared.change(Settings(effects=False))
    for _ in range(20):
        desk.wait(0.3)
        assert desk.screen._effects._replace(trails=()) == NOTHING


def test_the_timeline_is_long_in_large_text_too(desk):
    """It has at least half of the width; a click on it seeks, and one on the words at the right changes the speed."""
    state = desk.shared
    state.change(state.settings._replace(text_size=200))
    desk.wait(FRAME)
    bar = desk.screen._timeline(SIZE)
    assert bar.width > SIZE[0] / 2
    desk.click((bar.left + bar.width * 3 // 4, bar.centery))
    assert shown(desk) == pytest.approx(0.75 * TICKS, abs=20)
    before = desk.screen._speed
    desk.click((SIZE[0] - 20, SIZE[1] - 10))
    assert desk.screen._speed == (before + 1) % len(SPEEDS)
