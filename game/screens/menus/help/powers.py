"""The part of the help about what drops out of bricks: every power-up's sign, and what it does."""

import pygame

from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.overlay.help_words import gauges_words, power_words, powers_words
from game.picture.display_list import DisplayList
from game.picture.moving.drops import add_chip
from game.rules import PowerUp
from game.screens.toolkit.items.basic import Drawing, Item, TextItem
from game.screens.toolkit.layout import Row

_SIGN = 0.16
"""Width of a sign's column, in comparison with the words'."""
_ROW, _ICON = 2.6, 0.95
"""Height of a row and radius of an icon, units of text."""
_painter = DisplayListPainter()


def power_rows() -> tuple[Row, ...]:
    """All power-ups, two in a row."""
    cells = [_cell(kind) for kind in PowerUp]
    rows: list[Row] = [
        (*left, *right)
        for left, right in zip(cells[::2], [*cells[1::2], (TextItem("", share=_SIGN), TextItem(""))], strict=False)
    ]
    head, foot = TextItem(powers_words(), 1.1), TextItem(gauges_words(), 1.0, faint=True)
    return ((head,), (TextItem("", 0.4),), *rows, (foot,))


def _cell(kind: PowerUp) -> tuple[Item, Item]:
    """A power-up's sign and its explanation."""

    def paint(canvas: Canvas, box: pygame.Rect) -> None:
        pixel = complex(*box.center)
        radius = min(canvas.unit * _ICON, box.width * 0.5)
        sign = DisplayList()
        add_chip(sign, kind, pixel, radius, canvas.theme)
        _painter.paint(canvas.surface, canvas.type, sign)

    return Drawing(_ROW, paint, share=_SIGN), TextItem(power_words(kind), 1.0, midway=True)
