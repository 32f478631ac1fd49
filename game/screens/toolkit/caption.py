"""A line that is only read: of what the items below it are, or between buttons."""

from dataclasses import dataclass

import pygame

from game.drawing.canvas import Canvas
from game.drawing.text import Type
from game.screens.toolkit.items import Item
from game.screens.toolkit.plate import write_fitting

_SIZE, _HEIGHT, _GAP = 1.1, 1.45, 0.7
"""Size of letters, height of the line, and from the words to what is said about them; units of text."""


@dataclass(frozen=True)
class Caption(Item):
    """Words, and a note behind them in the second colour. centred: the words, which have no note then."""

    text: str
    note: str = ""
    centred: bool = False
    width_share: float = 1.0

    @property
    def share(self) -> float:
        """Its part of the row's width."""
        return self.width_share

    def height(self, _type: Type, _unit: float, _width: float) -> float:
        """One line."""
        return _HEIGHT

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:  # noqa: ARG002  # it never is
        """Words and note."""
        theme, unit = canvas.theme, canvas.unit
        if self.centred:
            write_fitting(canvas, self.text, _SIZE, theme.text, complex(*box.center), "center", box.width)
            return
        left = complex(box.left, box.centery)
        after = write_fitting(canvas, self.text, _SIZE, theme.text, left, "midleft", box.width).right + unit * _GAP
        if self.note and box.right > after:
            write_fitting(canvas, self.note, _SIZE, theme.faint, complex(after, box.centery), "midleft", box.right - after)
