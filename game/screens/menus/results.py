"""The results of a level or a game: figures that count up, a rank, and buttons to go on."""

from collections.abc import Callable
from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import mixed
from game.drawing.raster.primitives import draw_dot
from game.input.signals import Clicked, Pressed, Signal
from game.language import grouped, tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.items.basic import Drawing, Heading, Item, TableRow, TextItem
from game.screens.toolkit.layout import Content
from game.screens.toolkit.menu import Entry, buttons_of
from game.screens.toolkit.panel import Panel

_FIGURE_SECONDS = 0.45
"""A figure counts up for so long, one after the other."""
_BADGE = 6.4
"""Height of the rank, units of text of the usual size: it is large already."""
_LETTER = 0.66
"""Size of its letter, in heights of the rank."""


class Figure(NamedTuple):
    """A line of the results. amount: counts up from 0; words: makes words of it; best: it is a new best."""

    label: str
    amount: int
    words: Callable[[int], str] = grouped
    best: bool = False


class ResultsPanel(Panel):
    """Figures and buttons. While they count, any key or click shows them all; the buttons answer only then."""

    def __init__(
        self,
        state: AppState,
        under: Screen,
        title: str,
        line: str,
        figures: tuple[Figure, ...],
        entries: tuple[Entry, ...],
        rank: str = "",
        back: Callable[[], Screen | None] | None = None,
    ) -> None:
        """line: below the title. rank: a letter, empty for none. back: what Esc does; by default as the first entry."""
        super().__init__(state, under)
        self._title, self._line, self._figures, self._entries, self._rank = title, line, figures, entries, rank
        self._back = entries[0].chosen if back is None else back
        self._seconds = 1e6 if state.settings.reduced_motion else 0.0

    @property
    def counted(self) -> bool:
        """Whether all figures are there."""
        return self._seconds >= _FIGURE_SECONDS * len(self._figures)

    @property
    def appearance(self) -> tuple[object, ...]:
        """As of every panel, and how far the figures have counted."""
        return *super().appearance, self._seconds

    def content(self) -> Content:
        """Line, rank, figures, buttons."""
        rows: list[tuple[Item, ...]] = [(TextItem(self._line, 1.1, faint=True, centred=True),)]
        if self._rank:
            rows.append((Drawing(_BADGE / self.state.text_scale, self._draw_rank),))
        rows.append((Heading(tr("Results")),))
        rows += [(self._figure(index, figure),) for index, figure in enumerate(self._figures)]
        return Content(self._title, tuple(rows), buttons_of(self._entries), width=26.0, centred=True)

    def back(self) -> Screen | None:
        """As it was given."""
        return self._back()

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Show all figures first."""
        if not self.counted and isinstance(signal, Pressed | Clicked):
            self._seconds = 1e6
            return self
        return super().answer(signal, size)

    def advance(self, seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Continue counting."""
        if not self.counted:
            self._seconds += max(seconds, 0.0)
        elif self._seconds < 1e6:
            self._seconds = 1e6
        return self

    def _share(self, index: int) -> float:
        """How far a figure has counted: 0 to 1, fast at first."""
        left = 1.0 - min(max(self._seconds / _FIGURE_SECONDS - index, 0.0), 1.0)
        return 1.0 - left * left * left

    def _figure(self, index: int, figure: Figure) -> TableRow:
        """A line of the results; empty until its turn comes."""
        share = self._share(index)
        words = figure.words(round(figure.amount * share)) if share > 0.0 else ""
        new = tr("new best") if figure.best and share >= 1.0 else ""
        return TableRow(
            ((figure.label, 2.4, "left"), (new, 1.4, "left"), (words, 1.8, "right")), strong=figure.best and share >= 1.0
        )

    def _draw_rank(self, canvas: Canvas, box: pygame.Rect) -> None:
        """The rank in a ring of bricks, as many lit as the rank is good; it appears with the last figure."""
        theme, radius = canvas.theme, box.height * 0.44
        middle, there = complex(*box.center), self.counted
        colour = theme.accent if there else theme.panel_edge
        draw_dot(canvas.surface, middle, radius, colour)
        draw_dot(canvas.surface, middle, radius * 0.88, theme.panel)
        draw_dot(canvas.surface, middle, radius * 0.8, mixed(theme.panel, colour, 0.16))
        if there:
            size = box.height / canvas.unit
            canvas.write(self._rank, size * _LETTER, theme.accent, middle + 1j * box.height * 0.02, "center")
