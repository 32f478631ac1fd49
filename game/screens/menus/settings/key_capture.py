"""The panel that asks for a key or a button of an action: the next one that is pressed."""

import pygame

from game.input.events import position_in
from game.input.key_choice import CaptureTarget, given, question
from game.input.keys import PadButton
from game.input.scancodes import SCANCODES
from game.language import tr
from game.overlay.toast import Toast
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.items.basic import TextItem
from game.screens.toolkit.layout import Content
from game.screens.toolkit.menu import back_row
from game.screens.toolkit.panel import Panel

_TOLD_SECONDS = 4.0


class KeyCapture(Panel):
    """Waits for a key or a button. Esc, and B on a gamepad, lead back; so does a click."""

    def __init__(self, state: AppState, under: Screen, wanted: CaptureTarget) -> None:
        """Open over the settings."""
        super().__init__(state, under)
        self._wanted = wanted
        self._answered = False

    def content(self) -> Content:
        """The question."""
        lines = enumerate(question(self._wanted))
        rows = tuple([(TextItem(line, 1.1, faint=index > 0, centred=True),) for index, line in lines])
        return Content(self._wanted.name, rows, back_row(tr("Back"), self.back), width=28.0, centred=True)

    def typed(self, event: pygame.Event) -> bool:
        """Take a pressed key or button, whatever it usually means. Returns whether the event was one."""
        if event.type not in (pygame.KEYDOWN, pygame.CONTROLLERBUTTONDOWN):
            return False
        if not self._answered:
            self._hear(event)
        return True

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Lead back once it is answered."""
        return self.back() if self._answered else super().advance(seconds, size)

    def _hear(self, event: pygame.Event) -> None:
        """A key or a button went down."""
        of_pad = event.type == pygame.CONTROLLERBUTTONDOWN
        control = int(event.button) if of_pad else position_in(event)
        leaves = control == (PadButton.B if of_pad else SCANCODES["Escape"])
        if leaves:
            self._answered = True
        elif of_pad is self._wanted.of_pad and (of_pad or control):
            self._give(control)

    def _give(self, control: int) -> None:
        """Give the action the pressed key, and say what that changed."""
        settings = self.state.settings
        own_keys, told = given(settings.own_keys, self._wanted, control)
        self.state.change(settings._replace(own_keys=own_keys), Toast(told, None, _TOLD_SECONDS))
        self._answered = True
