"""Panels over another screen are drawn once, and again when what they show has changed."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pygame
import pytest

from game.input.signals import Action, Pressed
from game.levels import built_in
from game.screens.menus.help import Help
from game.screens.menus.settings_panel import SettingsPanel
from game.screens.play import PlayScreen
from game.screens.toolkit.menu import Entry, Menu
from tests.support.dummy_window import shared

SIZE = (640, 400)


class Under(PlayScreen):
    """A game that counts how often it is drawn."""

    drawn = 0

    def draw(self, surface):
        """Draw it, and count."""
        self.drawn += 1
        super().draw(surface)


def menu(state, under):
    """A menu with two entries."""
    entries = (Entry("One", lambda: under), Entry("Two", lambda: None))
    return Menu(state, under, "Title", ("A line.",), entries, lambda: under)


PANELS = pytest.mark.parametrize("opened", [menu, Help, SettingsPanel], ids=["menu", "help", "settings"])


@pytest.fixture
def state():
    """What outlives a screen, with pymunk's normals to be switched on."""
    made = shared(4)
    made.compare = lambda _ticked: ()
    return made


def picture(panel, size=SIZE):
    """What the panel shows, as bytes."""
    surface = pygame.Surface(size, 0, 32)
    surface.fill((255, 0, 255))
    panel.draw(surface)
    return pygame.image.tobytes(surface, "RGB")


@PANELS
def test_a_panel_that_stands_still_is_drawn_once(state, opened):
    """The screen below is drawn for the first frame alone, and every frame shows the same."""
    under = Under(state, built_in()[4:])
    panel = opened(state, under)
    assert len({picture(panel) for _ in range(5)}) == 1
    assert under.drawn == 1


@PANELS
@pytest.mark.parametrize(
    "change",
    [
        lambda state: state.change(state.settings.other_colours()),
        lambda state: state.change(state.settings._replace(sound=False)),
        lambda state: setattr(state, "shows_normals", True),
    ],
    ids=["colours", "sound", "normals"],
)
def test_what_a_key_changes_is_seen_at_once(state, opened, change):
    """After a change the panel shows what one that was opened later shows, and it is drawn once again."""
    under = Under(state, built_in()[4:])
    panel = opened(state, under)
    before = picture(panel)
    change(state)
    after = picture(panel)
    assert after != before
    assert under.drawn == 2
    assert picture(panel) == after
    assert under.drawn == 2
    assert picture(opened(state, under)) == after


@PANELS
def test_another_size_is_another_picture(state, opened):
    """Resized, the panel is drawn for the new size; at the old size it looks as before."""
    panel = opened(state, Under(state, built_in()[4:]))
    first = picture(panel)
    assert picture(panel, (900, 700)) == picture(opened(state, Under(state, built_in()[4:])), (900, 700))
    assert picture(panel) == first


@pytest.mark.parametrize("opened", [menu, SettingsPanel], ids=["menu", "settings"])
def test_another_selection_is_another_picture(state, opened):
    """Down moves the frame around an entry or a row; up moves it back."""
    panel = opened(state, Under(state, built_in()[4:]))
    first = picture(panel)
    panel.answer(Pressed(Action.DOWN), SIZE)
    assert picture(panel) != first
    panel.answer(Pressed(Action.UP), SIZE)
    assert picture(panel) == first


def test_help_over_a_menu_shows_the_menu_below(state):
    """A panel over a panel: both are drawn once, and closing the upper one shows the lower one as it was."""
    under = Under(state, built_in()[4:])
    lower = menu(state, under)
    before = picture(lower)
    upper = lower.answer(Pressed(Action.HELP), SIZE)
    assert picture(upper) == picture(upper) != before
    assert picture(upper.answer(Pressed(Action.BACK), SIZE)) == before
    assert under.drawn == 1
