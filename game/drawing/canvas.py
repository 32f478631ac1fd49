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
    offset: pixels to the right and down by which all is drawn beside where the camera shows it: cached pictures are the same.
    """

    surface: pygame.Surface
    camera: Camera
    theme: Theme
    type: Type
    unit: float
    ball: str = PLAIN_BALL
    trail: str = PLAIN_TRAIL
    offset: tuple[int, int] = (0, 0)

    @property
    def moved(self) -> "Canvas":
        """The same, the offset being part of the camera: for what is drawn anew anyway."""
        centre = self.camera.centre + complex(*self.offset)
        return self._replace(camera=self.camera._replace(centre=centre), offset=(0, 0))

    def cover(self, picture: pygame.Surface) -> None:
        """Blit a picture as large as the surface; edges that its offset leaves bare show what they do without one."""
        surface, (across, down), (width, height) = self.surface, self.offset, self.size
        surface.blit(picture, self.offset)
        if across:
            left = 0 if across > 0 else width + across
            surface.blit(picture, (left, 0), (left, 0, abs(across), height))
        if down:
            top = 0 if down > 0 else height + down
            surface.blit(picture, (0, top), (0, top, width, abs(down)))

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
