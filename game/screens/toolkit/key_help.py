"""A panel that lists keys and what they do, in parts for each device where there are several."""

from typing import NamedTuple

import pygame

from game.input.events import position_in
from game.input.keys import KEYS, Action
from game.input.signals import Pressed, Signal
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.focus import Focus
from game.screens.toolkit.items.basic import Item, TextItem
from game.screens.toolkit.layout import FROM_TOP, Content, Row
from game.screens.toolkit.menu import back_row
from game.screens.toolkit.panel import Panel

_MEANING = 2.6
"""Width of the column of meanings, in widths of the column of keys."""

Lines = tuple[tuple[str, str], ...]
"""Pairs of keys and what they do."""


class HelpWords(NamedTuple):
    """The panel's texts. back: label of the button that closes it; note: below all parts."""

    title: str
    back: str
    note: str = ""


class KeyHelp(Panel):
    """The panel. The key that opened it closes it, too."""

    def __init__(self, state: AppState, under: Screen, words: HelpWords, parts: tuple[tuple[str, Lines], ...]) -> None:
        """Open over a screen. parts: names and lines; the name of a single part is not shown."""
        super().__init__(state, under)
        self._words, self._parts = words, parts

    def content(self) -> Content:
        """The part that is shown."""
        names = tuple([name for name, _ in self._parts if name])
        rows: list[Row] = [
            (TextItem(keys, 1.0, faint=True), TextItem(meaning, 1.0, share=_MEANING))
            for keys, meaning in self._parts[self._tab][1]
        ]
        if self._words.note:
            rows += [(Item(),), (TextItem(self._words.note, 1.0, faint=True),)]
        footer, tall = back_row(self._words.back, self.back), FROM_TOP if names else 0.0
        return Content(self._words.title, tuple(rows), footer, names, self._tab, 46.0, tall=tall)

    def first(self) -> Focus | None:
        """The button that closes it."""
        return Focus(len(self.content().body), 1)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """As in every panel; in addition, the key for help closes it."""
        if isinstance(signal, Pressed) and signal.action is Action.HELP:
            return self.back()
        return super().answer(signal, size)

    def typed(self, event: pygame.Event) -> bool:
        """Consume letters: none is a command here, except the one that closes the panel."""
        is_letter = event.type == pygame.KEYDOWN and pygame.K_SPACE < event.key < pygame.K_DELETE
        return is_letter and KEYS.action(position_in(event), event.key) is not Action.HELP
