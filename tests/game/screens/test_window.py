"""The window itself: its size, its end, and what is remembered of it; on the dummy driver."""

import signal

import pygame
import pytest

from game.levels import built_in, classic
from game.loop import app, window_events
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.menu import Menu
from game.storage.storage import Storage
from game.system import ending
from tests.support.windows.dummy_window import FRAME, SIZE


def test_full_screen_and_back(playing):
    """F11 and Alt+Enter make the window as large as the desktop, and F11 gives it its size back."""
    desktop = pygame.display.get_desktop_sizes()[0]
    playing.press(pygame.K_F11)
    assert playing.window.size == desktop
    playing.press(pygame.K_F11)
    assert playing.window.size == SIZE
    playing.press(pygame.K_RETURN, mod=pygame.KMOD_ALT)
    assert playing.window.size == desktop
    assert isinstance(playing.screen, PlayScreen)


@pytest.mark.parametrize("size", [(1, 1), (3, 900), (900, 3), (3840, 2160), (800, 600)])
def test_any_window_size_in_play(desk, size):
    """Title, help, game and pause can be drawn and used in a window of any size."""
    desk.window.size = size
    desk.press(pygame.K_h, pygame.K_h, pygame.K_RETURN, pygame.K_SPACE)
    desk.wait(FRAME)
    desk.press(pygame.K_p)
    desk.window.size = SIZE
    desk.press(pygame.K_p)
    assert isinstance(desk.screen, PlayScreen)


def test_minimising_pauses(playing):
    """Minimising the window pauses the game, and nothing moves until it is back."""
    playing.post(pygame.WINDOWMINIMIZED)
    assert isinstance(playing.screen, Menu)
    assert playing.shared.away
    playing.post(pygame.WINDOWRESTORED)
    assert not playing.shared.away


@pytest.mark.parametrize("kind", [pygame.QUIT, pygame.WINDOWCLOSE])
def test_closing_the_window_leaves_from_anywhere(playing, kind):
    """Closing the window ends the app at once."""
    playing.post(kind)
    assert playing.screen is None


def test_play_returns_0_when_the_window_is_closed(monkeypatch):
    """`play` returns 0 when its window is closed after five frames."""
    frames = []

    def counted(*args):
        frames.append(args)
        if len(frames) == 5:
            pygame.event.post(pygame.Event(pygame.QUIT))
        return real(*args)

    real = app.frame
    monkeypatch.setattr(app, "frame", counted)
    assert app.play(classic()[2:], 1) == 0
    assert len(frames) == 5
    assert not pygame.display.get_init()


def test_size_and_position_of_the_window_are_remembered(monkeypatch, tmp_path):
    """The next session opens it as it was left, whatever size it had in full screen."""
    seen = []

    def looked(window, state, _screen, _seconds):
        seen.append((window.size, window.position))
        if len(seen) == 1:
            window.size, window.position = (500, 400), (60, 70)
        elif len(seen) == 2:
            app.toggle_full_screen(window, state)

    monkeypatch.setattr(app, "frame", looked)
    for _ in range(3):
        app.play(classic(), 1, app.Services(storage=Storage(tmp_path)))
    assert seen[1:] == [((500, 400), (60, 70))] * 2


def test_another_keyboard_layout_is_noticed(playing, monkeypatch):
    """The names of the keys are asked anew when the player switches to another layout."""
    noticed = []
    monkeypatch.setattr(window_events, "use_layout", noticed.append)
    playing.post(pygame.KEYMAPCHANGED)
    assert [codes[pygame.KSCAN_Q] for codes in noticed] == [pygame.K_q]


def test_a_signal_ends_the_loop_after_a_frame(monkeypatch, request):
    """The frame is done, the window is closed, and then the signal is heard: the command line makes a line of it."""
    seen = []

    def looked(_window, _kept, screen, _seconds):
        seen.append(screen)
        signal.raise_signal(signal.SIGTERM)
        return screen

    monkeypatch.setattr(app, "frame", looked)
    before = signal.signal(signal.SIGTERM, ending._handle)
    request.addfinalizer(lambda: signal.signal(signal.SIGTERM, before))
    with pytest.raises(KeyboardInterrupt):
        app.play(classic(), 1, autopilot=True)
    assert len(seen) == 1
    assert not pygame.display.get_init()


def test_a_level_of_ones_own_is_the_only_one_offered(monkeypatch):
    """A level that is not built in stands alone on the title."""
    own = (classic()[0].__class__(**{**{f: getattr(classic()[0], f) for f in classic()[0].__struct_fields__}, "name": "Mine"}),)
    seen = []

    def looked(_window, state, screen, _seconds):
        seen.append((state.catalogue, screen.__class__))

    monkeypatch.setattr(app, "frame", looked)
    app.play(own, 1)
    app.play(classic()[2:], 1)
    assert seen == [(own, Title), (built_in(), Title)]
