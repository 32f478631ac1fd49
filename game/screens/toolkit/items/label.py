"""A line of text: a label of the items below it, or words between buttons."""

from dataclasses import dataclass

import pygame

from game.drawing.canvas import Canvas
from game.drawing.text import Type
from game.screens.toolkit.items.basic import Item
from game.screens.toolkit.plate import write_fitting

_SIZE, _HEIGHT, _GAP = 1.1, 1.45, 0.7
"""Size of letters, height of the line, and from the words to what is said about them; units of text."""
_SMALLER = 0.9
"""Both stay on one line while letters of this share of their size let them."""


@dataclass(frozen=True)
class LabelItem(Item):
    """Words, and a note behind them in the second colour. centred: the words, which have no note then."""

    text: str
    note: str = ""
    centred: bool = False
    share: float = 1.0

    def height(self, type_: Type, unit: float, width: float) -> float:
        """One line; two where the note has no room beside the words."""
        return _HEIGHT * (2.0 if self._is_stacked(type_, unit, width) else 1.0)

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:  # noqa: ARG002  # it never is
        """Words and note."""
        theme, unit = canvas.theme, canvas.unit
        if self.centred:
            write_fitting(canvas, self.text, _SIZE, theme.text, complex(*box.center), "center", box.width)
            return
        stacked = self._is_stacked(canvas.type, unit, box.width)
        first = complex(box.left, box.top + box.height * (0.25 if stacked else 0.5))
        words = write_fitting(canvas, self.text, _SIZE, theme.text, first, "midleft", box.width)
        second = (
            complex(box.left, box.bottom - box.height * 0.25) if stacked else complex(words.right + unit * _GAP, box.centery)
        )
        if self.note:
            write_fitting(canvas, self.note, _SIZE, theme.faint, second, "midleft", box.right - second.real)

    def _is_stacked(self, type_: Type, unit: float, width: float) -> bool:
        """Whether the note is below the words."""
        if not self.note:
            return False
        words, note = (type_.rendered(text, unit * _SIZE, (0, 0, 0)).get_width() for text in (self.text, self.note))
        return words + unit * _GAP + note > width / _SMALLER
