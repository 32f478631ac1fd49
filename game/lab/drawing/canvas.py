"""What a pane of the world is drawn with, and how the world lies on it."""

from typing import NamedTuple

import pygame

from game.drawing.camera import Camera
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.lab.drawing.label_boxes import LabelBox
from game.lab.kit.picture import Toggle


class PaneCanvas(NamedTuple):
    """Where and how one pane is drawn.

    area: the pane's part of the surface. unit: pixels, the measure of lines and points. shown: the toggles that are on.
    letters: size of words in the world, in units. focus: the part of the area that nothing lies over; None for all of it.
    plates: whether words stand on plates, which a projector needs.
    """

    surface: pygame.Surface
    area: pygame.Rect
    camera: Camera
    theme: Theme
    type: Type
    unit: float
    shown: frozenset[Toggle]
    letters: float = 0.95
    focus: pygame.Rect | None = None
    plates: bool = False

    @property
    def words_area(self) -> LabelBox:
        """Where words can be read."""
        left, top, width, height = self.area if self.focus is None else self.focus
        return LabelBox(left, top, width, height)

    @property
    def corner(self) -> complex:
        """The upper left corner of the area, pixels."""
        return complex(*self.area.topleft)

    @property
    def extent(self) -> complex:
        """Width and height of the area, pixels."""
        return complex(*self.area.size)

    @property
    def size(self) -> float:
        """Size of words in the world, pixels."""
        return self.unit * self.letters

    def measured(self, text: str) -> tuple[int, int]:
        """Width and height of a line of text, pixels."""
        return self.type.rendered(text, self.size, self.theme.text).get_size()

    def wrapped(self, text: str, width: float) -> list[str]:
        """A text wrapped into lines of at most this width, pixels."""
        return self.type.wrapped(text, self.size, width)
