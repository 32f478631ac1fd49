"""Displays and sound cards that are not there."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from game.system import window as display
from game.system.errors import EnvironmentMissingError


@pytest.fixture(autouse=True)
def _closed():
    """Leave pygame closed."""
    pygame.quit()
    yield
    pygame.quit()


@pytest.mark.parametrize("driver", ["offscreen", "dummy"])
def test_a_driver_that_shows_nothing_is_not_a_display(monkeypatch, driver):
    """Without a display SDL says nothing and draws into the void; that must not look like success."""
    monkeypatch.delenv("SDL_VIDEODRIVER")
    monkeypatch.setattr(pygame.display, "init", lambda: None)
    monkeypatch.setattr(pygame.display, "get_driver", lambda: driver)
    with pytest.raises(EnvironmentMissingError, match="no display found"):
        display.open_window("test")


def test_a_driver_that_was_asked_for_is_opened():
    """Tests and screenshots ask for the dummy driver by name."""
    window = display.open_window("test", (320, 200))
    assert window.get_surface().get_size() == (320, 200)
    assert window.resizable
    window.destroy()


def test_an_unknown_driver_is_named(monkeypatch):
    """SDL's own words are in the message."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "nonsense")
    with pytest.raises(EnvironmentMissingError, match="nonsense"):
        display.open_window("test")


def test_a_window_is_no_larger_than_the_desktop():
    """The dummy driver's desktop is smaller than the size the game starts with."""
    window = display.open_window("test", (100_000, 100_000))
    assert window.size == pygame.display.get_desktop_sizes()[0]
    window.destroy()


def test_the_first_window_leaves_room_for_the_bars_of_a_desktop():
    """Title bar and task bar are together no higher than 96 units or an eighth of the desktop."""
    window = display.open_window("test")
    wide, tall = pygame.display.get_desktop_sizes()[0]
    assert window.size[0] < wide
    assert window.size[1] <= tall - max(96, tall // 9)
    window.destroy()


def test_a_window_opens_where_it_was_if_that_is_still_on_the_desktop():
    """A position that is kept is taken; one beyond an edge, of a screen that is gone, is not."""
    wide, tall = pygame.display.get_desktop_sizes()[0] if pygame.display.get_init() else (1024, 768)
    for position, is_taken in (((30, 40), True), ((wide - 100, 40), False), ((-2000, 40), False)):
        window = display.open_window("test", (400, 300), position)
        assert (window.position == position) == is_taken
        assert window.size == (400, 300)
        window.destroy()
    assert tall > 300


def test_the_picture_rate_is_sane():
    """Whatever the display says."""
    pygame.display.init()
    assert 1 <= display.refresh_rate() <= 240
