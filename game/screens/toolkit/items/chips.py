"""A choice among a few values that are all visible side by side. Lengths are in units of text unless pixels are named."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, contrast, mixed
from game.drawing.raster.primitives import draw_box
from game.drawing.text import Type
from game.screens.base import Screen
from game.screens.toolkit.items.basic import Item
from game.screens.toolkit.plate import draw_focus, index_at, write_fitting

_HEIGHT, _GAP, _AROUND = 1.5, 0.2, 0.2
"""Height of a line of chips, between two chips, and from them to the frame around all."""
_LETTERS, _SMALLEST, _ROOM = 1.0, 0.6, 0.3
"""Size of the letters, the least share of it, and from them to the chip's ends. Letters of all chips have the same size."""
_CORNER, _EDGE, _CHOSEN_EDGE = 0.4, 0.06, 0.2
"""Radius of a chip's corners, and widths of its edge."""
_CHOSEN = 0.2
"""Share of the accent's colour in a chosen chip that has no colour of its own."""
_WHITE, _BLACK = (255, 255, 255), (0, 0, 0)


class Chip(NamedTuple):
    """One of the values. colour: of the chip, None for the panel's."""

    label: str
    colour: Colour | None = None


@dataclass(frozen=True)
class ChipsItem(Item):
    """Chips in one or more lines. index: of the chosen one; choose: called with another index; least: width of a chip."""

    chips: tuple[Chip, ...]
    index: int
    choose: Callable[[int], Screen | None]
    tip: str = ""
    least: float = 1.5
    share: float = 1.0

    @property
    def focusable(self) -> bool:
        """True: it can be used."""
        return True

    def height(self, _type: Type, unit: float, width: float) -> float:
        """The height of all lines of chips."""
        return len(self._lines(width, unit)) * (_HEIGHT + _GAP) - _GAP + 2.0 * _AROUND

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """Draw the chips, the chosen one with a thick edge."""
        draw_focus(canvas, box, focused=focused)
        theme, unit = canvas.theme, canvas.unit
        boxes = self.boxes(box, unit)
        size = _LETTERS * min([1.0, *[_fit(canvas, chip.label, place) for chip, place in zip(self.chips, boxes, strict=True)]])
        for index, (chip, place) in enumerate(zip(self.chips, boxes, strict=True)):
            chosen = index == self.index
            plain = mixed(theme.panel, theme.accent, _CHOSEN if chosen else 0.0)
            fill = plain if chip.colour is None else chip.colour
            edge, width = (theme.accent, _CHOSEN_EDGE) if chosen else (theme.panel_edge, _EDGE)
            draw_box(canvas.surface, place, unit * _CORNER, fill, edge, unit * width)
            letters = theme.text
            if chip.colour is not None:
                letters = _WHITE if contrast(_WHITE, fill) > contrast(_BLACK, fill) else _BLACK
            write_fitting(canvas, chip.label, size, letters, complex(*place.center), "center", place.width)

    def boxes(self, box: pygame.Rect, unit: float) -> list[pygame.Rect]:
        """The box of every chip, pixels."""
        inner = box.inflate(-round(2.0 * _AROUND * unit), -round(2.0 * _AROUND * unit))
        lines, gap = self._lines(box.width, unit), unit * _GAP
        pitch, tall = (inner.width + gap) / lines[0], (inner.height + gap) / len(lines)
        found = []
        for row, count in enumerate(lines):
            top, bottom = round(inner.top + row * tall), round(inner.top + (row + 1) * tall - gap)
            for column in range(count):
                left, right = round(inner.left + column * pitch), round(inner.left + (column + 1) * pitch - gap)
                found.append(pygame.Rect(left, top, max(right - left, 1), max(bottom - top, 1)))
        return found

    def stepped(self, steps: int) -> bool:
        """Choose the chip `steps` after the chosen one; the first follows the last."""
        self.choose((self.index + steps) % len(self.chips))
        return True

    def accepted(self, panel: Screen) -> Screen | None:
        """Choose the next chip."""
        self.stepped(1)
        return panel

    def pointed(self, panel: Screen, pixel: complex, box: pygame.Rect, unit: float, *, clicked: bool) -> Screen | None:
        """Choose the chip that is clicked on."""
        index = index_at(self.boxes(box, unit), pixel)
        if clicked and index is not None:
            self.choose(index)
        return panel

    def _lines(self, width: float, unit: float) -> list[int]:
        """The number of chips in every line."""
        count = len(self.chips)
        fitting = max(int((width / unit - 2.0 * _AROUND + _GAP) / (self.least + _GAP)), 1)
        lines = math.ceil(count / fitting)
        most = math.ceil(count / lines)
        return [min(most, count - first) for first in range(0, count, most)]


def _fit(canvas: Canvas, label: str, place: pygame.Rect) -> float:
    """Factor by which a label's letters are made smaller so that it fits into its chip, at most 1."""
    wide = canvas.type.rendered(label, canvas.unit * _LETTERS, _BLACK).get_width()
    return max((place.width - 2.0 * _ROOM * canvas.unit) / max(wide, 1), _SMALLEST)
