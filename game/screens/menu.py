"""A menu over another screen, which stands still meanwhile."""

from collections.abc import Callable
from typing import NamedTuple

import pygame

from game.drawing.camera import unit_of
from game.drawing.raster.primitives import draw_box
from game.input.keys import Action
from game.input.signals import Clicked, Moved, Pressed, Signal
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.help import Help
from game.screens.panel import centred, dim, draw_panel, index_at
from game.screens.still_picture import StillPicture

# Lengths are in units of text.
_TITLE, _LINE, _ENTRY = 2.4, 1.1, 1.3
"""Sizes of letters."""
_TITLE_TOP, _LINES_TOP = 1.2, 3.9
"""From the panel's top to the title, and to the first line or entry."""
_LINE_PITCH, _ENTRY_PITCH = 1.4, 2.3
_LINES_GAP, _BOTTOM = 0.7, 1.0
"""Between lines and entries, and below the last entry."""
_WIDTH = 22.0
"""Of the panel; more where a line needs it."""
_LINE_MARGIN, _ENTRY_MARGIN = 2.0, 3.0
"""From lines and entries to the panel's edges."""
_ENTRY_HEIGHT, _ENTRY_CORNER, _ENTRY_EDGE = 2.0, 0.5, 0.1
"""Of the box around the selected entry: height, radius of corners, width of edge."""


class Entry(NamedTuple):
    """One line of a menu that can be chosen.

    label: what it says.
    chosen: makes the screen that it leads to; None leaves the game.
    key: chooses it at once.
    """

    label: str
    chosen: Callable[[], Screen | None]
    key: Action | None = None


class Menu:
    """A panel with a title, some lines of text and entries to choose from."""

    def __init__(
        self,
        state: AppState,
        under: Screen,
        title: str,
        lines: tuple[str, ...],
        entries: tuple[Entry, ...],
        back: Callable[[], Screen | None],
    ) -> None:
        """Open over a screen, the first entry selected. back: what Esc does."""
        self._state, self._under = state, under
        self._title, self._lines, self._entries = title, lines, entries
        self._back = back
        self._selected = 0
        self._picture = StillPicture()

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Move the selection, or do what the entry says."""
        match signal:
            case Pressed(Action.UP | Action.LEFT):
                self._selected = (self._selected - 1) % len(self._entries)
            case Pressed(Action.DOWN | Action.RIGHT):
                self._selected = (self._selected + 1) % len(self._entries)
            case Pressed(Action.CONFIRM | Action.SERVE):
                return self._entries[self._selected].chosen()
            case Pressed(Action.BACK):
                return self._back()
            case Pressed(Action.HELP):
                return Help(self._state, self)
            case Pressed(action):
                named = [entry for entry in self._entries if entry.key is action]
                return named[0].chosen() if named else self
            case Moved(pixel) if (index := self._entry_at(pixel, size)) is not None:
                self._selected = index
            case Clicked(pixel) if (index := self._entry_at(pixel, size)) is not None:
                return self._entries[index].chosen()
        return self

    def advance(self, _seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Nothing moves."""
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, dimmed, and the panel."""
        self._picture.show(surface, (self._state.appearance, self._selected), self._draw)

    def _draw(self, surface: pygame.Surface) -> None:
        """Draw it anew."""
        self._under.draw(surface)
        canvas = self._state.canvas(surface)
        theme, unit = canvas.theme, canvas.unit
        panel, boxes = self._boxes(canvas.size)
        dim(surface, theme)
        draw_panel(surface, panel, theme, unit)
        middle = float(panel.centerx)
        canvas.write(self._title, _TITLE, theme.text, complex(middle, panel.top + unit * _TITLE_TOP), "midtop")
        for index, line in enumerate(self._lines):
            y = panel.top + unit * (_LINES_TOP + _LINE_PITCH * index)
            canvas.write(line, _LINE, theme.faint, complex(middle, y), "midtop")
        for index, (entry, box) in enumerate(zip(self._entries, boxes, strict=True)):
            selected = index == self._selected
            if selected:
                draw_box(surface, box, unit * _ENTRY_CORNER, theme.panel, theme.accent, unit * _ENTRY_EDGE)
            colour = theme.accent if selected else theme.text
            canvas.write(entry.label, _ENTRY, colour, complex(box.centerx, box.centery), "center")

    def _boxes(self, size: tuple[int, int]) -> tuple[pygame.Rect, list[pygame.Rect]]:
        """The panel and its entries, pixels."""
        unit, type_, colour = unit_of(size), self._state.type, self._state.theme.faint
        texts = [type_.rendered(line, unit * _LINE, colour).get_width() for line in self._lines]
        width = max([unit * _WIDTH, *[text + unit * 2.0 * _LINE_MARGIN for text in texts]])
        top = _LINES_TOP + _LINE_PITCH * len(self._lines) + (_LINES_GAP if self._lines else 0.0)
        panel = centred(size, width, unit * (top + _ENTRY_PITCH * len(self._entries) + _BOTTOM))
        entry = (round(width - unit * 2.0 * _ENTRY_MARGIN), round(unit * _ENTRY_HEIGHT))
        left = panel.left + round(unit * _ENTRY_MARGIN)
        tops = [panel.top + round(unit * (top + _ENTRY_PITCH * index)) for index in range(len(self._entries))]
        return panel, [pygame.Rect((left, y), entry) for y in tops]

    def _entry_at(self, pixel: complex, size: tuple[int, int]) -> int | None:
        """Index of the entry at a pixel."""
        return index_at(self._boxes(size)[1], pixel)
