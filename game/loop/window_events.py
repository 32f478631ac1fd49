"""What the window's events lead to: the screen after them, or what holds on every screen."""

import pygame

from game.input.events import system_layout
from game.input.key_names import use_layout
from game.input.keys import Action
from game.input.signals import FocusLost, PadChanged, Pressed, Signal, pad_of
from game.language import tr
from game.overlay.toast import Toast
from game.screens.app_state import AppState
from game.screens.base import Listener, Screen, Typist
from game.screens.watch import Watch
from game.settings.keys import changed

_LEFT, _BACK = (pygame.WINDOWFOCUSLOST, pygame.WINDOWMINIMIZED), (pygame.WINDOWFOCUSGAINED, pygame.WINDOWRESTORED)
"""The player goes to another window, and comes back."""
_FINGERS = (pygame.FINGERDOWN, pygame.FINGERMOTION, pygame.FINGERUP)
_SHOWN_AGAIN = (pygame.WINDOWEXPOSED, pygame.WINDOWRESIZED, pygame.WINDOWSIZECHANGED, pygame.WINDOWRESTORED, pygame.WINDOWSHOWN)
"""After these the window's picture may be gone."""


def answered_events(window: pygame.Window, size: tuple[int, int], state: AppState, screen: Screen) -> Screen | None:
    """The screen after all that the player did since the last frame; None once the window is closed or left.

    size: of the surface, pixels.
    """
    for event in pygame.event.get():
        if event.type in (pygame.QUIT, pygame.WINDOWCLOSE):
            return None
        if event.type == pygame.KEYMAPCHANGED:
            use_layout(system_layout())
        if event.type in _SHOWN_AGAIN:
            state.shown = None
        if event.type in (*_LEFT, *_BACK):
            state.away = event.type in _LEFT
        following = _following(event, size, window, state, screen)
        if following is None:
            return None
        screen = following
    return screen


def _following(
    event: pygame.Event, size: tuple[int, int], window: pygame.Window, state: AppState, screen: Screen
) -> Screen | None:
    """The screen after one event. size: of the surface, pixels."""
    if isinstance(screen, Typist) and screen.typed(event):
        return screen
    pixels_per_point = _pixels_per_point(window, size)
    signals = tuple(state.devices.signals(event, size, pixels_per_point, orbits=state.view.goal > 0.0))
    if isinstance(screen, Listener):
        if any([isinstance(signal, Pressed) and signal.action is Action.FULL_SCREEN for signal in signals]):
            toggle_full_screen(window, state)
            return screen
        after_hands = _after_hands(screen, signals, size, fingers=event.type in _FINGERS)
        return screen.hear(event, size, pixels_per_point) if after_hands is screen else after_hands
    following: Screen | None = screen
    for signal in signals:
        if following is not None:
            following = _following_signal(signal, size, window, state, following)
    return following


def _after_hands(screen: Screen, signals: tuple[Signal, ...], size: tuple[int, int], *, fingers: bool) -> Screen | None:
    """The screen after the signals of gamepads or fingers; None ends the program. fingers: whether all are of fingers."""
    following: Screen | None = screen
    for signal in signals:
        if following is screen and (fingers or isinstance(signal, FocusLost) or pad_of(signal) is not None):
            following = screen.answer(signal, size)
    return following


def _following_signal(
    signal: Signal, size: tuple[int, int], window: pygame.Window, state: AppState, screen: Screen
) -> Screen | None:
    """The screen after one signal. size: of the surface, pixels."""
    if not _means_speed(signal, screen) and _answered_here(signal, window, state):
        return screen
    if isinstance(signal, Pressed) and signal.action is Action.LAB and state.open_lab is not None:
        left = screen.answer(FocusLost(), size)  # a game in play pauses
        return None if left is None else state.open_lab(state, left)
    return screen.answer(signal, size)


def _answered_here(signal: Signal, window: pygame.Window, state: AppState) -> bool:
    """Obey a signal that means the same on every screen; whether it is one."""
    match signal:
        case Pressed(Action.FULL_SCREEN):
            toggle_full_screen(window, state)
        case Pressed(Action.NORMALS):
            state.shows_normals = not state.shows_normals and state.compare is not None
        case PadChanged(name, there):
            state.toast = Toast((tr("Gamepad: {name}") if there else tr("Gamepad gone: {name}")).format(name=name))
        case Pressed(action) if (now := changed(state.settings, action)) is not None:
            state.change(now.settings, Toast(now.words, now.level))
        case _:
            return False
    return True


def _means_speed(signal: Signal, screen: Screen) -> bool:
    """Whether the volume's keys change how fast a recording runs."""
    speeds = (Action.LESS, Action.MORE)
    return isinstance(screen, Watch) and isinstance(signal, Pressed) and signal.action in speeds


def toggle_full_screen(window: pygame.Window, state: AppState) -> None:
    """Make the window as large as the desktop, or as it was before."""
    state.full_screen = not state.full_screen
    if state.full_screen:
        window.set_fullscreen(desktop=True)
    else:
        window.set_windowed()


def _pixels_per_point(window: pygame.Window, size: tuple[int, int]) -> complex:
    """Pixels of the surface per unit of the mouse's coordinates: above 1 on a high-DPI screen."""
    return complex(size[0] / max(window.size[0], 1), size[1] / max(window.size[1], 1))
