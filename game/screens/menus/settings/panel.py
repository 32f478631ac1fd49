"""The settings over another screen, in parts: what every one means, and what it is now."""

from game.input.keys import Action
from game.input.signals import Pressed, Signal
from game.language import tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.settings.rows import PARTS
from game.screens.toolkit.layout import FROM_TOP, Content
from game.screens.toolkit.menu import back_row
from game.screens.toolkit.panel import Panel


class SettingsPanel(Panel):
    """The panel of the settings. Closing it stores them."""

    def __init__(self, state: AppState, under: Screen) -> None:
        """Open over a screen with the part that was open last."""
        super().__init__(state, under)
        self._tab = state.settings_tab % len(PARTS)

    def content(self) -> Content:
        """The rows of the part."""
        footer = back_row(tr("Back"), self.back)
        names = tuple([part.name() for part in PARTS])
        rows = PARTS[self._tab].rows(self.state, self)
        return Content(tr("Settings"), rows, footer, names, self._tab, 42.0, tall=FROM_TOP, tips=True)

    def open_tab(self, index: int) -> None:
        """Remember which part is open."""
        super().open_tab(index)
        self.state.settings_tab = index

    def back(self) -> Screen | None:
        """Store the settings, and lead back."""
        self.state.save_settings()
        return super().back()

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """The keys that open it close it."""
        if isinstance(signal, Pressed) and signal.action in (Action.SETTINGS, Action.PAUSE):
            return self.back()
        return super().answer(signal, size)
