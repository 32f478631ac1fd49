"""Whole sessions: from the title through a game, its results, the scores and a replay, and out; by keys, mouse, gamepad."""

import msgspec
import pygame
import pytest

from game.autopilot import Autopilot
from game.editor import command
from game.editor.window.layout import editor_layout
from game.editor.window.screen import Editor
from game.generated import sequence
from game.input.actions import OwnKeys
from game.input.keys import KEYS, Action
from game.input.players import Players
from game.kept import games as kept_games
from game.kept.progress import Best
from game.kept.scores import ENDLESS, objection
from game.kept.store import Kept
from game.levels import classic
from game.own_levels import own_levels
from game.replays.file import load
from game.replays.verify import verified
from game.rules import Phase, Ruleset, new_game, paddle_rings, tick
from game.screens import ghost, play_buttons
from game.screens.editors import OpenEditors
from game.screens.gallery.sample import sample_state
from game.screens.menus.credits import Credits
from game.screens.menus.endless import seed_of
from game.screens.menus.help import Help
from game.screens.menus.high_scores import HighScores
from game.screens.menus.key_capture import KeyCapture
from game.screens.menus.level_select import LevelSelect, next_level
from game.screens.menus.replays import Replays
from game.screens.menus.results import Results
from game.screens.menus.settings_panel import SettingsPanel
from game.screens.play import PlayScreen
from game.screens.play_record import record_name
from game.screens.title import Title
from game.screens.toolkit.menu import Menu
from game.screens.toolkit.text_entry import TextEntry
from game.screens.watch import Watch
from physics import direction
from tests.support.dummy_window import FRAME, Desk, shared
from tests.support.pad_desk import PadDesk
from tests.support.virtual_pad import library


@pytest.fixture
def state(tmp_path, monkeypatch):
    """What the app begins with, and a folder for what it keeps."""
    monkeypatch.setattr(kept_games, "_SHORTEST", 0.1)
    made = shared()
    made.kept, made.ruleset = Kept(tmp_path), Ruleset()
    made.recorder, made.open_editor = made.kept.games, OpenEditors().opened
    monkeypatch.setattr(command, "own_levels_folder", lambda: tmp_path / "levels")
    made.own_levels = lambda: own_levels(tmp_path / "levels")
    return made


@pytest.fixture
def desk(state):
    """The app at its title."""
    found = Desk(state, Title(state), (640, 400))
    found.wait(FRAME)
    yield found
    found.close()


@pytest.fixture
def pad_desk(state):
    """The app at its title, with a gamepad alone."""
    if library() is None:
        pytest.skip("no SDL library to plug a virtual gamepad into")
    found = PadDesk(state, Title(state), (320, 200))
    yield found
    found.close()


def lose(desk, serve):
    """Let every ball go, but for what hits a brick on its way."""
    for _ in range(3000):
        if not isinstance(desk.screen, PlayScreen):
            return
        if desk.screen._ticked.game.phase == Phase.SERVING:
            serve()
        desk.screen._untouched = 10**6  # the ball may be given up
        if desk.screen._ticked.game.score and desk.screen._ticked.game.phase == Phase.PLAYING:
            desk.press(pygame.K_g)
        desk.wait(0.1)
    raise AssertionError("the game does not end")


def visit(desk, *expected):
    """The screens that are opened by functions, one after the other, each led back from by another."""
    for opens, kind, leaves in expected:
        before = desk.screen
        opens()
        assert isinstance(desk.screen, kind)
        leaves()
        assert desk.screen is before


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
    assert isinstance(desk.screen, Results)
    score = desk.screen._under._ticked.game.score
    desk.press(pygame.K_RETURN)  # the figures need not be waited for
    desk.choose("Enter your name")
    assert isinstance(desk.screen, TextEntry)
    desk.type("Mo")
    desk.choose("Done")
    assert isinstance(desk.screen, HighScores)
    (entry,) = Kept(tmp_path).scores.value.entries
    assert (entry.name, entry.score, entry.difficulty) == ("Mo", score, "normal")
    desk.choose("1    Mo")
    assert isinstance(desk.screen, Watch)
    desk.press(pygame.K_END, pygame.K_ESCAPE)
    assert isinstance(desk.screen, HighScores)
    desk.choose("Title")
    assert isinstance(desk.screen, Title)
    desk.press(pygame.K_ESCAPE)
    desk.choose("Quit")
    assert desk.screen is None
    recording = load(tmp_path / "replays" / entry.replay)
    assert verified(recording).game.score == score


def test_by_mouse_alone(desk, tmp_path):
    """The same without a key: what a key opens has a button, and every panel has a cross."""
    close = lambda: desk.click(desk.screen._laid(desk.window.size).close.center)  # noqa: E731
    panels = (("High scores", HighScores), ("Replays", Replays), ("How to play", Help), ("Settings", SettingsPanel))
    visit(desk, *[(lambda label=label: desk.click_on(label), kind, close) for label, kind in (*panels, ("Credits", Credits))])
    desk.click_on("Levels")
    desk.click_on("Make a new level")
    assert isinstance(desk.screen, Editor)
    buttons = editor_layout(desk.window.size, desk.screen.session).buttons
    desk.click(next(box.center for button, box in buttons if button.name == "leave"))
    desk.click_on("Save and leave")
    assert isinstance(desk.screen, LevelSelect)
    desk.click_on("My level")
    desk.click_on("Edit")
    assert isinstance(desk.screen, Editor)
    desk.click(next(box.center for button, box in buttons if button.name == "leave"))
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
    assert [entry.name for entry in Kept(tmp_path).scores.value.entries] == ["MO"]
    desk.click_on("Title")
    desk.click_on("Replays")
    (game,) = desk.shared.kept.games.listed()
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
    assert Kept(tmp_path).games.listed() == []
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
    desk.choose("Go on")
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    assert isinstance(desk.screen, Results)
    desk.press(pygame.K_RETURN)  # the figures need not be waited for
    desk.choose("Enter your name")
    for letter in ("M", "O", "Done"):
        desk.choose(letter)
    (entry,) = Kept(tmp_path).scores.value.entries
    assert entry.name == "MO"
    desk.choose("1    MO")
    assert isinstance(desk.screen, Watch)
    esc()
    desk.choose("Title")
    esc()
    desk.choose("Quit")
    assert desk.screen is None


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
    spots = desk.screen._laid(desk.window.size).spots
    row = next(spot.row for spot in spots if [cell[0] for cell in getattr(spot.item, "cells", ())] == ["Give up a ball"])
    while desk.screen._focus.row != row:
        desk.press(pygame.K_DOWN)
    desk.press(pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_RETURN)
    assert isinstance(desk.screen, KeyCapture)
    desk.press(pygame.K_COMMA)
    assert KEYS.binding(Action.GIVE_UP).buttons == (pygame.CONTROLLER_BUTTON_LEFTSHOULDER,)
    desk.choose("Every key and button as at first")
    assert KEYS.binding(Action.GIVE_UP).buttons == (pygame.CONTROLLER_BUTTON_X,)
    desk.press(pygame.K_ESCAPE)
    for label in ("Endless", "Levels of a number", "4", "Done"):
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
    desk.choose("Go on")
    assert isinstance(desk.screen, PlayScreen)


def test_a_gamepad_alone_keeps_names_and_deletes_a_game(pad_desk, tmp_path):
    """A replay is renamed, watched tick by tick, and deleted after the question."""
    desk = pad_desk
    desk.press(pygame.K_RETURN, pygame.K_SPACE)
    desk.wait(0.2)
    desk.press(pygame.K_p)
    desk.choose("Title")
    desk.shared.kept.game_done()
    desk.choose("Replays")
    (game,) = desk.shared.kept.games.listed()
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
    assert Kept(tmp_path).games.listed() == []


def with_one_brick(game):
    """A game in play with one layer of one brick left, which the ball flies to."""
    ball, wall = game.arena.balls[0], game.arena.rings[1]
    path = [ball.position + ball.velocity * step / 100.0 for step in range(300)]
    touched = next(point for point in path if abs(point) < wall.outer_radius)
    slot = min(range(wall.count), key=lambda slot: abs(wall.radius * direction(wall.angle(slot)) - touched))
    layers = [tuple([0] * len(ring)) for ring in game.arena.layers]
    layers[0], layers[-1] = game.arena.layers[0], game.arena.layers[-1]
    layers[1] = tuple([int(number == slot) for number in range(wall.count)])
    return game._replace(arena=game.arena._replace(layers=tuple(layers)), flight=None)


def test_a_cleared_level_shows_its_results_and_opens_the_next(desk, tmp_path):
    """Its rank and score are kept at once, the next level is open, and Enter there goes on with the same game."""
    desk.press(pygame.K_RETURN)
    play = desk.screen
    desk.press(pygame.K_SPACE)
    play._ticked = play._ticked._replace(game=with_one_brick(play._ticked.game))
    desk.wait(3.0)
    assert isinstance(desk.screen, Results)
    kept = Kept(tmp_path)
    (best,) = kept.progress.value.bests
    result = play._ticked.game.results[-1]
    assert (best.level, best.difficulty, best.score, best.rank) == (classic()[0].name, "normal", result.score, result.rank)
    assert kept.progress.value.is_open(1, [level.name for level in classic()])
    desk.press(pygame.K_RETURN, pygame.K_RETURN)
    desk.wait(0.5)
    assert desk.screen is play
    assert play._ticked.game.number == 1


def test_the_best_run_of_a_level_is_raced_as_a_ghost(desk, monkeypatch):
    """Once the player serves, the ghost stands where its recording does, tick by tick from its own first serve."""
    levels, kept = classic()[1:3], desk.shared.kept
    recorded, pilot, game = [], Autopilot(), new_game(classic()[1:3], 5, Ruleset())
    for _ in range(700):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        recorded.append(game)
        kept.games(controls, game)
    kept.level_done(Best(levels[0].name, "normal", 5))
    kept.game_done()
    served = next(number for number, game in enumerate(recorded) if game.phase == Phase.PLAYING)
    monkeypatch.setattr(ghost, "_BUDGET", 60.0)
    desk.screen = PlayScreen(desk.shared, levels)
    desk.wait(0.3)
    assert desk.screen._record.ghost.game is None
    desk.press(pygame.K_SPACE)
    desk.wait(0.4)
    ticks = desk.screen._ticked.game.phase_tick
    assert desk.screen._record.ghost.game.arena == recorded[served + ticks + 1].arena
    plain = pygame.image.tobytes(desk.window.get_surface(), "RGB")
    desk.screen._record.ghost = None
    desk.screen.draw(desk.window.get_surface())
    assert pygame.image.tobytes(desk.window.get_surface(), "RGB") != plain


def test_two_players_steer_the_same_paddles(desk):
    """With two players A and D are the second one's keys, the arrows stay the first one's; both are in the recording."""
    told = []
    desk.shared.recorder = lambda controls, _: told.append((controls.turn, controls.second_turn))
    desk.choose("Levels")
    desk.choose("Players")
    desk.choose(classic()[0].name)
    for key in (pygame.K_d, pygame.K_RIGHT, pygame.K_a):
        desk.hold(key)
        desk.wait(0.1)
    assert list(dict.fromkeys(told))[-3:] == [(0, 1), (1, 1), (1, -1)]
    desk.release(pygame.K_a)
    desk.wait(0.1)
    assert told[-1] == (1, 1)


def test_a_game_on_a_level_of_ones_own_makes_no_high_score(desk):
    """Anybody can make an easy level: it has a best of its own, under what is in it, and opens no level of the game."""
    own = msgspec.structs.replace(classic()[1], ground_radius=classic()[1].ground_radius + 0.5)
    desk.screen = PlayScreen(desk.shared, (own,))
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    assert "Enter your name" not in [entry.label for entry in desk.screen._entries]
    assert record_name(own) != own.name == record_name(classic()[1])


def test_two_players_against_each_other_have_a_paddle_each(desk):
    """The second keys of Left and Right turn the upper paddle alone; the results name the winner, no score is entered."""
    desk.choose("Levels")
    desk.choose("Players")
    desk.choose("Players")
    desk.choose(classic()[0].name)
    game = desk.screen._ticked.game
    assert game.ruleset.versus
    lower, upper = (game.arena.rings[ring].angle(0) for ring in paddle_rings(game))
    own = ((Action.RIGHT, (pygame.KSCAN_RIGHT, pygame.KSCAN_K)),)
    desk.shared.change(desk.shared.settings._replace(own_keys=OwnKeys(own)))
    desk.hold(pygame.K_k)
    desk.wait(0.2)
    desk.release(pygame.K_k)
    desk.shared.change(desk.shared.settings._replace(own_keys=OwnKeys()))
    game = desk.screen._ticked.game
    assert game.arena.rings[paddle_rings(game)[0]].angle(0) == lower
    assert game.arena.rings[paddle_rings(game)[1]].angle(0) != upper
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    desk.press(pygame.K_RETURN)
    sides = desk.screen._under._ticked.game.sides
    loser, verdicts = int(sides[1].lives == 0), ("Player 2 wins", "Player 1 wins")
    assert desk.screen._title == verdicts[loser]
    assert desk.screen._line.startswith(f"Player {loser + 1} has lost the last ball")
    assert [figure.said(figure.amount) for figure in desk.screen._figures[:2]] == [
        f"{side.score:,}  ({side.lives} {'life' if side.lives == 1 else 'lives'})" for side in sides
    ]
    assert "Enter your name" not in [entry.label for entry in desk.screen._entries]


def test_endless_levels_of_a_number_have_a_table_of_their_own(desk, tmp_path):
    """The number is entered with the small keyboard; its levels are those of anybody else; the score's replay proves it."""
    desk.choose("Endless")
    desk.choose("Levels of a number")
    for digit in "42":
        desk.click_on(digit)
    desk.choose("Done")
    assert isinstance(desk.screen, PlayScreen)
    assert desk.screen._ticked.game.levels == sequence(42)
    assert desk.screen._ticked.game.seed == 42
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    desk.press(pygame.K_RETURN)
    desk.choose("Enter your name")
    desk.choose("Done")
    (entry,) = Kept(tmp_path).scores.value.table(ENDLESS)
    assert "(42)" in entry.last
    assert objection(entry, tmp_path / "replays") is None
    assert Kept(tmp_path).progress.value.bests == []
    assert [seed_of(text) for text in ("007", "abc")] == [7, int.from_bytes(b"abc", "little")]


def test_the_title_shows_the_level_that_play_begins(tmp_path):
    """The autopilot plays what the player has reached, by the rules of the campaign."""
    state = sample_state(tmp_path)
    shown = Title(state)._demo._ticked.game
    assert 0 < next_level(state) < len(state.catalogue)
    assert shown.level == state.catalogue[next_level(state)]
    assert shown.ruleset.arcade
