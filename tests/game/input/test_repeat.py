"""Held keys: what repeats, what does not, and what happens to a release that is lost."""

import pygame
import pytest

from game.input.repeat import FIRST, NEXT, Repeat
from game.input.signals import KeyboardState
from game.lab.registry import scenes
from game.lab.window.screen import Lab
from game.loop import app
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from tests.support.windows.dummy_window import FRAME, Desk, shared
from tests.support.windows.lab_desk import LabDesk

DEFAULT = (0, 0)
"""What pygame says while the system's key repeat is off."""


@pytest.fixture
def lab(monkeypatch):
    """The lab with a scene that runs; its pictures, which take most of the time, are not drawn."""
    monkeypatch.setattr(Lab, "draw", lambda _lab, _surface: None)
    desk = LabDesk("discrete-swept")
    yield desk
    desk.close()


@pytest.fixture
def playing():
    """A game before its first serve, and what its recorder was told."""
    told = []
    kept = shared(recorder=lambda controls, after: told.append((controls, after)))
    desk = Desk(kept, Title(kept))
    desk.told = told
    desk.press(pygame.K_RETURN)
    assert isinstance(desk.screen, PlayScreen)
    yield desk
    desk.close()


def test_a_held_key_acts_after_a_while_then_often():
    """Not before FIRST seconds after the frame of its press, then once every NEXT, and once a frame at most."""
    key, due = Repeat(1).later(100.0)
    assert (key, due) == (Repeat(1, FIRST), False)
    key, due = key.later(FIRST - 1e-3)
    assert not due
    key, due = key.later(2e-3)
    assert (key, due) == (Repeat(1, NEXT), True)
    assert key.later(100.0) == (Repeat(1, NEXT), True)


def test_a_tap_changes_the_scene_once(lab):
    """However late the frame that hears of it: the next scene is opened, not the one after."""
    names = [scene.name for scene in scenes()]
    first = names.index(lab.session.scene.name)
    lab._post_key(pygame.KEYDOWN, pygame.K_RIGHTBRACKET)
    lab.screen = app.frame(lab.window, lab.shared, lab.screen, 5.0, lab._keyboard)
    lab._post_key(pygame.KEYUP, pygame.K_RIGHTBRACKET)
    lab.wait(1.0)
    assert lab.session.scene.name == names[first + 1]
    assert pygame.key.get_repeat() == DEFAULT


def test_a_held_step_repeats_until_it_is_released(lab):
    """The key that steps forward steps again while it is held, and no longer."""
    first = lab.session.tick
    lab.hold(pygame.K_PERIOD)
    lab.wait(FIRST / 2)
    assert lab.session.tick == first + 1
    lab.wait(FIRST)
    held = lab.session.tick
    assert held > first + 2
    lab.release(pygame.K_PERIOD)
    lab.wait(0.5)
    assert lab.session.tick == held


def test_a_step_whose_release_is_lost_stops(lab):
    """The keyboard's state says that the key is up; no event has to."""
    lab.hold(pygame.K_PERIOD)
    lab.wait(2 * FIRST)
    lab.down.clear()
    lab.wait(FRAME)
    stopped = lab.session.tick
    lab.wait(0.5)
    assert lab.session.tick == stopped


@pytest.mark.parametrize(("key", "mod"), [(pygame.K_F11, 0), (pygame.K_RETURN, pygame.KMOD_LALT)])
def test_the_lab_goes_full_screen_once(lab, key, mod):
    """Pressed and released, the key changes the window once, and the second press changes it back."""
    assert not lab.shared.full_screen
    lab.press(key, mod=mod)
    assert lab.shared.full_screen
    lab.press(key, mod=mod)
    assert not lab.shared.full_screen


def test_a_release_lost_in_a_flood_of_events_stops_the_paddles(playing):
    """More events than the queue holds: the release is not among them, and the paddles are let go all the same."""
    playing.hold(pygame.K_RIGHT)
    playing.wait(0.2)
    assert playing.told[-1][0].turn == 1
    playing.down.clear()
    playing.wait(2 * FRAME)
    assert playing.told[-1][0].turn == 0


def test_the_keyboard_is_asked_once_a_frame(playing):
    """Not once an event."""
    asked = []

    def keyboard():
        asked.append(True)
        return KeyboardState(frozenset())

    for _ in range(100):
        playing.move((10, 10))
    playing.screen = app.frame(playing.window, playing.shared, playing.screen, FRAME, keyboard)
    assert asked == [True]
