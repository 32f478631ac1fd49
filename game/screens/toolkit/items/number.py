"""A number that is typed into a field, or stepped by the minus and plus signs beside it. Lengths are in units of text."""

from collections.abc import Callable
from dataclasses import dataclass

import pygame

from game.drawing.canvas import Canvas
from game.drawing.text import Type
from game.screens.base import Screen
from game.screens.toolkit.items.basic import LineItem
from game.screens.toolkit.items.slider import FIELD_LETTERS
from game.screens.toolkit.items.text_field import TextField, draw_field
from game.screens.toolkit.plate import LABEL, draw_focus, draw_label, write_fitting

_MARGIN, _INSET = 0.4, 0.15
"""From the signs to the item's right edge, and from the field to its upper and lower edges."""
_FIELD, _FIELD_SHARE, _SIGN = 5.0, 0.36, 1.3
"""Width of the field, its most in the item's, and the width of a sign."""
_CHEVRON = (0.26, 0.32)
"""Half width and half height of a sign."""
_NARROW, _ROW = 13.5, 2.0
"""An item that is narrower has two lines of this height each: what the number is called, and below it the field."""


@dataclass(frozen=True)
class NumberItem(LineItem):
    """A number. words: as it is shown; step: called with a number of steps; field: the text being typed, None if there is none.

    edit: begins to type with the caret at a distance from the field's left edge, pixels; None selects all.
    """

    label: str
    words: str
    step: Callable[[int], None]
    edit: Callable[[float | None], None]
    tip: str = ""
    field: TextField | None = None
    is_typed = True

    def height(self, _type: Type, unit: float, width: float) -> float:
        """The height of one line, or of two where the item is narrow."""
        return _ROW * (2.0 if width < _NARROW * unit else 1.0)

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """Draw the label, and the field between its signs."""
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused and self.field is None)
        field, colour = self.field_box(box, unit), theme.accent if focused else theme.faint
        for sign, sign_box in ((-1.0, self._sign_box(field, unit, -1)), (1.0, self._sign_box(field, unit, 1))):
            middle, (across, down) = complex(*sign_box.center), _CHEVRON
            corners = [middle + unit * complex(sign * x, y) for x, y in ((across, 0.0), (-across, -down), (-across, down))]
            pygame.draw.polygon(canvas.surface, colour, [(corner.real, corner.imag) for corner in corners])
        draw_field(canvas, field, self.words, FIELD_LETTERS, self.field)
        if not self._is_narrow(box, unit):
            draw_label(canvas, self.label, box, field.left - unit * _SIGN, focused=focused)
            return
        pixel, room = complex(box.left + unit * _MARGIN, box.top + unit * _ROW / 2.0), box.width - 2.0 * unit * _MARGIN
        write_fitting(canvas, self.label, LABEL, theme.accent if focused else theme.text, pixel, "midleft", room)

    def field_box(self, box: pygame.Rect, unit: float) -> pygame.Rect:
        """The box of its field, pixels."""
        narrow, inset = self._is_narrow(box, unit), round(unit * _INSET)
        wide = box.width - 2.0 * unit * (_MARGIN + _SIGN) if narrow else min(unit * _FIELD, box.width * _FIELD_SHARE)
        tall = box.height // 2 if narrow else box.height
        field = pygame.Rect(0, 0, round(wide), tall - 2 * inset)
        field.bottomright = (round(box.right - unit * (_MARGIN + _SIGN)), box.bottom - inset)
        return field

    def stepped(self, steps: int) -> bool:
        """Change it by some steps."""
        self.step(steps)
        return True

    def accepted(self, panel: Screen) -> Screen | None:
        """Begin to type it."""
        self.edit(None)
        return panel

    def held_sign(self, pixel: complex, box: pygame.Rect, unit: float) -> int:
        """-1 or +1 for the sign at a pixel, 0 for none."""
        field = self.field_box(box, unit)
        return next((sign for sign in (-1, 1) if self._sign_box(field, unit, sign).collidepoint(pixel.real, pixel.imag)), 0)

    def pointed(self, panel: Screen, pixel: complex, box: pygame.Rect, unit: float, *, clicked: bool) -> Screen | None:
        """A click on a sign steps it, a click in the field begins to type."""
        field = self.field_box(box, unit)
        if not clicked:
            return panel
        if sign := self.held_sign(pixel, box, unit):
            self.step(sign)
        elif field.left <= pixel.real < field.right:
            self.edit(pixel.real - field.left)
        return panel

    def _is_narrow(self, box: pygame.Rect, unit: float) -> bool:
        """Whether it has two lines."""
        return box.width < _NARROW * unit

    def _sign_box(self, field: pygame.Rect, unit: float, sign: int) -> pygame.Rect:
        """The box in which a click hits one of the signs, pixels."""
        box = field.inflate(0, round(2.0 * unit * _INSET))
        box.width = round(unit * _SIGN)
        if sign < 0:
            box.right = field.left
        else:
            box.left = field.right
        return box
