"""A level played from the editor, which is returned to."""

from dataclasses import replace

import pygame

from game.input.keys import Action
from game.input.signals import Pressed, Signal
from game.language import tr_noop
from game.levels import Level
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.play.screen import PlayScreen
from game.storage.storage import Storage


class PlayTest:
    """Plays one level. Where the game would lead to the title or end the program, it leads to the editor. Nothing is stored."""

    def __init__(self, state: AppState, editor: Screen, level: Level) -> None:
        """Start at the first serve."""
        self._editor, self._state, storage = editor, state, Storage(None)
        own = replace(state, open_title=lambda _: editor, open_levels=None, home=tr_noop("Back to the editor"))
        self._own = replace(own, recorder=None, storage=storage, reported=set(storage.problems))
        self._settings = state.settings
        self._inner: Screen = PlayScreen(self._own, (level,))

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Let the game answer; Esc returns to the editor, and does not pause."""
        if isinstance(self._inner, PlayScreen) and isinstance(signal, Pressed) and signal.action is Action.BACK:
            return self._editor
        return self._followed(self._inner.answer(signal, size))

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Let the game advance; settings that a key has changed are shared."""
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
        """Copy settings that were changed in the game to the editor, and the other way round."""
        if self._own.settings != self._settings:
            self._state.change(self._own.settings)
        self._own.settings = self._settings = self._state.settings
