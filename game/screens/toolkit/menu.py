"""A panel of a title, some lines of text and buttons below each other: pauses, questions, choices."""

from collections.abc import Callable
from typing import NamedTuple

from game.input.keys import Action
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.items.basic import ButtonItem, Item, TextItem
from game.screens.toolkit.layout import Content, Row
from game.screens.toolkit.panel import Panel


class Entry(NamedTuple):
    """One line of a menu that can be chosen.

    label: what it says.
    chosen: makes the screen that it leads to; None leaves the game.
    key: chooses it at once.
    tip: a sentence about it.
    """

    label: str
    chosen: Callable[[], Screen | None]
    key: Action | None = None
    tip: str = ""


class Menu(Panel):
    """Entries to choose from, the first one selected when it opens: where something can be lost, it is the safe one."""

    def __init__(
        self,
        state: AppState,
        under: Screen,
        title: str,
        lines: tuple[str, ...],
        entries: tuple[Entry, ...],
        back: Callable[[], Screen | None],
    ) -> None:
        """Open over a screen. back: what Esc does."""
        super().__init__(state, under)
        self._title, self._lines, self._entries = title, lines, entries
        self._back = back

    def content(self) -> Content:
        """Lines and entries."""
        lines: tuple[tuple[Item, ...], ...] = tuple([(TextItem(line, 1.1, faint=True, centred=True),) for line in self._lines])
        return Content(self._title, lines, buttons_of(self._entries), width=24.0, centred=True)

    def back(self) -> Screen | None:
        """As it was given."""
        return self._back()


def back_row(label: str, back: Callable[[], Screen | None]) -> tuple[Row, ...]:
    """A footer of one button in the middle."""
    return ((Item(), ButtonItem(label, back, centred=True), Item()),)


def buttons_of(entries: tuple[Entry, ...]) -> tuple[Row, ...]:
    """A button for every entry, below each other."""
    return tuple([(ButtonItem(one.label, one.chosen, one.key, one.tip, centred=True),) for one in entries])
