"""Every screen of the game: its name, and what opens it."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from importlib.resources import files

from game.editor.command import NEW
from game.editor.fields import PanelPart
from game.editor.session import brushed, stroked, tinted
from game.editor.window.help import editor_help
from game.editor.window.screen import Editor
from game.input.key_choice import CaptureTarget
from game.input.keys import Action
from game.input.players import Players
from game.input.signals import Pressed
from game.input.view import SOLID
from game.language import grouped, tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.gallery.sample import SIZE, begun, cleared, last_life, later, lost, played, raced, watched, with_power_ups
from game.screens.menus.credits import Credits
from game.screens.menus.endless import endless_menu
from game.screens.menus.help.panel import Help
from game.screens.menus.high_scores import HighScores
from game.screens.menus.level_select import LevelSelect
from game.screens.menus.replays import Replays
from game.screens.menus.settings.key_capture import KeyCapture
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.menus.settings.rows import PARTS
from game.screens.title import Title
from game.screens.toolkit.panel import Panel
from game.screens.toolkit.text_entry import TextEntry
from game.storage.storage import Storage

Opener = Callable[[AppState], Screen]
_EDITED = "20-orbit.toml"
"""The level that the editor shows."""
_UNSOUND = ("radius = 9.2", "radius = 4.2")
"""Of the editor's new level: what is replaced, so that its paddles turn among the bricks."""


def every_screen() -> Iterator[tuple[str, Opener]]:
    """Every screen, those that belong together one after the other."""
    yield from _around_the_game()
    yield from _games()
    yield from _results_of_games()
    for index in range(5):
        yield f"help-{index + 1}", _tab_opener(Help, index)
    for index in range(len(PARTS)):
        yield f"settings-{index + 1}", _tab_opener(SettingsPanel, index)
    yield "settings-key", _key_capture
    yield from _editors()


def _editors() -> Iterator[tuple[str, Opener]]:
    """The editor: every part of its controls, a level with an error, its help."""
    for part in PanelPart:
        yield f"editor-{part.name.lower()}", partial(_editor, part=part)
    yield "editor-problem", partial(_editor, text=NEW.replace(*_UNSOUND))
    for index in range(3):
        yield f"editor-help-{index + 1}", partial(_editor_help, index=index)


def _around_the_game() -> Iterator[tuple[str, Opener]]:
    """What is reached from the title."""
    yield "title", lambda state: later(Title(state), 5.0)
    yield "title-asks", lambda state: Title(state).back() or Title(state)
    yield "levels", lambda state: LevelSelect(state, Title(state))
    yield "levels-first", lambda state: LevelSelect(_new_player(state), Title(state))
    yield "levels-own", lambda state: _moved(LevelSelect(_new_player(state), Title(state)), Action.UP, 2)
    yield "endless", lambda state: endless_menu(state, Title(state))
    yield "scores", lambda state: HighScores(state, Title(state), state.storage.scores.value.entries[1])
    yield "scores-none", lambda state: HighScores(_new_player(state), Title(state))
    yield "replays", lambda state: Replays(state, Title(state))
    yield "replays-one", lambda state: _pressed(_moved(Replays(state, Title(state)), Action.DOWN, 1), Action.CONFIRM)
    yield "replays-none", lambda state: Replays(_new_player(state), Title(state))
    yield "replay", watched
    yield "credits", lambda state: Credits(state, Title(state))


def _games() -> Iterator[tuple[str, Opener]]:
    """Games, and what is opened over one."""
    yield "entry", lambda state: begun(state, 0.55)
    yield "first-game", lambda state: begun(_new_player(state), 2.0, 0)
    yield "serve", lambda state: begun(state, 2.0)
    yield "play", played
    yield "play-solid", lambda state: played(_tipped(state))
    yield "power-ups", with_power_ups
    yield "power-ups-solid", lambda state: with_power_ups(_tipped(state))
    yield "last-life", last_life
    yield "captions", _captioned
    yield "ghost", raced
    yield "together", lambda state: played(_with(state, Players.TOGETHER))
    yield "versus", lambda state: played(_with(state, Players.VERSUS))
    yield "pause", lambda state: _pressed(played(state), Action.PAUSE)
    yield "restart", lambda state: _pressed(played(state), Action.RESTART)


def _results_of_games() -> Iterator[tuple[str, Opener]]:
    """What is shown after a level and after a game."""
    yield "level-cleared", lambda state: cleared(state, is_last=False)
    yield "game-over", lost
    yield "game-won", lambda state: cleared(state, is_last=True)
    yield "name-entry", lambda state: TextEntry(state, played(state), _high_score(), "ADA", 16, lambda _: None)


def _tab_opener(kind: Callable[[AppState, Screen], Panel], index: int) -> Opener:
    """Opens a part of a panel over the title."""

    def opened(state: AppState) -> Screen:
        panel = kind(state, Title(state))
        panel.open_tab(index)
        return panel

    return opened


def _key_capture(state: AppState) -> Screen:
    """The question for a key."""
    wanted = CaptureTarget(Action.LEFT, tr("Left, clockwise"), 0, of_pad=False)
    return KeyCapture(state, _tab_opener(SettingsPanel, 3)(state), wanted)


def _pressed(screen: Screen, action: Action) -> Screen:
    """What a key leads to."""
    return screen.answer(Pressed(action), SIZE) or screen


def _moved(screen: Screen, action: Action, times: int) -> Screen:
    """A panel whose focus was moved."""
    screen.advance(0.0, SIZE)
    for _ in range(times):
        screen = _pressed(screen, action)
    return screen


def _tipped(state: AppState) -> AppState:
    """Seen in 3D."""
    return replace(state, view=SOLID)


def _with(state: AppState, players: Players) -> AppState:
    """Two on one machine."""
    return replace(state, players=players)


def _new_player(state: AppState) -> AppState:
    """Somebody who has not played yet."""
    return replace(state, storage=Storage(None))


def _captioned(state: AppState) -> Screen:
    """The captions of a game's sounds."""
    state.change(state.settings._replace(captions=True))
    return played(state)


def _high_score() -> str:
    """The title of the name's entry."""
    return tr("A high score: {score}").format(score=grouped(12_340))


def _editor(state: AppState, text: str = "", part: PanelPart = PanelPart.BRICKS) -> Screen:
    """The editor with a level of the player's and some changes. text: of the level; "" for one like those of the campaign."""
    folder = state.storage.games.folder
    if folder is None or state.open_editor is None:
        return Title(state)
    file = folder.parent / "my-level.toml"
    file.write_text(text or files("game").joinpath("levels", "campaign", _EDITED).read_text("utf-8"), encoding="utf-8")
    editor = state.open_editor(state, lambda: None, file)
    if isinstance(editor, Editor) and not text:
        editor.session = stroked(tinted(brushed(editor.session, 2), 4), 2, 9)
        editor.side(SIZE).open_part(part)
    return editor


def _editor_help(state: AppState, index: int) -> Screen:
    """A part of the editor's help."""
    panel = editor_help(state, _editor(state))
    panel.open_tab(index)
    return panel
