"""A line of text while it is typed, as a value: caret, selection, clipboard."""

import pygame
import pytest

from game.screens.toolkit.items.text_field import TextField, after_event

MOST = 8
SHIFT, CTRL = pygame.KMOD_LSHIFT, pygame.KMOD_LCTRL


@pytest.fixture
def clipboard(monkeypatch):
    """A clipboard in memory."""
    held = ["9\n9"]
    monkeypatch.setattr(pygame.scrap, "put_text", held.append)
    monkeypatch.setattr(pygame.scrap, "get_text", lambda: held[-1])
    return held


def edited(text, *done):
    """A text, all selected, after keys with modifiers, and after letters."""
    field = TextField.all_of(text)
    for one in done:
        key, mod = one if isinstance(one, tuple) else (one, 0)
        event = (
            pygame.Event(pygame.TEXTINPUT, text=key) if isinstance(key, str) else pygame.Event(pygame.KEYDOWN, key=key, mod=mod)
        )
        field = after_event(field, event, MOST)
    return field


@pytest.mark.parametrize(
    ("done", "text", "caret"),
    [
        (["7"], "7", 1),
        ([pygame.K_END, "7"], "12347", 5),
        ([pygame.K_HOME, "7"], "71234", 1),
        ([pygame.K_LEFT, "7"], "71234", 1),
        ([pygame.K_RIGHT, pygame.K_LEFT, "7"], "12374", 4),
        ([pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_BACKSPACE], "123", 3),
        ([pygame.K_HOME, pygame.K_BACKSPACE, pygame.K_DELETE], "234", 0),
        ([pygame.K_BACKSPACE, pygame.K_BACKSPACE], "", 0),
        ([pygame.K_HOME, (pygame.K_RIGHT, SHIFT), (pygame.K_RIGHT, SHIFT), "7"], "734", 1),
        ([pygame.K_HOME, (pygame.K_END, SHIFT), (pygame.K_LEFT, SHIFT), pygame.K_DELETE], "4", 0),
        ([pygame.K_END, "567890"], "12345678", 8),
        (["1234567890"], "12345678", 8),
        (["\n\t7"], "7", 1),
        ([pygame.K_END, (pygame.K_a, CTRL), "7"], "7", 1),
        ([(pygame.K_v, CTRL)], "99", 2),
        ([(pygame.K_x, CTRL), "0", (pygame.K_v, CTRL)], "01234", 5),
        ([(pygame.K_c, CTRL), pygame.K_END, (pygame.K_v, CTRL)], "12341234", 8),
        ([pygame.K_F5], "1234", 4),
    ],
)
@pytest.mark.usefixtures("clipboard")
def test_what_keys_and_letters_make_of_a_text(done, text, caret):
    """Letters replace the selection, as many as there is room for; arrows, Home and End move, with Shift they select."""
    field = edited("1234", *done)
    assert (field.text, field.caret) == (text, caret)


def test_without_a_clipboard_nothing_is_lost(monkeypatch):
    """Where the system has none, cut and paste leave the text as it is."""

    def missing(*_):
        raise pygame.error("no clipboard")

    monkeypatch.setattr(pygame.scrap, "put_text", missing)
    monkeypatch.setattr(pygame.scrap, "get_text", missing)
    assert edited("1234", (pygame.K_x, CTRL), (pygame.K_v, CTRL)).text == "1234"
