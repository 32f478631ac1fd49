"""Own keys, captions, the ghost and the credits on the page, in a real browser."""

import pytest

from game.levels import campaign
from game.replays.state_hash import state_hash
from tests.support.best_run import STORE, for_browser, stored_run
from tests.support.web_page import PAD


def held(page):
    """The id of the control that has the keyboard."""
    return page.tab.evaluate("document.activeElement.id")


def keys_menu(page):
    """Open the player's keys."""
    page.to_title()
    page.use("settings")
    page.use("keys")


def turns(page, key):
    """Whether a key turns the paddles of a new game."""
    page.go("classic/1")
    before = page.standing()["paddle"]
    page.tab.keyboard.down(key)
    page.frames(4)
    page.tab.keyboard.up(key)
    return page.standing()["paddle"] != before


def test_a_key_is_chosen_by_keyboard_alone_a_conflict_is_said_and_a_reload_keeps_it(page):
    """Arrows go through the rows, the question takes the next key, and the row has the keyboard again."""
    keys_menu(page)
    assert held(page) == "item-reset"
    for key in ("ArrowDown", "ArrowRight", "ArrowDown", "ArrowUp", "ArrowLeft", "Enter"):
        page.tab.keyboard.press(key)
    page.wait(lambda: page.title() == "Left, clockwise", page.title)
    page.tab.keyboard.press("k")
    page.wait(lambda: page.title() == "Keys", page.title)
    assert held(page) == "item-key-left-0"
    assert page.tab.inner_text("#item-key-left-0") == "K"
    page.use("key-pause-0")
    page.tab.keyboard.press("m")
    page.wait(lambda: page.notification() == "Pause: M, no longer Sound on or off", page.notification)
    assert turns(page, "k")
    assert page.ask("save") is True
    page.open()
    assert turns(page, "k")
    assert not turns(page, "ArrowLeft")
    page.tab.keyboard.press("m")
    page.wait(lambda: page.title() == "Paused", page.title)
    keys_menu(page)
    page.use("reset")
    assert page.tab.inner_text("#item-key-left-0") == "Left"


def test_a_button_is_chosen_by_gamepad_alone(page):
    """While the question is open, no button of the gamepad uses a control; B leads back."""
    page.tab.evaluate(PAD)

    def press(button):
        for value in (1, 0):
            page.tab.evaluate(f"pad.buttons[{button}].value = {value}")
            page.frames(2)

    keys_menu(page)
    for button in (13, 15, 15, 0):
        press(button)
    assert page.title() == "Left, clockwise"
    press(0)
    page.wait(lambda: page.notification() == "A is reserved: Serve, go on", page.notification)
    assert held(page) == "item-key-left-2"
    press(0)
    press(1)
    assert page.title() == "Keys"
    page.tab.evaluate("navigator.getGamepads = () => []")


@pytest.fixture
def raced(open_page, tmp_path):
    """A page in whose store the desktop's files of a best run are, with captions; and that run, tick by tick."""
    run = stored_run(tmp_path, campaign())
    with open_page() as page:
        page.tab.evaluate(STORE, for_browser(tmp_path))
        page.open()
        page.use("settings")
        page.tab.check("#item-captions")
        page.frames(2)
        yield page, run


def test_the_desktops_best_run_is_raced_and_captions_come_with_the_sounds(raced):
    """The ghost's state is that of the recorded game at the player's tick; whoever hears the first brick reads it, too."""
    page, run = raced
    page.tab.evaluate("""() => {
      const { play } = polarBreakout.speaker;
      window.heard = 0;
      polarBreakout.speaker.play = function (sounds) {
        window.heard += sounds.length;
        return play.call(this, sounds);
      };
    }""")
    page.go("level/1")
    page.tab.keyboard.press("Space")
    stood = page.wait(lambda: (now := page.standing()).get("ghost") and now, page.standing)
    assert stood["ghost"] == state_hash(run[stood["since_serve"] + 1])
    page.wait(lambda: any(words.startswith("brick struck") for words in page.standing()["captions"]), page.standing)
    assert page.tab.evaluate("heard") > 0


def test_credits_and_help_open_and_close_by_keyboard(page):
    """The button that leads back has the keyboard; arrows scroll a text that does not fit."""
    page.tab.focus("#item-credits")
    page.tab.keyboard.press("Enter")
    page.wait(lambda: page.title() == "Credits", page.title)
    assert "Lecture notes on collision detection" in page.tab.inner_text("#menu")
    assert held(page) == "item-back"
    page.tab.keyboard.press("Escape")
    page.wait(lambda: page.title() == "Polar Breakout", page.title)
    page.tab.focus("#item-help")
    page.tab.keyboard.press("Enter")
    page.wait(lambda: page.title() == "How to play", page.title)
    page.tab.keyboard.press("ArrowDown")
    page.wait(lambda: page.tab.evaluate("document.getElementById('menu').scrollTop") > 0)
    page.tab.keyboard.press("Enter")
    page.wait(lambda: page.title() == "Polar Breakout", page.title)
