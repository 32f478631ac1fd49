"""One of many: an item that shows the present one, and the list that it opens. Lengths are in units of text."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.focus import Focus
from game.screens.toolkit.items.basic import Heading, Item, LineItem, TableRow
from game.screens.toolkit.layout import Content, Row
from game.screens.toolkit.panel import Panel
from game.screens.toolkit.plate import LABEL, draw_focus, write_fitting

_MARGIN, _CHEVRON = 0.7, (0.34, 0.3)
"""From the words and the arrow head to the edges; half width and half height of the arrow head."""
_NOTE = 2.0
"""Width of what is said about an option, in widths of its name."""


class Option(NamedTuple):
    """One of many. name: what it is known by; note: a few words about it."""

    name: str
    note: str = ""


Options = tuple[tuple[str, tuple[Option, ...]], ...]
"""Options under the headings of their groups; a heading may be empty."""


@dataclass(frozen=True)
class DropDown(LineItem):
    """The present one of many. opened: makes the list of all."""

    label: str
    opened: Callable[[], Screen | None]
    tip: str = ""
    share: float = 1.0

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """Its name, and an arrow head downwards."""
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused, resting=True)
        colour = theme.accent if focused else theme.text
        middle, (across, down) = complex(box.right - unit * (_MARGIN + _CHEVRON[0]), box.centery), _CHEVRON
        corners = [middle + unit * corner for corner in (complex(-across, -down), complex(across, -down), complex(0.0, down))]
        pygame.draw.polygon(canvas.surface, colour, [(corner.real, corner.imag) for corner in corners])
        room = box.width - unit * (3.0 * _MARGIN + 2.0 * across)
        write_fitting(canvas, self.label, LABEL, colour, complex(box.left + unit * _MARGIN, box.centery), "midleft", room)

    def accepted(self, _panel: Screen) -> Screen | None:
        """The list."""
        return self.opened()


class OptionList(Panel):
    """All options, each with a few words about it; a letter leads to the next one that begins with it."""

    def __init__(
        self,
        state: AppState,
        under: Screen,
        title: str,
        options: Options,
        present: str,
        choose: Callable[[Option], Screen | None],
    ) -> None:
        """Open over a screen. present: name of the one that has the focus first; choose: the screen after one was chosen."""
        super().__init__(state, under)
        self._title, self._options, self._present, self._choose = title, options, present, choose
        self._drawn = False

    def content(self) -> Content:
        """A line for every option."""
        return Content(self._title, tuple([row for row, _ in self._lines()]), width=44.0)

    def first(self) -> Focus | None:
        """The present one."""
        return self._focus_of([option is not None and option.name == self._present for _, option in self._lines()])

    def draw(self, surface: pygame.Surface) -> None:
        """At first, so far scrolled that the present one is seen."""
        if not self._drawn:
            self._drawn, size = True, surface.get_size()
            self._settled(self._form_layout(size))
            self._show_focus(size)
        super().draw(surface)

    def typed(self, event: pygame.Event) -> bool:
        """Take letters and digits; whether an event is one. Arrows, Enter and Esc mean what they mean everywhere."""
        if event.type == pygame.TEXTINPUT:
            self._lead_to(str(event.text).strip().casefold())
            return True
        return event.type == pygame.KEYDOWN and pygame.K_SPACE < event.key < pygame.K_DELETE

    def _lead_to(self, letters: str) -> None:
        """Focus the next option that begins with what was typed."""
        names = ["" if option is None else option.name.casefold() for _, option in self._lines()]
        begins = [bool(name and letters) and name.startswith(letters) for name in names]
        row = self._focus.row if self._focus is not None else -1
        after = [found and index > row for index, found in enumerate(begins)]
        self._focus = self._focus_of(after if any(after) else begins) or self._focus
        self._changes += 1
        self._drawn = False

    def _focus_of(self, wanted: list[bool]) -> Focus | None:
        """The focus on the first line that is wanted."""
        return Focus(wanted.index(True), 0) if any(wanted) else None

    def _lines(self) -> list[tuple[Row, Option | None]]:
        """Every line and its option; None for a heading."""
        lines: list[tuple[Row, Option | None]] = []
        for heading, options in self._options:
            lines += [((Heading(heading),), None)] if heading else []
            lines += [((self._line(option),), option) for option in options]
        return lines

    def _line(self, option: Option) -> Item:
        """An option's line."""
        cells = ((option.name, 1.0, "left"), (option.note, _NOTE, "left"))
        return TableRow(cells, lambda: self._choose(option), strong=option.name == self._present)
