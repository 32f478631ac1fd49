"""Sliders: a bar with a knob sets an amount. Lengths are in units of text unless pixels are named."""

from collections.abc import Callable
from dataclasses import dataclass

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box, draw_dot
from game.screens.base import Screen
from game.screens.toolkit.items.basic import LineItem
from game.screens.toolkit.items.text_field import TextField, draw_field
from game.screens.toolkit.plate import draw_focus, draw_label

_MARGIN, _WORDS, FIELD_LETTERS = 0.7, 1.0, 1.1
"""From the words to the edges, and sizes of the amount's letters: beside a bar, and in a field."""
_BAR, _BAR_WORDS = (7.0, 0.6), 4.2
"""A slider's bar, and the room for the words at its right."""
_KNOB, _KNOB_HOLE, _CATCH = 0.5, 0.3, 0.75
"""Radii of a knob, of the disc in it, and of what counts as a press on it."""
_FIELD, _FIELD_SHARE, _FIELD_GAP, _FIELD_INSET = 6.4, 0.4, 0.9, 0.1
"""A field's width, and its most in the item's; from the bar to the field; from it to the item's upper and lower edges."""


@dataclass(frozen=True)
class Slider(LineItem):
    """An amount. level: 0 to 1; words: the amount; step: one to the left or right; put: to a level, by the mouse."""

    label: str
    level: float
    words: str
    step: Callable[[int], None]
    put: Callable[[float], None]
    tip: str = ""

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """Draw the label, the bar, and the amount in words."""
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused)
        bar = self.bar(box, unit)
        _draw_bar(canvas, bar, 0.0, self.level)
        right = complex(box.right - unit * _MARGIN, box.centery)
        canvas.write(self.words, _WORDS, theme.text, right, "midright")
        draw_label(canvas, self.label, box, bar.left, focused=focused)

    def bar(self, box: pygame.Rect, unit: float) -> pygame.Rect:
        """Where its bar is, pixels."""
        bar = pygame.Rect(0, 0, round(min(unit * _BAR[0], box.width * 0.35)), max(round(unit * _BAR[1]), 1))
        bar.midright = (round(box.right - unit * (_MARGIN + _BAR_WORDS)), box.centery)
        return bar

    def stepped(self, steps: int) -> bool:
        """A step less or more."""
        self.step(steps)
        return True

    def accepted(self, panel: Screen) -> Screen | None:
        """A step more."""
        self.step(1)
        return panel

    def grip(self, pixel: complex, box: pygame.Rect, unit: float) -> complex | None:
        """From the knob to a pixel that is on it; 0 beside it on the bar, where the knob comes to the pixel."""
        bar = self.bar(box, unit)
        if not bar.left - unit <= pixel.real:
            return None
        return self._offset(pixel, bar) if self._is_on_knob(pixel, bar, unit) else 0j

    def pointed(self, panel: Screen, pixel: complex, box: pygame.Rect, unit: float, *, clicked: bool) -> Screen | None:
        """Set the amount at the mouse; a press on the knob changes nothing yet."""
        bar = self.bar(box, unit)
        if not clicked or (bar.left - unit <= pixel.real and not self._is_on_knob(pixel, bar, unit)):
            self.put(min(max((pixel.real - bar.left) / max(bar.width, 1), 0.0), 1.0))
        return panel

    def _offset(self, pixel: complex, bar: pygame.Rect) -> complex:
        """From the knob's middle to a pixel."""
        return pixel - complex(bar.left + bar.width * self.level, bar.centery)

    def _is_on_knob(self, pixel: complex, bar: pygame.Rect, unit: float) -> bool:
        """Whether a pixel is on the knob."""
        return abs(self._offset(pixel, bar)) <= unit * _CATCH


@dataclass(frozen=True)
class FieldSlider(Slider):
    """An amount that can be typed as well. origin: level from which the bar is filled; field: what is being typed, if anything.

    edit: begin to type, or put the caret at a pixel of the text (pixels from its beginning; None for all of it selected).
    """

    edit: Callable[[float | None], None] = lambda _: None
    origin: float = 0.0
    field: TextField | None = None
    is_typed = True

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """Draw the bar and the amount in a field."""
        draw_focus(canvas, box, focused=focused and self.field is None)
        _draw_bar(canvas, self.bar(box, canvas.unit), self.origin, self.level)
        draw_field(canvas, self.field_box(box, canvas.unit), self.words, FIELD_LETTERS, self.field)

    def bar(self, box: pygame.Rect, unit: float) -> pygame.Rect:
        """Where its bar is, pixels: all that the field leaves."""
        left, right = round(box.left + unit * _MARGIN), round(self.field_box(box, unit).left - unit * _FIELD_GAP)
        bar = pygame.Rect(left, 0, max(right - left, 1), max(round(unit * _BAR[1]), 1))
        bar.centery = box.centery
        return bar

    def field_box(self, box: pygame.Rect, unit: float) -> pygame.Rect:
        """Where its field is, pixels."""
        inset = round(unit * _FIELD_INSET)
        field = pygame.Rect(0, 0, round(min(unit * _FIELD, box.width * _FIELD_SHARE)), box.height - 2 * inset)
        field.midright = (box.right - inset, box.centery)
        return field

    def accepted(self, panel: Screen) -> Screen | None:
        """Type the amount."""
        self.edit(None)
        return panel

    def grip(self, pixel: complex, box: pygame.Rect, unit: float) -> complex | None:
        """As that of a slider, but for the field."""
        return None if self._is_in_field(pixel, box, unit) else super().grip(pixel, box, unit)

    def pointed(self, panel: Screen, pixel: complex, box: pygame.Rect, unit: float, *, clicked: bool) -> Screen | None:
        """Set the amount at the mouse; in the field, begin to type it."""
        if not clicked or not self._is_in_field(pixel, box, unit):
            return super().pointed(panel, pixel, box, unit, clicked=clicked)
        self.edit(pixel.real - self.field_box(box, unit).left)
        return panel

    def _is_in_field(self, pixel: complex, box: pygame.Rect, unit: float) -> bool:
        """Whether a pixel of the item is at the field."""
        return pixel.real >= self.field_box(box, unit).left - unit * _FIELD_GAP / 3.0


def _draw_bar(canvas: Canvas, bar: pygame.Rect, origin: float, level: float) -> None:
    """A bar that is full from one level to another, and its knob there."""
    theme, unit = canvas.theme, canvas.unit
    draw_box(canvas.surface, bar, bar.height / 2.0, theme.panel_edge)
    low, high = sorted((origin, level))
    full = pygame.Rect(bar.left + round(bar.width * low), bar.top, round(bar.width * (high - low)), bar.height)
    draw_box(canvas.surface, full, bar.height / 2.0, theme.accent)
    knob = complex(bar.left + bar.width * level, bar.centery)
    draw_dot(canvas.surface, knob, max(unit * _KNOB, 1.0), theme.accent)
    draw_dot(canvas.surface, knob, max(unit * _KNOB_HOLE, 0.5), theme.panel)
