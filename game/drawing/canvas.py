"""What a drawing function draws on and with: one value in place of five arguments."""

from typing import NamedTuple

import pygame

from game.drawing.camera import Camera
from game.drawing.palette import Colour, Theme
from game.drawing.text import Type
from game.picture.view import ArenaView
from game.unlocks import PLAIN_BALL, PLAIN_TRAIL


class Canvas(NamedTuple):
    """A surface, and how things look on it.

    surface: what is drawn on, 32 bits a pixel; where only a part of it is meant, its clip says so.
    camera: from points of the world to pixels of the surface.
    theme: the colours.
    type: the letters.
    unit: pixels; size of body text, and the measure of all spacing.
    ball, trail: names of how balls look, and what they leave behind.
    """

    surface: pygame.Surface
    camera: Camera
    theme: Theme
    type: Type
    unit: float
    ball: str = PLAIN_BALL
    trail: str = PLAIN_TRAIL

    @property
    def view(self) -> ArenaView:
        """Through what a scene is seen on it."""
        return ArenaView(self.camera, self.theme, self.unit, self.size, self.trail)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the surface, pixels."""
        return self.surface.get_size()

    def write(
        self, text: str, size: float, colour: Colour, pixel: complex, anchor: str = "topleft", spacing: float = 0.0
    ) -> pygame.Rect:
        """Draw a line of text and return its box, pixels.

        size: of the letters, in units. pixel: where the box's point named by `anchor` is, as in pygame.Rect. spacing:
        between letters, as a share of their size.
        """
        return self.type.write(self.surface, text, self.unit * size, colour, pixel, anchor, spacing)
