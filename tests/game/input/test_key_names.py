"""What the help calls the keys."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from game.input import key_names
from game.input.events import system_layout
from game.input.keys import Action
from game.input.scancodes import SCANCODES, US_CODES

MODIFIERS = {"Control": "CTRL", "Shift": "SHIFT", "Alt": "ALT", "Meta": "GUI"}


@pytest.fixture
def russian(monkeypatch):
    """A layout on which the letters are Cyrillic."""
    written = {pygame.KSCAN_A: "ф", pygame.KSCAN_D: "в", pygame.KSCAN_H: "р", pygame.KSCAN_P: "з"}  # noqa: RUF001
    codes = {position: code for position, code in US_CODES.items() if not chr(code).isalpha()}
    monkeypatch.setattr(key_names, "_layout", codes | {at: ord(letter) for at, letter in written.items()})


def test_keys_are_named_as_the_us_layout_names_them_without_a_display():
    """Steering by its arrow first, commands by their letter, the keypad never."""
    pygame.quit()
    assert key_names.key_names(Action.LEFT) == ("Left", "A")
    assert key_names.key_names(Action.CONFIRM) == ("Enter",)
    assert key_names.key_names(Action.HELP) == ("H", "F1")
    assert key_names.key_name(Action.BACK) == "Esc"


@pytest.mark.usefixtures("russian")
def test_keys_are_named_as_their_own_layout_writes_them():
    """On a Russian layout, A is called Ф, and the help says so."""
    assert key_names.key_names(Action.LEFT) == ("Left", "Ф")
    assert key_names.key_name(Action.HELP) == "Р"  # noqa: RUF001
    rows = {meaning: keys for keys, meaning in key_names.play_help()}
    assert rows["turn the paddles"] == "Left, Right   Ф В"  # noqa: RUF001
    assert rows["this help"] == "Р   F1"  # noqa: RUF001


def test_a_key_that_the_layout_does_not_have_has_no_name(monkeypatch):
    """The US layout has no key for +, which shares that of =; the German one has, and where the US one has = it writes no =."""
    faster = (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS)
    assert key_names.code_names(faster) == ("=",)
    german = US_CODES | {pygame.KSCAN_RIGHTBRACKET: pygame.K_PLUS, pygame.KSCAN_EQUALS: ord("\u00b4")}
    monkeypatch.setattr(key_names, "_layout", german)
    assert key_names.code_names(faster) == ("+", "\u00b4")


def test_the_present_layout_is_asked_of_the_system():
    """SDL's dummy driver has the US layout; what it says is what the table of US codes says."""
    pygame.display.init()
    try:
        assert US_CODES.items() <= system_layout().items()
    finally:
        pygame.quit()


def test_positions_are_those_of_sdl():
    """The browsers' names stand for SDL's scancodes."""
    renamed = {"PrintScreen": "PRINTSCREEN", "ScrollLock": "SCROLLLOCK", "NumLock": "NUMLOCK"}
    renamed |= {"Minus": "MINUS", "Equal": "EQUALS", "Quote": "APOSTROPHE", "Backquote": "GRAVE", "Enter": "RETURN"}
    renamed |= {"BracketLeft": "LEFTBRACKET", "BracketRight": "RIGHTBRACKET", "IntlBackslash": "NONUSBACKSLASH"}
    renamed |= {"IntlRo": "INTERNATIONAL1", "KanaMode": "INTERNATIONAL2", "IntlYen": "INTERNATIONAL3"}
    renamed |= {f"{key}{side}": f"{side[0]}{word}" for key, word in MODIFIERS.items() for side in ("Left", "Right")}
    renamed |= {"NumpadEnter": "KP_ENTER", "NumpadDecimal": "KP_PERIOD", "NumpadAdd": "KP_PLUS", "NumpadSubtract": "KP_MINUS"}
    for name, position in SCANCODES.items():
        plain = name.removeprefix("Key").removeprefix("Digit").removeprefix("Arrow").replace("Numpad", "KP_").upper()
        assert position == getattr(pygame, f"KSCAN_{renamed.get(name, plain)}"), name


@pytest.mark.parametrize("rows", [key_names.play_help, key_names.watch_help])
def test_every_row_of_the_help_fits_its_column(rows):
    """A row has a name for every key, at most 24 characters of them."""
    for keys, meaning in rows():
        assert keys.strip()
        assert meaning
        assert len(keys) <= 24
