"""Keys and buttons are chosen on the screen, by keys, by mouse and by gamepad."""

import pygame
import pytest

from game.input.actions import Action
from game.input.key_names import NO_KEY, key_names
from game.input.keys import BINDINGS, KEYS
from game.screens.menus.settings.key_capture import KeyCapture
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.menus.settings.rows import PARTS
from game.screens.title import Title
from game.screens.toolkit.focus import Focus
from game.settings.file import SettingsFile
from tests.support.windows.dummy_window import FRAME, Desk, shared

KEYS_PART = [part.name() for part in PARTS].index("Keys")
LEFT_ROW, PAUSE_ROW = 2, 9


@pytest.fixture
def desk(tmp_path):
    """The app at its settings, where the keys are; the settings in a file."""
    state = shared()
    state.settings_file = SettingsFile(tmp_path / "settings.json")
    panel = SettingsPanel(state, Title(state))
    panel.open_tab(KEYS_PART)
    found = Desk(state, panel, (1280, 800))
    found.wait(FRAME)
    yield found
    found.close()
    KEYS.change(BINDINGS)


def asked(desk, row, column):
    """Open the question for a key of a row."""
    desk.screen._focus = Focus(row, column)
    desk.press(pygame.K_RETURN)
    assert isinstance(desk.screen, KeyCapture)


def pad(desk, button):
    """Press a button of a gamepad."""
    pygame.event.post(pygame.Event(pygame.CONTROLLERBUTTONDOWN, instance_id=0, button=button))
    desk.wait(2 * FRAME)


def test_a_key_is_chosen_and_kept(desk):
    """M pauses from now on, also in the next session; the toast says that the sound has lost it; a reset gives it back."""
    asked(desk, PAUSE_ROW, 1)
    desk.press(pygame.K_m)
    desk.wait(FRAME)
    assert isinstance(desk.screen, SettingsPanel)
    assert desk.shared.toast.text == "Pause: M, no longer Sound on or off"
    assert key_names(Action.PAUSE) == ("M", "Pause")
    assert key_names(Action.MUTE) == (NO_KEY,)
    desk.press(pygame.K_ESCAPE)
    again = SettingsFile(desk.shared.settings_file._path).load()
    assert again.own_keys == desk.shared.settings.own_keys
    desk.shared.change(again._replace(sound=False))
    assert KEYS.action(pygame.KSCAN_M, pygame.K_m) is Action.PAUSE
    desk.screen = SettingsPanel(desk.shared, desk.screen)
    desk.screen.open_tab(KEYS_PART)
    desk.screen._focus = Focus(0, 0)
    desk.press(pygame.K_RETURN)
    assert KEYS.action(pygame.KSCAN_M, pygame.K_m) is Action.MUTE


def test_esc_leaves_a_key_as_it_is_and_the_same_key_takes_it_away(desk):
    """And what must stay stays, with a word why: Enter with what accepts, the last key with its direction."""
    asked(desk, PAUSE_ROW, 1)
    desk.press(pygame.K_ESCAPE)
    assert desk.shared.settings.own_keys.keys == ()
    asked(desk, PAUSE_ROW, 1)
    desk.press(pygame.K_RETURN)
    assert desk.shared.toast.text == "Enter is reserved: Confirm"
    asked(desk, PAUSE_ROW, 2)
    desk.press(pygame.K_PAUSE)
    assert key_names(Action.PAUSE) == ("P",)
    asked(desk, LEFT_ROW, 2)
    desk.press(pygame.K_a)
    asked(desk, LEFT_ROW, 1)
    desk.press(pygame.K_LEFT)
    assert desk.shared.toast.text == "Left stays: Left, clockwise has no other key"
    assert key_names(Action.LEFT) == ("Left",)


def test_a_button_is_chosen_by_gamepad_and_a_click_leads_back(desk):
    """A button of the wrong kind is not taken, B leads back, and so does the button under the question."""
    asked(desk, PAUSE_ROW, 3)
    desk.press(pygame.K_k)
    assert isinstance(desk.screen, KeyCapture)
    pad(desk, pygame.CONTROLLER_BUTTON_Y)
    assert KEYS.button_action(pygame.CONTROLLER_BUTTON_Y) is Action.PAUSE
    assert KEYS.binding(Action.TIP).buttons == ()
    asked(desk, PAUSE_ROW, 1)
    pad(desk, pygame.CONTROLLER_BUTTON_B)
    assert isinstance(desk.screen, SettingsPanel)
    asked(desk, PAUSE_ROW, 1)
    (leave,) = [positioned for positioned in desk.screen._form_layout(desk.window.size).items if positioned.item.focusable]
    desk.click(leave.box.center)
    assert isinstance(desk.screen, SettingsPanel)


def test_a_direction_that_is_held_goes_on(desk):
    """Down moves the focus once when it is pressed, and after a moment again and again until it comes up."""
    desk.screen._focus = Focus(LEFT_ROW, 1)
    desk.hold(pygame.K_DOWN)
    desk.wait(0.2)
    assert desk.screen._focus.row == LEFT_ROW + 1
    desk.wait(0.6)
    row = desk.screen._focus.row
    assert row >= LEFT_ROW + 4
    desk.release(pygame.K_DOWN)
    desk.wait(0.3)
    assert desk.screen._focus.row == row
