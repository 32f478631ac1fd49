"""The items of a panel: what each looks like, and what it does when it is accepted, stepped or pointed at.

An item is a value that is made anew whenever its panel shows something else; what it changes is elsewhere, and reached by the
functions that it is given. Lengths are in units of text unless they are said to be pixels.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.raster.primitives import draw_box, draw_dot
from game.drawing.text import Type
from game.input.keys import Action
from game.screens.base import Screen
from game.screens.toolkit.plate import draw_focus, draw_label, write_fitting

_MARGIN = 0.7
"""From an item's words to its edges."""
_LABEL, _NOTE, _STATE = 1.15, 1.0, 1.0
"""Sizes of letters: of what an item is called, of what stands at its right end, and of what a switch or a choice says."""
_ROW = 2.0
"""Height of an item that is used."""
_LINE = 1.25
"""From line to line of text, in sizes of its letters."""
_SWITCH, _SWITCH_GAP, _SWITCH_EDGE, _KNOB_INSET = (1.9, 0.95), 0.5, 0.1, 0.2
"""A switch, from it to the word beside it, the width of its edge, and from its edge to its knob."""
_OVERRULED = 0.45
"""A switch that has no effect now has this share of the way from the panel's colour to its own."""
_FADED = 0.4
"""What cannot be used has this share of the way from the panel's colour to its own."""
_CHEVRON, _CHOICE_GAP = (0.3, 0.32), 0.8
"""Half width and half height of the arrow heads beside a choice, and from them to its words."""
_LINE_WIDTH = 0.05
"""Of the line under a heading."""


class Item:
    """An item on a panel. This base class is empty space without a use.

    tip: shown while it has the focus. key: that uses it from anywhere on the panel.
    share: weight of its width among the items of the row. is_typed: whether accepting it begins to type a number.
    """

    tip: str = ""
    key: Action | None = None
    share: float = 1.0
    is_typed = False

    @property
    def focusable(self) -> bool:
        """Whether it can be used."""
        return False

    def height(self, _type: Type, _unit: float, _width: float) -> float:
        """How high it is, units. unit, width: pixels."""
        return 0.6

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """Draw it in a box, pixels."""

    def accepted(self, panel: Screen) -> Screen | None:
        """The screen to go on with after it was accepted. panel: it is on."""
        return panel

    def stepped(self, _steps: int) -> bool:
        """Obey left (-1) or right (+1); whether they mean anything here."""
        return False

    def grip(self, _pixel: complex, _box: pygame.Rect, _unit: float) -> complex | None:
        """From the middle of what is dragged to the pixel that was pressed, pixels; None where nothing can be dragged."""
        return None

    def held_sign(self, _pixel: complex, _box: pygame.Rect, _unit: float) -> int:
        """Direction in which a mouse button held at a pixel steps it repeatedly: -1, +1, or 0 for none."""
        return 0

    def pointed(self, panel: Screen, _pixel: complex, _box: pygame.Rect, _unit: float, *, clicked: bool) -> Screen | None:
        """The screen to go on with after a click, or a drag with the button held."""
        return self.accepted(panel) if clicked else panel


@dataclass(frozen=True)
class Space(Item):
    """Empty room between rows. tall: its height."""

    tall: float

    def height(self, _type: Type, _unit: float, _width: float) -> float:
        """As it was given."""
        return self.tall


@dataclass(frozen=True)
class TextItem(Item):
    """A text, wrapped; a line break begins a paragraph.

    size: of the letters. faint: whether in the second colour. centred: whether lines are centred, not aligned left. midway:
    whether the text is in the middle of the row's height, not at its top.
    """

    text: str
    size: float = 1.05
    faint: bool = False
    centred: bool = False
    share: float = 1.0
    midway: bool = False

    def height(self, type_: Type, unit: float, width: float) -> float:
        """As many lines as the words take."""
        return len(self._lines(type_, unit, width)) * self.size * _LINE + 0.25

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:  # noqa: ARG002  # it never is
        """The lines, one below the other."""
        colour = canvas.theme.faint if self.faint else canvas.theme.text
        anchor, x = ("midtop", box.centerx) if self.centred else ("topleft", box.left)
        lines, pitch = self._lines(canvas.type, canvas.unit, box.width), canvas.unit * self.size * _LINE
        top = box.centery - pitch * len(lines) / 2.0 if self.midway else float(box.top)
        for index, line in enumerate(lines):
            write_fitting(canvas, line, self.size, colour, complex(x, top + pitch * index), anchor, box.width)

    def _lines(self, type_: Type, unit: float, width: float) -> list[str]:
        """The lines, an empty one between two paragraphs."""
        paragraphs = [type_.wrapped(paragraph, unit * self.size, width) for paragraph in self.text.split("\n")]
        return [line for lines in paragraphs for line in ("", *lines)][1:]


@dataclass(frozen=True)
class Heading(Item):
    """A title of what follows, over a line. note: at its right end."""

    text: str
    note: str = ""

    def height(self, _type: Type, _unit: float, _width: float) -> float:
        """Room above the words as well."""
        return 2.3

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:  # noqa: ARG002  # it never is
        """Words and line."""
        theme, unit = canvas.theme, canvas.unit
        foot = box.bottom - round(unit * 0.4)
        pygame.draw.rect(canvas.surface, theme.panel_edge, (box.left, foot, box.width, max(1, round(unit * _LINE_WIDTH))))
        note = canvas.write(self.note, _NOTE, theme.faint, complex(box.right, foot - unit * 0.3), "bottomright")
        room = box.width - (note.width + unit if self.note else 0.0)
        write_fitting(canvas, self.text, 1.25, theme.accent, complex(box.left, foot - unit * 0.25), "bottomleft", room)


@dataclass(frozen=True)
class ButtonItem(Item):
    """A button. chosen: called when it is used, returns the next screen; note: words at its right end; centred: of the label.

    framed: whether it has a frame also without the focus; a button with a centred label always has one.
    """

    label: str
    chosen: Callable[[], Screen | None]
    key: Action | None = None
    tip: str = ""
    note: str = ""
    centred: bool = False
    large: bool = False
    share: float = 1.0
    framed: bool = False

    @property
    def focusable(self) -> bool:
        """It is used."""
        return True

    def height(self, _type: Type, _unit: float, _width: float) -> float:
        """One line."""
        return _ROW * (1.15 if self.large else 1.0)

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """The label in a frame when it is focused."""
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused, resting=self.centred or self.framed)
        size = _LABEL * (1.3 if self.large else 1.0)
        colour = theme.accent if focused else theme.text
        if self.centred:
            room = box.width - 0.6 * unit
            write_fitting(canvas, self.label, size, colour, complex(box.centerx, box.centery), "center", room)
            return
        room = box.width - 2.0 * unit * _MARGIN
        if self.note:
            right = complex(box.right - unit * _MARGIN, box.centery)
            room -= write_fitting(canvas, self.note, _NOTE, theme.faint, right, "midright", room / 2.0).width + unit
        write_fitting(canvas, self.label, size, colour, complex(box.left + unit * _MARGIN, box.centery), "midleft", room)

    def accepted(self, _panel: Screen) -> Screen | None:
        """Where it leads."""
        return self.chosen()


@dataclass(frozen=True)
class LineItem(Item):
    """One line that is used."""

    @property
    def focusable(self) -> bool:
        """It is used."""
        return True

    def height(self, _type: Type, _unit: float, _width: float) -> float:
        """One line."""
        return _ROW


@dataclass(frozen=True)
class Switch(LineItem):
    """On or off. words: said beside it, first for off; overruled: it has no effect now; usable: whether it can be turned."""

    label: str
    on: bool
    turned: Callable[[], None]
    tip: str = ""
    words: tuple[str, str] = ("", "")
    overruled: bool = False
    usable: bool = True

    @property
    def focusable(self) -> bool:
        """Where it can be turned."""
        return self.usable

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """The label, and a switch that says on or off."""
        canvas = canvas if self.usable else canvas._replace(theme=_faded(canvas.theme))
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused)
        track = pygame.Rect(0, 0, round(unit * _SWITCH[0]), round(unit * _SWITCH[1]))
        track.midright = (round(box.right - unit * _MARGIN), box.centery)
        lit = self.on and not self.overruled
        left = complex(track.left - unit * _SWITCH_GAP, box.centery)
        words = canvas.write(self.words[self.on], _STATE, theme.text if lit else theme.faint, left, "midright")
        filled = mixed(theme.panel, theme.accent, _OVERRULED if self.overruled else 1.0)
        radius = track.height / 2.0
        fill, edge = (filled, filled) if self.on else (theme.panel, theme.panel_edge)
        draw_box(canvas.surface, track, radius, fill, edge, unit * _SWITCH_EDGE)
        knob = complex(track.right - radius if self.on else track.left + radius, track.centery)
        knob_colour = theme.panel if self.on else theme.panel_edge
        draw_dot(canvas.surface, knob, max(radius - unit * _KNOB_INSET, 1.0), knob_colour)
        draw_label(canvas, self.label, box, words.left if self.words[self.on] else track.left, focused=focused)

    def accepted(self, panel: Screen) -> Screen | None:
        """Turn it over."""
        self.turned()
        return panel

    def stepped(self, _steps: int) -> bool:
        """Either direction turns it over."""
        self.turned()
        return True


@dataclass(frozen=True)
class ChoiceItem(LineItem):
    """One of several. options: in words; index: of the present one; choose: another one."""

    label: str
    options: tuple[str, ...]
    index: int
    choose: Callable[[int], None]
    tip: str = ""

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """The label, and the present one between two arrow heads."""
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused)
        left, right = self._chevrons(box, unit)
        colour = theme.accent if focused else theme.faint
        for x, sign in ((left, -1.0), (right, 1.0)):
            tip = complex(x + sign * unit * _CHEVRON[0], box.centery)
            back, half = x - sign * unit * _CHEVRON[0], unit * _CHEVRON[1]
            points = [(tip.real, tip.imag), (back, box.centery - half), (back, box.centery + half)]
            pygame.draw.polygon(canvas.surface, colour, points)
        words = self.options[self.index] if 0 <= self.index < len(self.options) else "?"
        middle = complex((left + right) / 2.0, box.centery)
        write_fitting(canvas, words, _STATE, theme.text, middle, "center", right - left - 2.0 * unit * _CHOICE_GAP)
        draw_label(canvas, self.label, box, left - unit * _CHEVRON[0], focused=focused)

    def _chevrons(self, box: pygame.Rect, unit: float) -> tuple[float, float]:
        """Where the two arrow heads are across, pixels."""
        right = box.right - unit * (_MARGIN + _CHEVRON[0])
        return right - min(unit * 9.5, box.width * (0.5 if self.label else 0.9)), right

    def stepped(self, steps: int) -> bool:
        """The one before or the next one, around the ends."""
        self.choose((self.index + steps) % len(self.options))
        return True

    def accepted(self, panel: Screen) -> Screen | None:
        """The next one."""
        self.stepped(1)
        return panel

    def pointed(self, panel: Screen, pixel: complex, box: pygame.Rect, unit: float, *, clicked: bool) -> Screen | None:
        """The one before with a click on the left half of the words, else the next one."""
        if clicked:
            left, right = self._chevrons(box, unit)
            self.stepped(-1 if left - unit <= pixel.real < (left + right) / 2.0 else 1)
        return panel


@dataclass(frozen=True)
class TableRow(Item):
    """A row of a table. cells: words, their part of the width, and where they stand: left, right or centre.

    chosen: where it leads; None for a row that cannot be used. strong: in the accent's colour.
    """

    cells: tuple[tuple[str, float, str], ...]
    chosen: Callable[[], Screen | None] | None = None
    tip: str = ""
    faint: bool = False
    strong: bool = False

    @property
    def focusable(self) -> bool:
        """Where it leads somewhere."""
        return self.chosen is not None

    def height(self, _type: Type, _unit: float, _width: float) -> float:
        """One line."""
        return 1.5 if self.chosen is None else 1.75

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """The words, each in its column."""
        unit = canvas.unit
        draw_focus(canvas, box, focused=focused)
        total, left = sum([share for _, share, _ in self.cells]), float(box.left) + unit * _MARGIN
        room = box.width - 2.0 * unit * _MARGIN
        for words, share, side in self.cells:
            width = room * share / total
            inner = width - unit * 0.5
            x = {"left": left, "right": left + inner, "centre": left + inner / 2.0}[side]
            anchor = {"left": "midleft", "right": "midright", "centre": "center"}[side]
            write_fitting(
                canvas, words, 1.05, self._colour(canvas.theme, focused=focused), complex(x, box.centery), anchor, inner
            )
            left += width

    def _colour(self, theme: Theme, *, focused: bool) -> Colour:
        """Of the words."""
        if focused or self.strong:
            return theme.accent
        return theme.faint if self.faint else theme.text

    def accepted(self, panel: Screen) -> Screen | None:
        """Where it leads."""
        return panel if self.chosen is None else self.chosen()


@dataclass(frozen=True)
class Drawing(Item):
    """A picture. tall: its height, less where that is more than `most` of its width; paint: draws it in a box of pixels."""

    tall: float
    paint: Callable[[Canvas, pygame.Rect], None]
    share: float = 1.0
    most: float = math.inf

    def height(self, _type: Type, unit: float, width: float) -> float:
        """As it was given."""
        return min(self.tall, self.most * width / unit)

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:  # noqa: ARG002  # it never is
        """The picture."""
        self.paint(canvas, box)


def _faded(theme: Theme) -> Theme:
    """The colours of what cannot be used."""
    text, accent, edge = (mixed(theme.panel, colour, _FADED) for colour in (theme.text, theme.accent, theme.panel_edge))
    return theme._replace(text=text, accent=accent, panel_edge=edge)
