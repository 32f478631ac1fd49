"""A scene of the lab as a list of primitives: the same shapes that the desktop paints, with their words."""

import textwrap
from collections.abc import Sequence
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.palette import Theme, mixed
from game.lab.drawing.colours import text_colour
from game.lab.drawing.label_boxes import BoxedLabel, LabelBox, boxed_label, boxed_labels
from game.lab.drawing.marks import shapes_of
from game.lab.drawing.shapes import ColourGrid, FilledPolygon, PixelShape, Polyline, Round
from game.lab.drawing.wanted_labels import WantedLabel
from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given
from game.lab.kit.picture import Pane, Toggle
from game.lab.typeset.runs import runs
from game.picture.display_list import DisplayList

_LETTERS = 0.95
"""Size of words in the world, in units."""
_HANDLE, _HANDLE_LINE = 0.42, 0.14
"""Radius of a handle's ring and width of its line, in units."""
_WIDTH, _HEIGHT = 0.58, 1.3
"""Estimated width of a letter and height of a line, in sizes of the letters, since there is no font to measure with."""
_SEAM = (-1.2, 1.2, -1.2j, 1.2j)
"""Around words, pixels."""
_LINES_EDGE, _LINES_HEIGHT = 0.6, 1.25
"""Of a pane's own lines: from the words to its edge in units, height of a line in sizes of the letters."""


class SeenLabPane(NamedTuple):
    """Through what a pane is seen. corner, extent: of its part of the canvas, pixels. unit: the measure of lines and points."""

    corner: complex
    extent: complex
    camera: Camera
    theme: Theme
    unit: float
    shown: frozenset[Toggle]

    @property
    def size(self) -> float:
        """Size of words, pixels."""
        return self.unit * _LETTERS

    @property
    def words_area(self) -> LabelBox:
        """The whole pane."""
        corner, extent = self.corner, self.extent
        return LabelBox(round(corner.real), round(corner.imag), round(extent.real), round(extent.imag))

    def measured(self, text: str) -> tuple[int, int]:
        """Width and height of a line of text, pixels, estimated."""
        return round(len(text) * self.size * _WIDTH), round(self.size * _HEIGHT)

    def wrapped(self, text: str, width: float) -> list[str]:
        """A text wrapped into lines of at most this width, pixels."""
        return textwrap.wrap(text, max(int(width / (self.size * _WIDTH)), 8))


def add_pane(out: DisplayList, pane: Pane, seen: SeenLabPane, handles: Sequence[complex] = ()) -> None:
    """Add a pane: its ground, its marks from back to front, then its labels, so that no mark covers them.

    handles: pixels that labels leave free if there is room elsewhere.
    """
    corner, extent, theme = seen.corner, seen.extent, seen.theme
    box = (corner, corner + extent.real, corner + extent, corner + 1j * extent.imag)
    out.clip(corner, extent)
    out.polygon(box, theme.ground)
    for shape in shapes_of(seen, pane.marks):
        _add_shape(out, shape)
    for label in boxed_labels(seen, pane.marks, pane.title, handles):
        _add_label(out, label, seen)
    _add_lines(out, pane, seen)
    out.clip(0j, 0j)


def add_handles(out: DisplayList, handles: tuple[Handle, ...], given: Given, hovered: Handle | None, seen: SeenLabPane) -> None:
    """Add a ring for each handle; the one under the pointer is bright and says what it changes."""
    out.clip(seen.corner, seen.extent)
    for handle in handles:
        pixel, width = seen.camera.project(handle.position(given)), max(seen.unit * _HANDLE_LINE, 1.5)
        colour = seen.theme.accent if handle is hovered else mixed(seen.theme.ground, seen.theme.text, 0.75)
        out.circle(pixel, seen.unit * _HANDLE + width / 2.0, 2.0 * width, seen.theme.ground)
        out.circle(pixel, seen.unit * _HANDLE, width, colour)
    if hovered is not None:
        pixel = seen.camera.project(hovered.position(given)) + 1.5j * seen.unit
        for label in boxed_label(seen, WantedLabel(pixel, hovered.label, seen.theme.accent)):
            _add_label(out, label, seen)
    out.clip(0j, 0j)


def _add_shape(out: DisplayList, shape: PixelShape) -> None:
    """Add one shape."""
    match shape:
        case Polyline(pixels, colour, width, dash):
            out.line(pixels, max(width, 1.0), colour, 1.0, dash)
        case FilledPolygon(pixels, colour):
            out.polygon(pixels, colour)
        case Round(centre, radius, colour, width, opacity):
            if width:
                out.circle(centre, radius, width, colour)
            else:
                out.disc(centre, radius, colour, opacity)
        case ColourGrid(corner, size, columns, colours):
            out.cells(corner, complex(*size), columns, colours)


def _add_label(out: DisplayList, label: BoxedLabel, seen: SeenLabPane) -> None:
    """Add a label in the middle of its box, with an outline."""
    left, top, width, height = label.box
    pixel = complex(left + width / 2.0, top + height / 2.0)
    for offset in _SEAM:
        out.text(runs(label.text), seen.size, pixel + offset, seen.theme.ground, bold=0.0)
    out.text(runs(label.text), seen.size, pixel, label.colour, bold=0.0)


def _add_lines(out: DisplayList, pane: Pane, seen: SeenLabPane) -> None:
    """Add a pane's own lines at its lower edge, on a plate."""
    corner, extent, theme, size = seen.corner, seen.extent, seen.theme, seen.size
    edge = seen.unit * _LINES_EDGE
    lines = [(part, role) for text, role in pane.lines for part in seen.wrapped(text, extent.real - 2.0 * edge)]
    if not lines:
        return
    height = _LINES_HEIGHT * size * len(lines) + edge
    top = corner + 1j * (extent.imag - height)
    out.polygon((top, top + extent.real, corner + extent, corner + 1j * extent.imag), theme.panel)
    for number, (text, role) in enumerate(lines):
        pixel = top + complex(edge, edge / 2.0 + (number + 0.5) * _LINES_HEIGHT * size)
        out.text(text, size, pixel, text_colour(theme, role), 0.0, bold=0.0)
