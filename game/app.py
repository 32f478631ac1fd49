"""The only loop: events in, ticks due, one picture out."""

import gc
import time
from collections.abc import Callable

import pygame

from game import display
from game.audio import Audio
from game.controls import Action, FocusLost, Pressed, Released, Signal, translated
from game.lab import session
from game.lab.engine import Engine
from game.lab.registry import scenes
from game.lab.share import parsed
from game.levels import Level, built_in
from game.opinions import Compare
from game.playback import Playback
from game.replay import Recording
from game.screens.base import Listener, Recorder, Screen, Shared
from game.screens.play import Play
from game.screens.title import Title
from game.screens.watch import Watch

_TITLE = "Polar Breakout"
_IDLE_RATE = 20
"""Pictures per second while nobody looks."""


def play(
    levels: tuple[Level, ...],
    seed: int,
    recorder: Recorder | None = None,
    *,
    autopilot: bool = False,
    compare: Compare | None = None,
    engine: Callable[[], Engine] | None = None,
) -> int:
    """Open a window with the title, the first of the levels chosen, and play until it is closed; the exit code.

    recorder: told every tick of every game played. autopilot: it plays, from the first serve on, without a title.
    compare: another engine to ask about contacts; engine: the lab's.
    Raises EnvironmentMissingError without a display.
    """
    catalogue = built_in() if levels[0] in built_in() else levels
    lab = _lab_opener(engine)
    shared = Shared(catalogue, catalogue.index(levels[0]), seed, Title, recorder, autopilot, compare=compare, lab=lab)
    return _shown(shared, lambda: Play(_heard(shared), levels) if autopilot else Title(_heard(shared)))


def watch(recording: Recording, *, compare: Compare | None = None) -> int:
    """Open a window that shows a recorded game until it is closed; the exit code.

    Raises EnvironmentMissingError without a display.
    """
    levels = tuple(recording.levels)
    shared = Shared(levels, 0, recording.seed, Title, compare=compare)
    return _shown(shared, lambda: Watch(_heard(shared), Playback(recording)))


def lab(line: str | None, engine: Callable[[], Engine] | None = None) -> int:
    """Open a window with the lab until it is closed; the exit code. line: a share line, None for the first scene.

    Raises BadInputError for a line that names no scene as it may stand, EnvironmentMissingError without a display.
    """
    opened = parsed(scenes()[0].name if line is None else line, None if engine is None else engine())
    shared = Shared(built_in(), 0, 0, Title)

    def first() -> Screen:
        from game.lab.window.screen import Lab  # noqa: PLC0415  # its widgets, only where they are needed

        return Lab(shared, session.opened(opened))

    return _shown(shared, first)


def _lab_opener(engine: Callable[[], Engine] | None) -> Callable[[Shared, Screen], Screen]:
    """What opens the lab over a screen of the game."""

    def opened(shared: Shared, under: Screen) -> Screen:
        from game.lab.window.screen import Lab  # noqa: PLC0415  # its widgets, only where they are needed

        other = None if engine is None else engine()
        return Lab(shared, session.fresh(scenes()[0], other), under)

    return opened


def _shown(shared: Shared, opened: Callable[[], Screen]) -> int:
    """Show screens in a window until the last one is left; the exit code."""
    window = display.open_window(_TITLE)
    try:
        run(window, shared, opened())
    except KeyboardInterrupt:
        pass
    finally:
        if shared.audio is not None:
            shared.audio.close()
        pygame.quit()
    return 0


def _heard(shared: Shared) -> Shared:
    """The same with sound; the lab has none."""
    shared.audio = Audio()
    return shared


def run(window: pygame.Window, shared: Shared, first: Screen) -> None:
    """The loop."""
    gc.freeze()  # what was made until now stays: looking through it again and again would cost whole frames
    clock, rate = pygame.time.Clock(), display.refresh_rate()
    screen: Screen | None = first
    before = time.perf_counter()
    while screen is not None:
        now = time.perf_counter()
        screen = frame(window, shared, screen, now - before)
        before = now
        clock.tick(rate if window.focused else _IDLE_RATE)


def frame(window: pygame.Window, shared: Shared, screen: Screen, seconds: float) -> Screen | None:
    """One turn of the loop: the screen to go on with, None once the window is closed or the last screen left."""
    answered = _answered(window, shared, screen)
    if answered is None:
        return None
    surface = window.get_surface()
    following = answered.advance(seconds, surface.get_size())
    if following is not None:
        following.draw(surface)
        window.flip()
    return following


def _answered(window: pygame.Window, shared: Shared, screen: Screen) -> Screen | None:
    """The screen after all that the player did since the last frame; None once the window is closed or left."""
    for event in pygame.event.get():
        if event.type in (pygame.QUIT, pygame.WINDOWCLOSE):
            return None
        following = _following(event, window, shared, screen)
        if following is None:
            return None
        screen = following
    return screen


def _following(event: pygame.Event, window: pygame.Window, shared: Shared, screen: Screen) -> Screen | None:
    """The screen after one event."""
    size = window.get_surface().get_size()
    pixels_per_point = _pixels_per_point(window, size)
    signal = translated(event, pixels_per_point)
    if isinstance(screen, Listener):
        if signal == Pressed(Action.FULL_SCREEN):
            _toggle_full_screen(window, shared)
            return screen
        return screen.hear(event, size, pixels_per_point)
    if signal is None or _answered_here(signal, window, shared):
        return screen
    if signal == Pressed(Action.LAB) and shared.lab is not None:
        left = screen.answer(FocusLost(), size)  # a game in play pauses
        return None if left is None else shared.lab(shared, left)
    return screen.answer(signal, size)


def _answered_here(signal: Signal, window: pygame.Window, shared: Shared) -> bool:
    """Whether the signal is one that means the same on every screen; if so it is obeyed."""
    if isinstance(signal, Released):
        return False
    match signal:
        case Pressed(Action.FULL_SCREEN):
            _toggle_full_screen(window, shared)
        case Pressed(Action.MUTE):
            shared.toggle_sound()
        case Pressed(Action.THEME):
            shared.toggle_theme()
        case Pressed(Action.EFFECTS):
            shared.effects = not shared.effects
        case Pressed(Action.NORMALS):
            shared.normals = not shared.normals and shared.compare is not None
        case _:
            return False
    return True


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
