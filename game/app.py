"""The only loop: events in, ticks due, one picture out."""

import gc
import time
from collections.abc import Callable

import pygame

from game.input.key_names import layout_changed
from game.input.keys import Action
from game.input.signals import FocusLost, KeyboardState, Pressed, Signal, keyboard_state, translated
from game.lab.kit.second_engine import Engine
from game.lab.registry import scenes
from game.lab.session import session
from game.lab.session.share import parsed
from game.levels import Level, built_in
from game.overlay import toast
from game.replays.file import Recording
from game.replays.playback import Playback
from game.screens.base import Listener, Recorder, Screen, Shared
from game.screens.play import Play
from game.screens.title import Title
from game.screens.watch import Watch
from game.second_opinion import Compare
from game.settings.file import SettingsFile
from game.settings.keys import changed
from game.sound.mixer import Audio
from game.system import window as display
from game.system.display_lost import on_display_lost
from game.system.ending import deferred, pending
from game.system.errors import DisplayLostError

_TITLE = "Polar Breakout"
LOST = "the display is gone"
_IDLE_RATE = 20
"""Pictures per second while nobody looks."""


def play(
    levels: tuple[Level, ...],
    seed: int,
    recorder: Recorder | None = None,
    *,
    autopilot: bool = False,
    compare: Compare | None = None,
    kept: SettingsFile | None = None,
    lost: Callable[[], None] | None = None,
    engine: Callable[[], Engine] | None = None,
) -> int:
    """Open a window with the title, the first of the levels chosen, and play until it is closed; the exit code.

    recorder: told every tick of every game played. autopilot: it plays, from the first serve on, without a title.
    compare: another engine to ask about contacts; engine: the lab's. kept: the player's settings.
    lost: told when the display is gone and the program is about to end, with no way back to here.
    Raises EnvironmentMissingError without a display, DisplayLostError when it goes away.
    """
    catalogue = built_in() if levels[0] in built_in() else levels
    lab = _lab_opener(engine)
    shared = Shared(
        catalogue, catalogue.index(levels[0]), seed, Title, recorder, autopilot, compare=compare, lab=lab, kept=kept
    )
    return _shown(shared, lambda: Play(shared, levels) if autopilot else Title(shared), lost, Audio)


def watch(
    recording: Recording,
    *,
    compare: Compare | None = None,
    engine: Callable[[], Engine] | None = None,
    kept: SettingsFile | None = None,
    lost: Callable[[], None] | None = None,
) -> int:
    """Open a window that shows a recorded game until it is closed; the exit code. Options and errors are those of `play`."""
    levels = tuple(recording.levels)
    shared = Shared(levels, 0, recording.seed, Title, compare=compare, kept=kept)
    shared.lab = _lab_opener(engine)
    return _shown(shared, lambda: Watch(shared, Playback(recording)), lost, Audio)


def lab(
    line: str | None,
    engine: Callable[[], Engine] | None = None,
    *,
    kept: SettingsFile | None = None,
    lost: Callable[[], None] | None = None,
) -> int:
    """Open a window with the lab until it is closed; the exit code. line: a share line, None for the first scene.

    Raises BadInputError for a line that names no scene as it may stand. Options and other errors are those of `play`.
    """
    opened = parsed(scenes()[0].name if line is None else line, None if engine is None else engine())
    shared = Shared(built_in(), 0, 0, Title, kept=kept)

    def first() -> Screen:
        from game.lab.window.screen import Lab  # noqa: PLC0415  # its widgets, only where they are needed

        return Lab(shared, session.opened(opened))

    return _shown(shared, first, lost)


def _lab_opener(engine: Callable[[], Engine] | None) -> Callable[[Shared, Screen], Screen]:
    """What opens the lab over a screen of the game."""

    def opened(shared: Shared, under: Screen) -> Screen:
        from game.lab.window.screen import Lab  # noqa: PLC0415  # its widgets, only where they are needed

        other = None if engine is None else engine()
        return Lab(shared, session.fresh(scenes()[0], other), under)

    return opened


def _shown(
    shared: Shared,
    opened: Callable[[], Screen],
    lost: Callable[[], None] | None,
    audio: Callable[[], Audio] | None = None,
) -> int:
    """Show screens in a window until the last one is left; the exit code. audio: opens the sound, where there is some."""
    window = display.open_window(_TITLE)
    handler = on_display_lost(lambda: _last_words(shared, lost))  # noqa: F841  # must live as long as the window
    with deferred():
        try:
            shared.audio = None if audio is None else audio()
            shared.change(shared.settings if shared.kept is None else shared.kept.load())
            run(window, shared, opened())
        finally:
            shared.keep()
            if shared.audio is not None:
                shared.audio.close()
            pygame.quit()
    return 0


def _last_words(shared: Shared, lost: Callable[[], None] | None) -> None:
    """Save what can be saved before the program ends."""
    shared.keep()
    if lost is not None:
        lost()


def run(window: pygame.Window, shared: Shared, first: Screen) -> None:
    """The loop; it ends with the last screen, or when a signal asks for an end."""
    gc.freeze()  # what was made until now stays: looking through it again and again would cost whole frames
    clock, rate = pygame.time.Clock(), display.refresh_rate()
    screen: Screen | None = first
    before = time.perf_counter()
    while screen is not None and not pending():
        now = time.perf_counter()
        screen = frame(window, shared, screen, now - before)
        before = now
        clock.tick(rate if window.focused else _IDLE_RATE)


def frame(
    window: pygame.Window,
    shared: Shared,
    screen: Screen,
    seconds: float,
    keyboard: Callable[[], KeyboardState] = keyboard_state,
) -> Screen | None:
    """One turn of the loop: the screen to go on with, None once the window is closed or the last screen left.

    keyboard: asked which keys are down, after the events: of too many, some are lost.
    """
    answered = _answered(window, shared, screen)
    if answered is not None:
        answered = answered.answer(keyboard(), _surface(window).get_size())
    if answered is None:
        return None
    surface = _surface(window)
    following = answered.advance(seconds, surface.get_size())
    if following is not None:
        following.draw(surface)
        shared.toast = toast.later(shared.toast, seconds)
        if shared.toast is not None:
            toast.draw(surface, shared.toast, shared.theme, shared.type)
        _flip(window)
    if shared.audio is not None:
        shared.audio.prepare()
    return following


def _surface(window: pygame.Window) -> pygame.Surface:
    """What to draw on; DisplayLostError where there is nothing any more."""
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


def _answered(window: pygame.Window, shared: Shared, screen: Screen) -> Screen | None:
    """The screen after all that the player did since the last frame; None once the window is closed or left."""
    size = _surface(window).get_size()
    for event in pygame.event.get():
        if event.type in (pygame.QUIT, pygame.WINDOWCLOSE):
            return None
        if event.type == pygame.KEYMAPCHANGED:
            layout_changed()
        following = _following(event, size, window, shared, screen)
        if following is None:
            return None
        screen = following
    return screen


def _following(
    event: pygame.Event, size: tuple[int, int], window: pygame.Window, shared: Shared, screen: Screen
) -> Screen | None:
    """The screen after one event. size: of the surface, pixels."""
    pixels_per_point = _pixels_per_point(window, size)
    signal = translated(event, pixels_per_point)
    if isinstance(screen, Listener):
        if isinstance(signal, Pressed) and signal.action is Action.FULL_SCREEN:
            _toggle_full_screen(window, shared)
            return screen
        return screen.hear(event, size, pixels_per_point)
    if signal is None or (not _means_speed(signal, screen) and _answered_here(signal, window, shared)):
        return screen
    if isinstance(signal, Pressed) and signal.action is Action.LAB and shared.lab is not None:
        left = screen.answer(FocusLost(), size)  # a game in play pauses
        return None if left is None else shared.lab(shared, left)
    return screen.answer(signal, size)


def _answered_here(signal: Signal, window: pygame.Window, shared: Shared) -> bool:
    """Whether the signal is one that means the same on every screen; if so it is obeyed."""
    match signal:
        case Pressed(Action.FULL_SCREEN):
            _toggle_full_screen(window, shared)
        case Pressed(Action.NORMALS):
            shared.normals = not shared.normals and shared.compare is not None
        case Pressed(action) if (now := changed(shared.settings, action)) is not None:
            shared.change(*now)
        case _:
            return False
    return True


def _means_speed(signal: Signal, screen: Screen) -> bool:
    """Whether the volume's keys change how fast a recording runs."""
    speeds = (Action.LESS, Action.MORE)
    return isinstance(screen, Watch) and isinstance(signal, Pressed) and signal.action in speeds


def _toggle_full_screen(window: pygame.Window, shared: Shared) -> None:
    """To the whole desktop and back."""
    shared.full_screen = not shared.full_screen
    if shared.full_screen:
        window.set_fullscreen(desktop=True)
    else:
        window.set_windowed()


def _pixels_per_point(window: pygame.Window, size: tuple[int, int]) -> complex:
    """Pixels of the surface per unit of the mouse's coordinates: above 1 on a high-DPI screen."""
    return complex(size[0] / max(window.size[0], 1), size[1] / max(window.size[1], 1))
