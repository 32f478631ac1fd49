"""A scene of the lab as a list of primitives: the same shapes that the desktop paints, with their words."""

from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.palette import Colour, Theme, mixed
from game.lab.drawing.marks import shapes_of
from game.lab.drawing.shapes import ColourGrid, FilledPolygon, PixelShape, Polyline, Round
from game.lab.drawing.wanted_labels import WantedLabel, wanted_label
from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given
from game.lab.kit.picture import Pane, Toggle
from game.picture.display_list import DisplayList

_LETTERS = 0.95
"""Size of words in the world, in units."""
_HANDLE, _HANDLE_LINE = 0.42, 0.14
"""Radius of a handle's ring and width of its line, in units."""
_WIDTH = 0.56
"""Width of a letter in shares of its size, roughly."""
_ACROSS = {"midleft": 0.0, "bottomleft": 0.0, "midright": 1.0}
_DOWN = {"midtop": 0.6, "midbottom": -0.6, "bottomleft": -0.5}
"""Where words lie beside a pixel, by the point of their box that is there; in shares of their size."""


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


def add_pane(out: DisplayList, pane: Pane, seen: SeenLabPane) -> None:
    """Add a pane: its ground, its marks from back to front, then its words, so that no mark covers them."""
    corner, extent, theme = seen.corner, seen.extent, seen.theme
    box = (corner, corner + extent.real, corner + extent, corner + 1j * extent.imag)
    out.clip(corner, extent)
    out.polygon(box, theme.ground)
    for shape in shapes_of(seen, pane.marks):
        _add_shape(out, shape)
    for mark in pane.marks:
        if mark.toggle is None or mark.toggle in seen.shown:
            label = wanted_label(seen, mark)
            if label is not None:
                _add_label(out, label, seen)
    if pane.title:
        add_words(out, pane.title, seen.size, corner + complex(extent.real / 2.0, seen.unit), theme.text, theme.ground)
    for number, (text, role_text) in enumerate((line, theme.text) for line, _role in pane.lines):
        pixel = corner + complex(seen.unit * 0.6, extent.imag - (len(pane.lines) - number - 0.5) * 1.25 * seen.size)
        add_words(out, text, seen.size, pixel, role_text, theme.ground, 0.0)
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
        add_words(out, hovered.label, seen.size, pixel, seen.theme.accent, seen.theme.ground)
    out.clip(0j, 0j)


def add_words(
    out: DisplayList, words: str, size: float, pixel: complex, colour: Colour, seam: Colour, across: float = 0.5
) -> None:
    """Add words with a seam around them."""
    for offset in (-1.2, 1.2, -1.2j, 1.2j):
        out.text(words, size, pixel + offset, seam, across, bold=0.0)
    out.text(words, size, pixel, colour, across, bold=0.0)


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


def _add_label(out: DisplayList, label: WantedLabel, seen: SeenLabPane) -> None:
    """Add a label, moved into the pane where it stands out of it."""
    across, size = _ACROSS.get(label.anchor, 0.5), seen.size
    pixel = label.pixel + 1j * _DOWN.get(label.anchor, 0.0) * size
    width, low, high = len(label.text) * size * _WIDTH, seen.corner.real + 4.0, seen.corner.real + seen.extent.real - 4.0
    x = min(max(pixel.real, low + width * across), max(high - width * (1.0 - across), low + width * across))
    top, bottom = seen.corner.imag + 0.7 * size, seen.corner.imag + seen.extent.imag - 0.7 * size
    if top - 4.0 * size < pixel.imag < bottom + 4.0 * size:
        y = min(max(pixel.imag, top), bottom)
        add_words(out, label.text, size, complex(x, y), label.colour, seen.theme.ground, across)
