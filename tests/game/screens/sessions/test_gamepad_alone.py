"""What else a gamepad alone can do: settings, bindings, levels, the editor, replays."""

import pygame

from game.editor.window.screen import Editor
from game.input.keys import KEYS, Action
from game.input.players import Players
from game.screens.menus.settings.key_capture import KeyCapture
from game.screens.play.screen import PlayScreen
from game.screens.watch import Watch
from game.storage.storage import Storage


def test_a_gamepad_alone_sets_and_binds(pad_desk):
    """Tabs, a slider, a button given to an action, all as at first again; and a number entered for endless levels."""
    desk = pad_desk
    desk.choose("Settings")
    desk.press(pygame.K_TAB, pygame.K_TAB)
    volume = desk.shared.settings.volume
    desk.focus("Volume")
    desk.press(pygame.K_LEFT)
    assert desk.shared.settings.volume < volume
    desk.press(pygame.K_TAB)
    items = desk.screen._form_layout(desk.window.size).items
    row = next(
        positioned.row
        for positioned in items
        if [cell[0] for cell in getattr(positioned.item, "cells", ())] == ["Give up a ball"]
    )
    while desk.screen._focus.row != row:
        desk.press(pygame.K_DOWN)
    desk.press(pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_RETURN)
    assert isinstance(desk.screen, KeyCapture)
    desk.press(pygame.K_COMMA)
    assert KEYS.binding(Action.GIVE_UP).buttons == (pygame.CONTROLLER_BUTTON_LEFTSHOULDER,)
    desk.choose("Reset all keys and buttons")
    assert KEYS.binding(Action.GIVE_UP).buttons == (pygame.CONTROLLER_BUTTON_X,)
    desk.press(pygame.K_ESCAPE)
    for label in ("Endless", "Levels from a number", "4", "Done"):
        desk.choose(label)
    assert desk.screen._ticked.game.seed == 4


def test_a_gamepad_alone_chooses_makes_and_plays_a_level(pad_desk):
    """Difficulty and players; a level made in the editor, edited again and played; the pause menu and its question."""
    desk = pad_desk
    desk.choose("Levels")
    desk.choose("Difficulty")
    desk.choose("Players")
    assert (desk.shared.difficulty, desk.shared.players) == ("hard", Players.TOGETHER)
    desk.choose("Make a new level")
    assert isinstance(desk.screen, Editor)
    desk.press(pygame.K_g, pygame.K_ESCAPE)
    for label in ("Save and leave", "My level", "Edit"):
        desk.choose(label)
    assert isinstance(desk.screen, Editor)
    desk.press(pygame.K_ESCAPE)
    desk.choose("My level")
    desk.choose("Play")
    assert desk.screen._ticked.game.level.rings[0].slots()[0] == 0
    desk.press(pygame.K_p)
    desk.choose("Restart")
    desk.choose("Continue")
    assert isinstance(desk.screen, PlayScreen)


def test_a_gamepad_alone_keeps_names_and_deletes_a_game(pad_desk, tmp_path):
    """A replay is renamed, watched tick by tick, and deleted after the question."""
    desk = pad_desk
    desk.press(pygame.K_RETURN, pygame.K_SPACE)
    desk.wait(0.2)
    desk.press(pygame.K_p)
    desk.choose("Main menu")
    desk.shared.storage.game_done()
    desk.choose("Replays")
    (game,) = desk.shared.storage.games.listed()
    for label in (game.date, "Rename", "Z", "Done", "Z", "Delete", "Keep it", "Z", "Watch"):
        desk.choose(label)
    assert isinstance(desk.screen, Watch)
    desk.press(pygame.K_SPACE)
    at = desk.screen._at
    desk.press(pygame.K_PERIOD, pygame.K_PERIOD, pygame.K_COMMA)
    assert desk.screen._at == int(at) + 1
    desk.press(pygame.K_ESCAPE)
    for label in ("Z", "Delete", "Delete"):
        desk.choose(label)
    assert Storage(tmp_path).games.listed() == []
