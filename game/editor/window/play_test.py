"""A level played from the editor, which is returned to."""

from dataclasses import replace

import pygame

from game.input.keys import Action
from game.input.signals import Pressed, Signal
from game.kept.store import Kept
from game.language import tr_noop
from game.levels import Level
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.play import PlayScreen


class PlayTest:
    """Plays one level; wherever the game would go on to the title or out, the editor comes back. Nothing of it is kept."""

    def __init__(self, state: AppState, editor: Screen, level: Level) -> None:
        """Start at the first serve."""
        self._editor, self._state, kept = editor, state, Kept(None)
        own = replace(state, open_title=lambda _: editor, open_levels=None, home=tr_noop("Back to the editor"))
        self._own = replace(own, recorder=None, kept=kept, told=set(kept.problems))
        self._settings = state.settings
        self._inner: Screen = PlayScreen(self._own, (level,))

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Let the game answer; Esc leads back from it, not to a pause."""
        if isinstance(self._inner, PlayScreen) and isinstance(signal, Pressed) and signal.action is Action.BACK:
            return self._editor
        return self._followed(self._inner.answer(signal, size))

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Let the game go on, with settings that a key may have changed."""
        self._share_settings()
        return self._followed(self._inner.advance(seconds, size))

    def draw(self, surface: pygame.Surface) -> None:
        """What the game shows."""
        self._inner.draw(surface)

    def _followed(self, screen: Screen | None) -> Screen:
        """This screen with what the game shows next, or the editor."""
        self._share_settings()
        if screen is None or screen is self._editor:
            return self._editor
        self._inner = screen
        return self

    def _share_settings(self) -> None:
        """Settings that were changed in the game or outside of it hold in both."""
        if self._own.settings != self._settings:
            self._state.change(self._own.settings)
        self._own.settings = self._settings = self._state.settings
