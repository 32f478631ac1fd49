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


def test_the_picture_rate_is_sane():
    """Whatever the display says."""
    pygame.display.init()
    assert 1 <= display.refresh_rate() <= 240
