"""The words of a lecture room's picture: where each row stands, so that it can be painted or written as SVG."""

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.drawing.palette import Colour, Theme
from game.drawing.text import Type
from game.lab.drawing.formula_type import FormulaType
from game.lab.kit.picture import Picture
from game.lab.typeset.tex import has_symbols
from game.lab.window.layout import WindowLayout

_EDGE = 0.6
"""At the left and the right of words, in units."""
_GAP = 0.18
"""Between rows, in units."""
_LEAST_ROW = 0.9
"""Height of a row, in units."""
PLATE = 224
"""Opacity of the plate under words, of 255."""


class WordLetters(NamedTuple):
    """The letters of plain words, and those of formulas."""

    words: Type
    formulas: Type

    def of(self, text: str) -> Type:
        """The letters of a sentence: those of formulas where it has a variable in it."""
        return self.formulas if has_symbols(text) else self.words


class PlacedRow(NamedTuple):
    """A row of words. is_formula: whether it is set as one. size: of its letters, pixels."""

    box: pygame.Rect
    text: str
    is_formula: bool
    size: float
    colour: Colour


class PresentedWords(NamedTuple):
    """Rows, and the plates under them."""

    rows: tuple[PlacedRow, ...]
    plates: tuple[pygame.Rect, ...]


def presented_words(
    layout: WindowLayout, letters: WordLetters, theme: Theme, title: str, step: str, picture: Picture
) -> PresentedWords:
    """The title and the step above; below, the formulas that were revealed last, as many as there is room for, and the note."""
    below = _below(layout, letters, theme, picture)
    plates = [layout.head]
    if below:
        top = below[0].box.top - round(layout.unit * _GAP)
        plates.append(pygame.Rect(0, top, layout.size[0], layout.size[1] - top))
    return PresentedWords((*_above(layout, letters, theme, title, step), *below), tuple(plates))


def paint_presented(surface: pygame.Surface, letters: WordLetters, theme: Theme, words: PresentedWords) -> None:
    """Plates and rows onto a surface."""
    for plate in words.plates:
        layer = pygame.Surface(plate.size, pygame.SRCALPHA)
        layer.fill((*theme.ground, PLATE))
        surface.blit(layer, plate)
    for row in words.rows:
        type_ = letters.formulas if row.is_formula else letters.words
        surface.blit(type_.rendered(row.text, row.size, row.colour), row.box)


def _above(layout: WindowLayout, letters: WordLetters, theme: Theme, title: str, step: str) -> list[PlacedRow]:
    """The title, and at the right the step; where there is no room for both, the step alone."""
    unit, head = layout.unit, layout.head
    edge = round(unit * _EDGE)
    rows = [_row(letters.words, title, unit, theme.text), _row(letters.of(step), step, unit, theme.accent)]
    both = rows[0].box.width + rows[1].box.width + 3 * edge <= head.width
    rows[0].box.midleft = edge, head.centery
    if both:
        rows[1].box.midright = head.right - edge, head.centery
    else:
        rows[1].box.midleft = edge, head.centery
    if not step:
        return rows[:1]
    return rows if both else rows[1:]


def _below(layout: WindowLayout, letters: WordLetters, theme: Theme, picture: Picture) -> list[PlacedRow]:
    """The last rows of the formula, and the note, from the bottom upwards."""
    unit, area = layout.unit, layout.words
    edge = round(unit * _EDGE)
    width = area.width - 2 * edge
    room = area.height - 2 * round(unit * _GAP)
    formula = [
        _row(letters.formulas, line, unit, theme.text)
        for text in picture.formula
        for line in letters.formulas.wrapped(text, unit, width)
    ]
    type_ = letters.of(picture.note)
    note = [_row(type_, line, unit, theme.accent) for line in type_.wrapped(picture.note, unit, width)]
    while len(formula) > 1 and _height([*formula, *note], unit) > room:
        formula = formula[1:]
    rows = formula if formula and _height([*formula, *note], unit) > room else [*formula, *note]
    return _stacked(rows, unit, complex(edge, area.bottom - _height(rows, unit) - round(unit * _GAP)))


def _stacked(rows: Sequence[PlacedRow], unit: float, corner: complex) -> list[PlacedRow]:
    """Rows below each other. corner: the upper left one, pixels."""
    left, top = round(corner.real), round(corner.imag)
    for row in rows:
        height = _height([row], unit)
        row.box.midleft = left, top + height // 2
        top += height
    return list(rows)


def _height(rows: Sequence[PlacedRow], unit: float) -> int:
    """Of rows below each other with the gaps between them, pixels."""
    return sum([max(row.box.height, round(unit * _LEAST_ROW)) + round(unit * _GAP) for row in rows])


def _row(type_: Type, text: str, size: float, colour: Colour) -> PlacedRow:
    """A row that is not placed yet."""
    is_formula = isinstance(type_, FormulaType) and type_.sets(text)
    return PlacedRow(type_.rendered(text, size, colour).get_rect(), text, is_formula, size, colour)
