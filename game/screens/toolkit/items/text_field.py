"""A text field: its text, caret and selection as a value, the clipboard, and how it is drawn."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import mixed
from game.drawing.raster.primitives import draw_box
from game.drawing.text import Type
from game.screens.toolkit.plate import write_fitting

_MARGIN, _CORNER, _EDGE, _CARET = 0.5, 0.4, 0.08, 0.1
"""From the text to the field's ends, radius of its corners, widths of its edge and of the caret; units of text."""
_SELECTED = 0.35
"""Share of the accent's colour behind letters that are selected."""
_COMMAND = pygame.KMOD_CTRL | pygame.KMOD_META
_TALL = 1.05
"""Height of the caret, in sizes of the letters."""
_NO_LETTERS = (0, 0, 0)
"""The colour of letters that are only measured."""


class TextField(NamedTuple):
    """What is being typed. caret: letters before it; mark: letters before the other end of the selection."""

    text: str
    caret: int
    mark: int

    @classmethod
    def all_of(cls, text: str) -> "TextField":
        """A text that is selected as a whole: the next letter replaces it."""
        return cls(text, len(text), 0)

    @property
    def selection(self) -> tuple[int, int]:
        """The selected letters: the first, and the one after the last."""
        return min(self.caret, self.mark), max(self.caret, self.mark)

    @property
    def selected(self) -> str:
        """The selected letters."""
        first, end = self.selection
        return self.text[first:end]

    def moved(self, caret: int, *, selects: bool = False) -> "TextField":
        """The caret elsewhere, as far as there is text. selects: from where the selection began."""
        caret = min(max(caret, 0), len(self.text))
        return TextField(self.text, caret, self.mark if selects else caret)

    def typed(self, text: str, longest: int) -> "TextField":
        """With letters in place of the selection. longest: letters that it may have."""
        first, end = self.selection
        room = longest - len(self.text) + (end - first)
        new = "".join([letter for letter in text if letter.isprintable()])[: max(room, 0)]
        return TextField(self.text[:first] + new + self.text[end:], first + len(new), first + len(new))

    def without(self, step: int) -> "TextField":
        """Without the selection, or the letter before (-1) or after (+1) the caret."""
        field = self if self.selected else self.moved(self.caret + step, selects=True)
        return field.typed("", len(self.text))


def after_event(field: TextField, event: pygame.Event, longest: int) -> TextField:
    """A field after a key, or after letters. longest: letters that it may have."""
    if event.type == pygame.TEXTINPUT:
        return field.typed(str(event.text), longest)
    if event.type != pygame.KEYDOWN:
        return field
    if event.mod & _COMMAND:
        return _after_command(field, event.key, longest)
    if event.key in (pygame.K_BACKSPACE, pygame.K_DELETE):
        return field.without(-1 if event.key == pygame.K_BACKSPACE else 1)
    selects = bool(event.mod & pygame.KMOD_SHIFT)
    first, end = field.selection if field.selected and not selects else (field.caret - 1, field.caret + 1)
    to = {pygame.K_LEFT: first, pygame.K_RIGHT: end, pygame.K_HOME: 0, pygame.K_END: len(field.text)}.get(event.key)
    return field if to is None else field.moved(to, selects=selects)


def _after_command(field: TextField, key: int, longest: int) -> TextField:
    """Select all, copy, cut and paste. Without a clipboard there is nothing to paste."""
    if key == pygame.K_a:
        return TextField.all_of(field.text)
    try:
        if key in (pygame.K_c, pygame.K_x) and field.selected:
            pygame.scrap.put_text(field.selected)
            return field.without(1) if key == pygame.K_x else field
        if key == pygame.K_v:
            return field.typed(pygame.scrap.get_text(), longest)
    except pygame.error:
        return field
    return field


def caret_at(type_: Type, text: str, size: float, unit: float, pixels: float) -> int:
    """Letters before the caret that is put at so many pixels from a field's left edge. size: of letters; unit: pixels."""
    ends = [_width(type_, text[:count], unit * size) for count in range(len(text) + 1)]
    return min(range(len(ends)), key=lambda count: abs(ends[count] - (pixels - unit * _MARGIN)))


def draw_field(canvas: Canvas, box: pygame.Rect, text: str, size: float, field: TextField | None = None) -> None:
    """A text in its box; while it is typed, with caret and selection, and so much of it that the caret is seen."""
    theme, unit, surface = canvas.theme, canvas.unit, canvas.surface
    edge = theme.panel_edge if field is None else theme.accent
    draw_box(surface, box, unit * _CORNER, theme.background, edge, unit * _EDGE)
    inner = box.inflate(-round(2.0 * unit * _MARGIN), 0)
    if field is None:
        write_fitting(canvas, text, size, theme.text, complex(inner.left, box.centery), "midleft", inner.width)
        return
    first, end, caret = [_width(canvas.type, field.text[:count], unit * size) for count in (*field.selection, field.caret)]
    left, before = inner.left - max(caret - inner.width, 0), surface.get_clip()
    line = pygame.Rect(0, 0, max(round(unit * _CARET), 1), round(unit * size * _TALL))
    line.midleft = (left + caret, box.centery)
    surface.set_clip(inner.inflate(2 * line.width, 0).clip(before))
    behind = pygame.Rect(left + first, line.top, end - first, line.height)
    pygame.draw.rect(surface, mixed(theme.background, theme.accent, _SELECTED), behind)
    canvas.write(field.text, size, theme.text, complex(left, box.centery), "midleft")
    pygame.draw.rect(surface, theme.accent, line)
    surface.set_clip(before)


def _width(type_: Type, text: str, pixels: float) -> int:
    """The width of a text, pixels."""
    return type_.rendered(text, pixels, _NO_LETTERS).get_width() if text else 0
