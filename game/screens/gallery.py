"""A picture of every screen, filled with made-up scores, to be looked at: nothing of the player's is read or written."""

import io
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import pygame

from game.autopilot import Autopilot
from game.headless import autopilot_game
from game.input.keys import Action
from game.input.players import Players
from game.input.signals import Clicked, Moved, Pressed
from game.kept.games import KeptGame
from game.kept.progress import Best
from game.kept.scores import Score
from game.kept.store import Kept
from game.levels import built_in
from game.replays.file import Recorder
from game.replays.playback import Playback
from game.rules import Ruleset, new_game, tick
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.credits import Credits
from game.screens.menus.endless import endless_menu
from game.screens.menus.help import Help
from game.screens.menus.high_scores import HighScores
from game.screens.menus.level_select import LevelSelect
from game.screens.menus.replays import Replays
from game.screens.menus.results import Figure, Results
from game.screens.menus.settings_panel import SettingsPanel
from game.screens.menus.settings_rows import PARTS
from game.screens.play import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.menu import Entry
from game.screens.toolkit.panel import Panel
from game.screens.toolkit.text_entry import TextEntry
from game.screens.watch import Watch
from game.system.files import write_whole
from game.system.quiet_stderr import quiet_libraries

_FRAME = 1.0 / 60.0
_TITLE_SECONDS, _PLAY_SECONDS, _WATCH_TICKS = 5.0, 8.0, 1500


def save_pictures(folder: Path, size: tuple[int, int], colours: str = "dark", only: str = "") -> Iterator[Path]:
    """Draw the screens into PNG files, one after the other: their paths. size: pixels. only: a part of the names wanted."""
    with quiet_libraries():
        pygame.display.init()
    try:
        with TemporaryDirectory() as kept:
            for name, opened in _screens():
                if only in name:
                    yield _saved(folder / f"{name}.png", opened(sample_state(Path(kept), colours)), size)
    finally:
        pygame.quit()


def _saved(path: Path, screen: Screen, size: tuple[int, int]) -> Path:
    """One screen's picture."""
    surface = pygame.Surface(size, 0, 32)
    for _ in range(2 * len(built_in())):  # the levels' pictures come one by one
        screen = screen.advance(_FRAME, size) or screen
        if isinstance(screen, LevelSelect):
            screen.draw(surface)
    screen.draw(surface)
    picture = io.BytesIO()
    pygame.image.save(surface, picture, "screen.png")
    write_whole(path, picture.getvalue())
    return path


def sample_state(folder: Path, colours: str = "dark") -> AppState:
    """What all screens share, with made-up scores and games, which are kept in a folder."""
    state = AppState(built_in(), 0, 7, Title, kept=Kept(folder), ruleset=Ruleset())
    state.settings = state.settings._replace(colours=colours)
    replays = folder / "replays"
    replays.mkdir(exist_ok=True)
    names, done = ("Ada", "Grace", "Emmy", "Sofia", "Hypatia"), max(len(state.catalogue) * 2 // 3, 1)
    for index, level in enumerate(state.catalogue[:done]):
        best = Best(level.name, "normal", 1500 + 431 * index, index % 4, 240 * (41 + 13 * index))
        state.kept.level_done(best)
    for index, name in enumerate(names):
        last = state.catalogue[min(done + 1 - index, len(state.catalogue) - 1)].name
        points, date = 21_470 - 3170 * index, f"2026-11-{25 - index}"
        if len(state.kept.scores.value.entries) < len(names):
            state.kept.enter(Score(name, points, "normal", last=last, date=date))
        file, title = f"{date} 20-1{index}-00.polar", "The one with the long rally" if index == 1 else ""
        write_whole(replays / file, b"")
        game = KeptGame(
            file, title, index == 1, points, 240 * (95 + 31 * index), "First Wall", last, date=f"{date} 20:1{index}"
        )
        state.kept.games.change(game)
    return state


def _screens() -> Iterator[tuple[str, Callable[[AppState], Screen]]]:
    """Every screen: its name, and what opens it."""
    yield "title", lambda state: _later(Title(state), _TITLE_SECONDS)
    yield "title-asks", lambda state: Title(state).back() or Title(state)
    yield "levels", lambda state: LevelSelect(state, Title(state))
    yield "play", _played
    yield "ghost", _raced
    yield "versus", _versus
    yield "endless", lambda state: endless_menu(state, Title(state))
    yield "pause", lambda state: _clicked(_played(state), 0)
    yield "level-cleared", lambda state: _results(state, "Level cleared", "A")
    yield "game-over", lambda state: _results(state, "Game over", "")
    yield "name-entry", lambda state: TextEntry(state, _played(state), "A high score: 12,340", "ADA", 16, lambda _: None)
    yield "scores", lambda state: HighScores(state, Title(state), state.kept.scores.value.entries[1])
    yield "replays", lambda state: Replays(state, Title(state))
    yield "replay", _watched
    yield "credits", lambda state: Credits(state, Title(state))
    for index in range(5):
        yield f"help-{index + 1}", _tab_opener(Help, index)
    for index in range(len(PARTS)):
        yield f"settings-{index + 1}", _tab_opener(SettingsPanel, index)


def _tab_opener(kind: Callable[[AppState, Screen], Panel], index: int) -> Callable[[AppState], Screen]:
    """Opens a part of a panel over the title."""

    def opened(state: AppState) -> Screen:
        panel = kind(state, Title(state))
        panel.open_tab(index)
        return panel

    return opened


def _later(screen: Screen, seconds: float, size: tuple[int, int] = (1280, 800)) -> Screen:
    """A screen some time later."""
    for _ in range(round(seconds / _FRAME)):
        screen = screen.advance(_FRAME, size) or screen
    return screen


def _played(state: AppState) -> Screen:
    """The autopilot in the middle of a level."""
    state.autopilot = True
    return _later(PlayScreen(state, state.catalogue[3:]), _PLAY_SECONDS)


def _versus(state: AppState) -> Screen:
    """Two against each other."""
    state.players = Players.VERSUS
    return _played(state)


def _raced(state: AppState) -> Screen:
    """A game beside the ghost of the best run, which the autopilot has played."""
    games, levels = state.kept.games, state.catalogue[3:4]
    game, pilot = new_game(levels, 4, state.ruleset), Autopilot()
    for _ in range(_WATCH_TICKS):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        games(controls, game)
    state.kept.level_done(Best(levels[0].name, "normal", 99_999))
    state.kept.game_done()
    state.recorder = games
    play = PlayScreen(state, levels)
    _later(play, 0.5)
    play.answer(Pressed(Action.SERVE), (1280, 800))
    return _later(play, 1.1)


def _clicked(screen: Screen, _index: int) -> Screen:
    """What the first button beside the arena opens."""
    size = (1280, 800)
    pixel = complex(size[0] - 30, size[1] / 2 - 54)
    return (screen.answer(Moved(pixel, held=False), size) and screen.answer(Clicked(pixel), size)) or screen


def _results(state: AppState, title: str, rank: str) -> Screen:
    """Results that have counted up."""
    play = _played(state)
    figures = (
        Figure("Points", 3420, best=True),
        Figure("Time", 12345, lambda ticks: f"{ticks / 240:.1f} s"),
        Figure("Best combo", 11),
        Figure("Balls lost", 1),
        Figure("Score so far", 9870),
    )
    entries = (Entry("Next: Towers", lambda: play), Entry("All levels", lambda: play))
    return _later(Results(state, play, title, "Carousel", figures, entries, rank), 5.0)


def _watched(state: AppState) -> Screen:
    """A recorded game of the autopilot."""
    levels = state.catalogue[3:]
    recorder = Recorder(levels, 4)
    autopilot_game(levels, 4, _WATCH_TICKS, recorder)
    return _later(Watch(state, Playback(recorder.recording())), 4.0)
