"""What a pane consists of on the screen: shapes and labels in pixels, y downwards. They are painted, or written as SVG."""

from typing import TYPE_CHECKING, NamedTuple

from game.drawing.palette import Colour

if TYPE_CHECKING:  # a browser has none, and places words itself
    import pygame


class Polyline(NamedTuple):
    """A line through points. width, dash: pixels; dash: length of a dash and of a gap, 0 for a solid line."""

    pixels: tuple[complex, ...]
    colour: Colour
    width: float
    dash: float = 0.0


class FilledPolygon(NamedTuple):
    """A filled polygon."""

    pixels: tuple[complex, ...]
    colour: Colour


class Round(NamedTuple):
    """A circle. radius: to the middle of its line. width: of the line, pixels; 0 for a disc. opacity: 0 to 1, of a disc."""

    centre: complex
    radius: float
    colour: Colour
    width: float = 0.0
    opacity: float = 1.0


class ColourGrid(NamedTuple):
    """Cells of a field, to be stretched over a box.

    corner: its upper left one. size: pixels. colours: row by row from the top.
    """

    corner: complex
    size: tuple[int, int]
    columns: int
    colours: tuple[Colour, ...]


class PlacedLabel(NamedTuple):
    """Words where they are written.

    size: of the letters, pixels. seam: the colour around them. plate: whether it fills their box.
    """

    box: "pygame.Rect"
    text: str
    size: float
    colour: Colour
    seam: Colour
    plate: bool = False


PixelShape = Polyline | FilledPolygon | Round | ColourGrid
