"""An item of a panel that sets an amount. Lengths are in units of text unless they are said to be pixels."""

from collections.abc import Callable
from dataclasses import dataclass

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_dot
from game.overlay.toast import draw_bar
from game.screens.base import Screen
from game.screens.toolkit.items import LineItem
from game.screens.toolkit.plate import draw_focus, draw_label

_MARGIN, _STATE = 0.7, 1.0
"""From the words to the edges, and size of the amount's letters."""
_BAR, _BAR_WORDS = (7.0, 0.6), 4.2
"""A slider's bar, and the room for the words at its right."""


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
        """The label, how full it is, and the amount in words."""
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused)
        bar = self.bar(box, unit)
        draw_bar(canvas.surface, bar, self.level, theme)
        grip = complex(bar.left + bar.width * self.level, bar.centery)
        draw_dot(canvas.surface, grip, max(unit * 0.5, 1.0), theme.accent)
        draw_dot(canvas.surface, grip, max(unit * 0.3, 0.5), theme.panel)
        right = complex(box.right - unit * _MARGIN, box.centery)
        canvas.write(self.words, _STATE, theme.text, right, "midright")
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

    def pointed(self, panel: Screen, pixel: complex, box: pygame.Rect, unit: float, *, clicked: bool) -> Screen | None:  # noqa: ARG002
        """To where the mouse points."""
        bar = self.bar(box, unit)
        if pixel.real >= bar.left - unit:
            self.put(min(max((pixel.real - bar.left) / max(bar.width, 1), 0.0), 1.0))
        return panel
