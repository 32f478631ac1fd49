"""Whole sessions: from the title through a game, its results, the scores and a replay, and out; by keys, mouse, gamepad."""

import pygame

from game.editor.window.screen import Editor
from game.levels import classic
from game.replays.file import load
from game.replays.verify import verified
from game.screens.menus.credits import Credits
from game.screens.menus.help.panel import Help
from game.screens.menus.high_scores import HighScores
from game.screens.menus.level_select import LevelSelect
from game.screens.menus.replays import Replays
from game.screens.menus.results import ResultsPanel
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play import buttons as play_buttons
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.menu import Menu
from game.screens.toolkit.text_entry import TextEntry
from game.screens.watch import Watch
from game.storage.storage import Storage
from tests.support.windows.sessions import lose, visit


def test_by_keys_alone(desk, tmp_path):
    """Every panel from the title and back; a game lost, a name entered, the score in the table, its replay watched; out."""
    esc = lambda: desk.press(pygame.K_ESCAPE)  # noqa: E731
    panels = (("High scores", HighScores), ("Replays", Replays), ("How to play", Help), ("Settings", SettingsPanel))
    visit(desk, *[(lambda label=label: desk.choose(label), kind, esc) for label, kind in (*panels, ("Credits", Credits))])
    desk.choose("Levels")
    assert isinstance(desk.screen, LevelSelect)
    desk.choose(classic()[1].name)
    assert isinstance(desk.screen, LevelSelect), "it is locked"
    desk.choose(classic()[0].name)
    assert isinstance(desk.screen, PlayScreen)
    visit(desk, (lambda: desk.press(pygame.K_p), Menu, esc), (lambda: desk.press(pygame.K_o), SettingsPanel, esc))
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    assert isinstance(desk.screen, ResultsPanel)
    score = desk.screen._under._ticked.game.score
    desk.press(pygame.K_RETURN)  # the figures need not be waited for
    desk.choose("Enter your name")
    assert isinstance(desk.screen, TextEntry)
    desk.type("Mo")
    desk.choose("Done")
    assert isinstance(desk.screen, HighScores)
    (entry,) = Storage(tmp_path).scores.value.entries
    assert (entry.name, entry.score, entry.difficulty) == ("Mo", score, "normal")
    desk.choose("1    Mo")
    assert isinstance(desk.screen, Watch)
    desk.press(pygame.K_END, pygame.K_ESCAPE)
    assert isinstance(desk.screen, HighScores)
    desk.choose("Main menu")
    assert isinstance(desk.screen, Title)
    desk.press(pygame.K_ESCAPE)
    desk.choose("Quit")
    assert desk.screen is None
    recording = load(tmp_path / "replays" / entry.replay)
    assert verified(recording).game.score == score


def test_by_mouse_alone(desk, tmp_path):
    """The same without a key: what a key opens has a button, and every panel has a cross."""
    close = lambda: desk.click(desk.screen._form_layout(desk.window.size).close.center)  # noqa: E731
    panels = (("High scores", HighScores), ("Replays", Replays), ("How to play", Help), ("Settings", SettingsPanel))
    visit(desk, *[(lambda label=label: desk.click_on(label), kind, close) for label, kind in (*panels, ("Credits", Credits))])
    desk.click_on("Levels")
    desk.click_on("Make a new level")
    assert isinstance(desk.screen, Editor)
    desk.click_on("Leave")
    desk.click_on("Save and leave")
    assert isinstance(desk.screen, LevelSelect)
    desk.click_on("My level")
    desk.click_on("Edit")
    assert isinstance(desk.screen, Editor)
    desk.click_on("Leave")
    desk.click_on(classic()[0].name)
    assert isinstance(desk.screen, PlayScreen)

    def button(index):
        desk.click(play_buttons.button_boxes(desk.screen._layout(desk.window.size))[index].center)

    kinds = (Menu, Help, SettingsPanel)
    visit(desk, *[(lambda index=index: button(index), kind, close) for index, kind in enumerate(kinds)])
    lose(desk, lambda: desk.click((300, 300)))
    desk.click((5, 5))  # the figures need not be waited for
    desk.click_on("Enter your name")
    for letter in "MO":
        desk.click_on(letter)
    desk.click_on("Done")
    assert [entry.name for entry in Storage(tmp_path).scores.value.entries] == ["MO"]
    desk.click_on("Main menu")
    desk.click_on("Replays")
    (game,) = desk.shared.storage.games.listed()
    desk.click_on(game.date)
    desk.click_on("Rename")
    desk.click_on("Z")
    desk.click_on("Done")
    desk.click_on("Z")
    desk.click_on("Delete")
    desk.click_on("Keep it")
    desk.click_on("Z")
    desk.click_on("Watch")
    assert isinstance(desk.screen, Watch)
    desk.click(play_buttons.button_boxes(desk.screen._layout(desk.window.size), play_buttons.WATCHING)[0].center)
    desk.click_on("Z")
    desk.click_on("Delete")
    desk.click_on("Delete")
    assert Storage(tmp_path).games.listed() == []
    close()
    desk.click_on("Quit")
    assert desk.screen is None


def test_by_gamepad_alone(pad_desk, tmp_path):
    """The same with a gamepad: a game lost, a name entered letter by letter, the score, its replay; out."""
    desk = pad_desk
    esc = lambda: desk.press(pygame.K_ESCAPE)  # noqa: E731
    panels = (("High scores", HighScores), ("Replays", Replays), ("How to play", Help), ("Settings", SettingsPanel))
    visit(desk, *[(lambda label=label: desk.choose(label), kind, esc) for label, kind in (*panels, ("Credits", Credits))])
    desk.choose("Levels")
    desk.choose(classic()[0].name)
    assert isinstance(desk.screen, PlayScreen)
    desk.press(pygame.K_p)
    visit(desk, (lambda: desk.choose("Settings"), SettingsPanel, esc))
    desk.choose("Continue")
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    assert isinstance(desk.screen, ResultsPanel)
    desk.press(pygame.K_RETURN)  # the figures need not be waited for
    desk.choose("Enter your name")
    for letter in ("M", "O", "Done"):
        desk.choose(letter)
    (entry,) = Storage(tmp_path).scores.value.entries
    assert entry.name == "MO"
    desk.choose("1    MO")
    assert isinstance(desk.screen, Watch)
    esc()
    desk.choose("Main menu")
    esc()
    desk.choose("Quit")
    assert desk.screen is None
