"""What all screens share, with made-up scores and games; and games played until there is something to be seen."""

from pathlib import Path

import msgspec

from game.autopilot import Autopilot
from game.headless import autopilot_game
from game.input.keys import Action
from game.input.signals import Pressed
from game.level_format.specs import DROP_KINDS, DropSpec, RingSpec
from game.levels import Level, built_in
from game.replays.file import Recorder
from game.replays.playback import Playback
from game.rules import Ruleset, new_game, tick
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.editors import OpenEditors
from game.screens.menus.level_select import LevelSelect
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.watch import Watch
from game.settings.values import Settings
from game.storage.games import StoredGame
from game.storage.progress import Best
from game.storage.scores import Score
from game.storage.storage import Storage

FRAME = 1.0 / 60.0
"""Seconds from one picture to the next."""
SIZE = (1280, 800)
"""Pixels of the surface on which the games before a picture are played; they do not depend on it."""
_PLAY_SECONDS, _WATCH_TICKS = 8.0, 1500
_SERVED_SECONDS, _COUNTED_SECONDS = 3.0, 5.0
"""From serve to serve of a player who does nothing else, and from the end of a game until its results have counted up."""
_LOST_SECONDS, _SMALL_PADDLE = 6.0, 2.0
"""For which a ball stays in play that no paddle meets; and half the angle of such paddles, degrees."""
_LEVEL = 3
"""Index of the level that most games show."""


def sample_state(folder: Path, settings: Settings | None = None) -> AppState:
    """What all screens share, with made-up scores and games, which are kept in a folder."""
    state = AppState(built_in(), 0, 7, Title, storage=Storage(folder), ruleset=Ruleset())
    state.change(settings or Settings())
    state.open_levels = lambda state: LevelSelect(state, Title(state))
    state.open_editor = OpenEditors().opened
    replays = folder / "replays"
    replays.mkdir(exist_ok=True)
    names, done = ("Ada", "Grace", "Emmy", "Sofia", "Hypatia"), max(len(state.catalogue) * 2 // 3, 1)
    for index, level in enumerate(state.catalogue[:done]):
        best = Best(level.name, "normal", 1500 + 431 * index, index % 4, 240 * (41 + 13 * index))
        state.storage.level_done(best)
    for index, name in enumerate(names):
        last = state.catalogue[min(done + 1 - index, len(state.catalogue) - 1)].name
        points, date = 21_470 - 3170 * index, f"2026-11-{25 - index}"
        if len(state.storage.scores.value.entries) < len(names):
            state.storage.enter(Score(name, points, "normal", last=last, date=date))
        file, title = f"{date} 20-1{index}-00.polar", "The one with the long rally" if index == 1 else ""
        (replays / file).touch()
        game = StoredGame(
            file, title, index == 1, points, 240 * (95 + 31 * index), "First Wall", last, date=f"{date} 20:1{index}"
        )
        state.storage.games.change(game)
    return state


def later(screen: Screen, seconds: float) -> Screen:
    """A screen some time later."""
    for _ in range(round(seconds / FRAME)):
        screen = screen.advance(FRAME, SIZE) or screen
    return screen


def begun(state: AppState, seconds: float, level: int = _LEVEL) -> PlayScreen:
    """A player who does nothing, some time after a level has begun. level: its index."""
    play = PlayScreen(state, state.catalogue[level:])
    later(play, seconds)
    return play


def played(state: AppState) -> Screen:
    """The autopilot in the middle of a level."""
    state.autopilot = True
    return later(PlayScreen(state, state.catalogue[_LEVEL:]), _PLAY_SECONDS)


def with_power_ups(state: AppState) -> Screen:
    """The autopilot where every brick leaves a power-up."""
    state.autopilot = True
    drops = DropSpec(1.0, [*DROP_KINDS])
    levels = tuple([msgspec.structs.replace(level, drops=drops) for level in state.catalogue[_LEVEL:]])
    return later(PlayScreen(state, levels), _PLAY_SECONDS)


def last_life(state: AppState) -> Screen:
    """A player who does nothing but serve, on the last life."""
    screen: Screen = PlayScreen(state, _hard_levels(state))
    for _ in range(2):
        screen.answer(Pressed(Action.SERVE), SIZE)
        screen = later(screen, _LOST_SECONDS)
    return screen


def _hard_levels(state: AppState) -> tuple[Level, ...]:
    """The level that most games show, with paddles that meet no ball."""
    level = state.catalogue[_LEVEL]
    paddles = msgspec.structs.replace(level.paddles, half_angle=_SMALL_PADDLE)
    return (msgspec.structs.replace(level, paddles=paddles, drops=DropSpec(0.0)),)


def cleared(state: AppState, *, is_last: bool) -> Screen:
    """What is shown after a level that the first hit clears, or after the game where it is the last one."""
    games, level = state.storage.games, state.catalogue[_LEVEL]
    brick = RingSpec(radius=3.0, half_width=0.3, half_angle=170.0, count=1, layers=1)
    one_brick = msgspec.structs.replace(level, rings=[brick], drops=DropSpec(0.0))
    levels = (one_brick, *state.catalogue[_LEVEL + 1 :])
    state.recorder = games
    return _ended(state, levels[:1] if is_last else levels)


def lost(state: AppState) -> Screen:
    """What is shown after a game of a player who does nothing but serve."""
    state.recorder = state.storage.games
    return _ended(state, _hard_levels(state))


def _ended(state: AppState, levels: tuple[Level, ...]) -> Screen:
    """The results of a game in which the player does nothing but serve, once they have counted up."""
    play = PlayScreen(state, levels)
    screen: Screen = play
    while screen is play:
        play.answer(Pressed(Action.SERVE), SIZE)
        screen = later(play, _SERVED_SECONDS)
    return later(screen, _COUNTED_SECONDS)


def raced(state: AppState) -> Screen:
    """A game beside the ghost of the best run, which the autopilot has played."""
    games, levels = state.storage.games, state.catalogue[_LEVEL : _LEVEL + 1]
    game, pilot = new_game(levels, 4, state.ruleset), Autopilot()
    for _ in range(_WATCH_TICKS):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        games(controls, game)
    state.storage.level_done(Best(levels[0].name, "normal", 99_999))
    state.storage.game_done()
    state.recorder = games
    play = PlayScreen(state, levels)
    later(play, 0.5)
    play.answer(Pressed(Action.SERVE), SIZE)
    return later(play, 1.1)


def watched(state: AppState) -> Screen:
    """A recorded game of the autopilot."""
    levels = state.catalogue[_LEVEL:]
    recorder = Recorder(levels, 4)
    autopilot_game(levels, 4, _WATCH_TICKS, recorder)
    return later(Watch(state, Playback(recorder.recording())), 4.0)
