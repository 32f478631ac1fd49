"""Panels over another screen are drawn once, and again when what they show has changed."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pygame
import pytest

from game.input.signals import Action, Clicked, Pressed, Zoomed
from game.levels import classic
from game.screens.menus.help.panel import Help
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play.screen import PlayScreen
from game.screens.toolkit.focus import TABS
from game.screens.toolkit.items.basic import ButtonItem
from game.screens.toolkit.layout import Content
from game.screens.toolkit.menu import Entry, Menu
from game.screens.toolkit.panel import Panel
from game.screens.toolkit.text_entry import TextEntry
from tests.support.windows.dummy_window import Desk, shared

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
    under = Under(state, classic()[4:])
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
    under = Under(state, classic()[4:])
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
    panel = opened(state, Under(state, classic()[4:]))
    first = picture(panel)
    assert picture(panel, (900, 700)) == picture(opened(state, Under(state, classic()[4:])), (900, 700))
    assert picture(panel) == first


@pytest.mark.parametrize("opened", [menu, SettingsPanel], ids=["menu", "settings"])
def test_another_selection_is_another_picture(state, opened):
    """Down moves the frame around an item; up moves it back."""
    panel = opened(state, Under(state, classic()[4:]))
    first = picture(panel)
    panel.answer(Pressed(Action.DOWN), SIZE)
    assert picture(panel) != first
    panel.answer(Pressed(Action.UP), SIZE)
    assert picture(panel) == first


def test_of_panels_over_each_other_one_is_seen(state):
    """Help over a menu looks as help over the game itself, and closing it shows the menu as it was."""
    under = Under(state, classic()[4:])
    lower = Menu(state, under, "Title", (), (Entry("Help", lambda: Help(state, lower)),), lambda: under)
    before = picture(lower)
    upper = lower.answer(Pressed(Action.CONFIRM), SIZE)
    assert picture(upper) == picture(Help(state, under)) != before
    assert picture(upper.answer(Pressed(Action.BACK), SIZE)) == before


class Long(Panel):
    """A panel with more rows than fit, of two buttons each, and what was used."""

    def __init__(self, state):
        super().__init__(state, None)
        self.used = []

    def content(self):
        rows = [tuple(ButtonItem(f"{row}{side}", self._use(f"{row}{side}")) for side in "ab") for row in range(40)]
        return Content("Long", tuple(rows), ((ButtonItem("end", self._use("end")),),), ("One", "Two"), self._tab)

    def _use(self, label):
        return lambda: self.used.append(label) or self


def test_every_item_of_a_long_panel_is_reached_by_keys_and_seen(state):
    """Down goes row by row to the footer and around by the tabs; the item with the focus is always inside the body."""
    panel, seen = Long(state), []
    for _ in range(41):
        layout = panel._form_layout(SIZE)
        focus = panel._settled(layout)
        positioned = next((positioned for positioned in layout.items if (positioned.row, positioned.column) == focus), None)
        if positioned is not None and positioned.in_body:
            assert layout.body.contains(positioned.box)
        seen.append(focus)
        panel.answer(Pressed(Action.CONFIRM), SIZE)
        panel.answer(Pressed(Action.DOWN), SIZE)
    assert panel.used == [*[f"{row}a" for row in range(40)], "end"]
    assert len(set(seen)) == 41
    assert panel._focus == (TABS, 0)
    panel.answer(Pressed(Action.RIGHT), SIZE)
    assert panel.content().tab == 1


def test_the_wheel_and_the_scroll_bar_scroll(state):
    """The wheel shows what is further down and a click uses it there; a drag on the bar goes to the end."""
    panel = Long(state)
    body = panel._form_layout(SIZE).body
    pixel = complex(body.left + 20, body.centery)
    panel.answer(Clicked(pixel), SIZE)
    panel.answer(Zoomed(-2.0), SIZE)
    panel.answer(Clicked(pixel), SIZE)
    first, second = (int(label[:-1]) for label in panel.used)
    assert second >= first + 2
    bar = panel._form_layout(SIZE).plate.right - round(panel.unit(SIZE) * 1.8)
    panel.answer(Clicked(complex(bar, body.bottom - 1)), SIZE)
    assert panel._scroll == panel._form_layout(SIZE).over > 0
    panel.answer(Zoomed(1000.0), SIZE)
    assert panel._scroll == 0


def test_a_text_that_is_too_long_is_read_on_with_the_arrow_keys(state):
    """Down scrolls the list of keys to its end before it moves the focus, and up scrolls back."""
    panel = Help(state, Under(state, classic()), "Keys", tuple((f"key {number}", "does it") for number in range(60)))
    while panel._scroll < panel._form_layout(SIZE).over:
        before = panel._scroll
        panel.answer(Pressed(Action.DOWN), SIZE)
        assert panel._scroll > before
    panel.answer(Pressed(Action.UP), SIZE)
    assert panel._scroll < panel._form_layout(SIZE).over


def test_text_is_entered_by_typing_and_by_pointing(state):
    """Letters are typed, not obeyed; backspace takes one away; the small keyboard adds to it; Enter accepts it."""
    done = []
    state.open_lab = None
    entry = TextEntry(state, Under(state, classic()), "Name", "", 8, done.append)
    desk = Desk(state, entry)
    try:
        desk.type("hmo")
        desk.press(pygame.K_BACKSPACE)
        desk.click_on("Q")
        desk.type("toolong")
        assert entry.text == "hmQtoolo"
        assert desk.screen is entry
        desk.focus("Done")
        desk.press(pygame.K_RETURN)
    finally:
        desk.close()
    assert done == ["hmQtoolo"]
