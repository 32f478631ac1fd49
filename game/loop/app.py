"""The only loop: events in, ticks due, one picture out."""

import gc
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pygame

from game.chosen_physics import SWEPT, ChosenPhysics
from game.input.events import keyboard_state, system_layout
from game.input.key_names import use_layout
from game.input.players import Players
from game.input.signals import KeyboardState
from game.lab.kit.second_engine import Engine
from game.lab.registry import scenes
from game.lab.session import session
from game.lab.session.share import parsed
from game.language import system_prefers
from game.levels import Level, built_in
from game.levels.own import own_levels
from game.loop.frame_pace import FramePace
from game.loop.window_events import answered_events, toggle_full_screen
from game.overlay import toast, toast_drawing
from game.replays.file import Recording
from game.replays.playback import Playback
from game.rules import Ruleset
from game.screens.app_state import AppState, Recorder
from game.screens.base import CachedScreen, Screen
from game.screens.difficulty_names import ruleset_of
from game.screens.editors import OpenEditors
from game.screens.menus.level_select import LevelSelect
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.watch import Watch
from game.second_opinion import Compare
from game.settings.file import SettingsFile
from game.sound.mixer import Audio
from game.storage.storage import Storage
from game.storage.window import WindowBox
from game.student.functions_file import FunctionsFile
from game.system import window as display
from game.system.display_lost import on_display_lost
from game.system.ending import deferred, pending
from game.system.errors import DisplayLostError

LOST = "the display is gone"
_TITLE = "Polar Breakout"
_IDLE_RATE = 10
"""Frames per second while the window has no focus: nothing moves then."""
_STILL_RATE = 60
"""Frames per second, at most, of a screen that stands still."""


class Services(NamedTuple):
    """What the program that opens a window gives it; each may be missing.

    compare: asks another engine about a tick's contacts.
    engine: makes the engine that the lab compares with.
    settings: the file of the player's settings. storage: scores, progress and finished games.
    lost: told when the display is gone and the program is about to end without returning from here.
    functions: the player's own, for the lab to show beside ours.
    """

    compare: Compare | None = None
    engine: Callable[[], Engine] | None = None
    settings: SettingsFile | None = None
    storage: Storage | None = None
    lost: Callable[[], None] | None = None
    functions: FunctionsFile | None = None


NO_SERVICES = Services()


def play(
    levels: tuple[Level, ...],
    seed: int,
    services: Services = NO_SERVICES,
    *,
    recorder: Recorder | None = None,
    autopilot: bool = False,
    physics: ChosenPhysics = SWEPT,
    ruleset: Ruleset | None = None,
    players: Players = Players.ONE,
) -> int:
    """Open a window with the title, the first of the levels chosen, and play until it is closed; the exit code.

    seed: of the session, of which every game's is made. recorder: told every tick of every game played.
    autopilot: it plays, from the first serve on, without a title.
    physics: that the games are flown on. ruleset: of the games; None for the one chosen last. players: how many play.
    Raises EnvironmentMissingError without a display, DisplayLostError when it goes away.
    """
    catalogue = built_in() if levels[0] in built_in() else levels
    state = _state(catalogue, services, catalogue.index(levels[0]), seed)
    state.recorder, state.autopilot, state.physics, state.players = recorder, autopilot, physics, players
    state.ruleset = ruleset or state.ruleset
    editors = OpenEditors()
    state.own_levels, state.open_editor = own_levels, editors.opened
    try:
        return _shown(state, lambda: PlayScreen(state, levels) if autopilot else Title(state), services, Audio)
    finally:
        editors.keep_unsaved()


def watch(recording: Recording, services: Services = NO_SERVICES) -> int:
    """Open a window that shows a recorded game until it is closed; the exit code. Errors are those of `play`."""
    state = _state(tuple(recording.levels), services, 0, recording.seed)
    return _shown(state, lambda: Watch(state, Playback(recording)), services, Audio)


def lab(line: str | None, services: Services = NO_SERVICES, *, presents: bool = False) -> int:
    """Open a window with the lab until it is closed; the exit code. line: a share line, None for the first scene.

    presents: whether it begins full screen, for a lecture room.
    Raises BadInputError for a line that names no scene as it may stand. Other errors are those of `play`.
    """
    engine = None if services.engine is None else services.engine()
    opened = parsed(scenes()[0].name if line is None else line, engine)
    state = _state(built_in(), services, 0, 0)

    def first() -> Screen:
        from game.lab.window.screen import Lab  # noqa: PLC0415  # its widgets, only where they are needed

        return Lab(state, session.opened(opened), step=opened.step, presents=presents)

    return _shown(state, first, services, full_screen=presents)


def edit(path: Path, services: Services = NO_SERVICES) -> int:
    """Open a window with the editor on a level file until it is left; the exit code. Unsaved changes go into a file beside it.

    Raises BadInputError for a file that is no level. Other errors are those of `play`.
    """
    from game.editor.command import editing_session  # noqa: PLC0415  # only where it is needed
    from game.editor.file_watch import WatchedFile  # noqa: PLC0415

    editing_session(WatchedFile(path))  # says what is wrong with it before a window opens
    state, desk = _state(built_in(), services, 0, 0), OpenEditors()
    try:
        return _shown(state, lambda: desk.opened(state, lambda: None, path), services, Audio)
    finally:
        desk.keep_unsaved()


def _state(catalogue: tuple[Level, ...], services: Services, chosen: int, seed: int) -> AppState:
    """The state that a window begins with."""
    state = AppState(catalogue, chosen, seed, Title, compare=services.compare, settings_file=services.settings)
    state.open_lab, state.functions = _lab_opener(services.engine), services.functions
    state.open_levels = lambda state: LevelSelect(state, Title(state))
    if services.storage is not None:
        state.storage = services.storage
        state.tell_problem()
    state.ruleset = ruleset_of(state.storage.progress.value.last_difficulty)
    return state


def _lab_opener(engine: Callable[[], Engine] | None) -> Callable[[AppState, Screen], Screen]:
    """What opens the lab over a screen of the game."""

    def opened(state: AppState, under: Screen) -> Screen:
        from game.lab.window.screen import Lab  # noqa: PLC0415  # its widgets, only where they are needed

        other = None if engine is None else engine()
        return Lab(state, session.fresh(scenes()[0], other), under)

    return opened


def _shown(
    state: AppState,
    opened: Callable[[], Screen],
    services: Services,
    audio: Callable[[], Audio] | None = None,
    *,
    full_screen: bool = False,
) -> int:
    """Show screens in a window until the last one is left; the exit code.

    audio: opens the sound, where there is some. full_screen: whether the window begins as large as the desktop.
    """
    box = state.storage.window.value
    window = display.open_window(_TITLE, (box.width, box.height) if box.width else None, (box.left, box.top))
    use_layout(system_layout())
    if full_screen:
        toggle_full_screen(window, state)
    handler = on_display_lost(lambda: _save(state, services.lost))  # noqa: F841  # must live as long as the window
    with deferred():
        try:
            system_prefers([locale["language"] for locale in pygame.system.get_pref_locales()])
            state.devices.pads.listen()
            state.audio = None if audio is None else audio()
            state.change(state.settings if state.settings_file is None else state.settings_file.load())
            run(window, state, opened())
        finally:
            _keep_window(window, state)
            state.save_settings()
            if state.audio is not None:
                state.audio.close()
            state.devices.pads.close()
            pygame.quit()
    return 0


def _keep_window(window: pygame.Window, state: AppState) -> None:
    """Note where the window is, for the next session."""
    try:
        (left, top), (width, height) = window.position, window.size
    except pygame.error:  # the display is gone
        return
    if not state.full_screen:
        box = WindowBox(left=left, top=top, width=width, height=height)
        if box != state.storage.window.value:
            state.storage.window.update(lambda _: box)


def _save(state: AppState, lost: Callable[[], None] | None) -> None:
    """Save what can be saved before the program ends."""
    state.save_settings()
    if lost is not None:
        lost()


def run(window: pygame.Window, state: AppState, first: Screen) -> None:
    """Draw frame after frame until the last screen is left, the window closed, or a signal asks for an end."""
    gc.freeze()  # what was made until now stays: to search it for garbage again and again would cost whole frames
    pace, rate = FramePace(), display.refresh_rate()
    screen: Screen | None = first
    before = time.perf_counter()
    while screen is not None and not pending():
        now = time.perf_counter()
        screen = frame(window, state, screen, 0.0 if state.away else now - before)
        before = now
        pace.wait(_rate(screen, rate, away=state.away))


def _rate(screen: Screen | None, rate: int, *, away: bool) -> int:
    """Frames per second of a screen. rate: of the display. away: the player is in another window."""
    if away:
        return _IDLE_RATE
    if isinstance(screen, CachedScreen):
        return min(rate, int(getattr(screen, "rate", _STILL_RATE)))
    return rate


def frame(
    window: pygame.Window,
    state: AppState,
    screen: Screen,
    seconds: float,
    keyboard: Callable[[], KeyboardState] = keyboard_state,
) -> Screen | None:
    """One turn of the loop: the screen to go on with, None once the window is closed or the last screen left.

    keyboard: asked which keys are down, after the events: of too many, some are lost.
    """
    answered = answered_events(window, _surface(window).get_size(), state, screen)
    if answered is not None:
        answered = answered.answer(keyboard(), _surface(window).get_size())
    if answered is None:
        return None
    surface = _surface(window)
    following = answered.advance(seconds, surface.get_size())
    if following is not None:
        state.toast = toast.later(state.toast, seconds)
        _draw(window, state, following, surface)
        if state.wants_full_screen not in (None, state.full_screen):
            toggle_full_screen(window, state)
        state.wants_full_screen = None
    if state.audio is not None:
        state.audio.prepare()
    return following


def _draw(window: pygame.Window, state: AppState, screen: Screen, surface: pygame.Surface) -> None:
    """Show a screen, unless it is one that looks as it did in the frame before."""
    if isinstance(screen, CachedScreen) and _appearance(state, screen, surface) == state.shown:
        return
    screen.draw(surface)
    if state.toast is not None:
        toast_drawing.draw(state.words(state.canvas(surface)), state.toast)
    _flip(window)
    state.shown = _appearance(state, screen, surface) if isinstance(screen, CachedScreen) else None


def _appearance(state: AppState, screen: CachedScreen, surface: pygame.Surface) -> tuple[object, ...]:
    """All that the picture on the window depends on."""
    told = None if state.toast is None else (state.toast.text, state.toast.level)
    return screen, surface.get_size(), screen.appearance, told


def _surface(window: pygame.Window) -> pygame.Surface:
    """The window's surface; DisplayLostError where there is none any more."""
    try:
        return window.get_surface()
    except pygame.error as error:
        raise DisplayLostError(f"{LOST}: {error}") from None


def _flip(window: pygame.Window) -> None:
    """Show what was drawn; DisplayLostError where that is not possible any more."""
    try:
        window.flip()
    except pygame.error as error:
        raise DisplayLostError(f"{LOST}: {error}") from None
