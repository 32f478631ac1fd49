"""A slide as SVG: lines, circles and areas stay what they are, words can be edited, formulas are outlines."""

import base64
import io
from collections.abc import Callable
from xml.sax.saxutils import escape

import pygame

from game.drawing.palette import Colour
from game.lab.drawing.formula_type import EM
from game.lab.drawing.painting import PLATE_OPACITY, cells_picture
from game.lab.drawing.shapes import ColourGrid, FilledPolygon, PixelShape, PlacedLabel, Polyline, Round
from game.lab.export.slide import Slide, SlidePane
from game.lab.typeset.mathtext import outline, set_line
from game.lab.window.presented import PLATE, PlacedRow

_FONT = "FreeSans, Helvetica, Arial, sans-serif"
_BASELINE = 0.8
"""From the top of a line's box to its baseline, in its height, for pygame's own font."""
_OPAQUE = 255.0
_SEAM = 0.15
"""Width of the seam around words, in the size of their letters."""


def svg_of(slide: Slide, is_formula: Callable[[str], bool]) -> str:
    """The document. is_formula: whether a label's text is set as a formula."""
    width, height = slide.size
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">',
        _rect(pygame.Rect(0, 0, width, height), slide.theme.ground),
    ]
    for number, pane in enumerate(slide.panes):
        parts += _pane(pane, number, slide.theme.panel_edge, is_formula)
    parts += [_rect(plate, slide.theme.ground, PLATE / _OPAQUE) for plate in slide.words.plates]
    parts += [_row(row) for row in slide.words.rows]
    return "\n".join([*parts, "</svg>"]) + "\n"


def _pane(pane: SlidePane, number: int, edge: Colour, is_formula: Callable[[str], bool]) -> list[str]:
    """One world, cut off at its borders."""
    x, y, width, height = pane.area
    clip = f'<clipPath id="pane{number}"><rect x="{x}" y="{y}" width="{width}" height="{height}"/></clipPath>'
    line = f'<path d="M{x} {y}v{height}" stroke="{_hex(edge)}"/>' if x > 0 else ""
    shapes = [_shape(shape) for shape in pane.shapes]
    labels = [_label(label, formula=is_formula(label.text)) for label in pane.labels]
    return [clip, f'<g clip-path="url(#pane{number})">', *shapes, *labels, line, "</g>"]


def _shape(shape: PixelShape) -> str:
    """One shape."""
    match shape:
        case Polyline(pixels, colour, width, dash):
            dashes = f' stroke-dasharray="{dash:.1f}"' if dash else ""
            line = f'stroke="{_hex(colour)}" stroke-width="{max(width, 1.0):.1f}"{dashes}'
            return f'<path d="{_path(pixels)}" fill="none" {line}/>'
        case FilledPolygon(pixels, colour):
            return f'<path d="{_path(pixels)}Z" fill="{_hex(colour)}"/>'
        case Round(centre, radius, colour, width, opacity):
            fill = f'fill="none" stroke="{_hex(colour)}" stroke-width="{width:.1f}"' if width else f'fill="{_hex(colour)}"'
            seen = f' fill-opacity="{opacity:.3f}"' if opacity < 1.0 else ""
            return f'<circle cx="{centre.real:.1f}" cy="{centre.imag:.1f}" r="{radius:.1f}" {fill}{seen}/>'
        case ColourGrid():
            return _grid(shape)


def _grid(shape: ColourGrid) -> str:
    """Cells as an embedded picture."""
    file = io.BytesIO()
    pygame.image.save(cells_picture(shape), file, "cells.png")
    data = base64.b64encode(file.getvalue()).decode("ascii")
    x, y, (width, height) = shape.corner.real, shape.corner.imag, shape.size
    box = f'x="{x:.1f}" y="{y:.1f}" width="{width}" height="{height}"'
    return f'<image {box} preserveAspectRatio="none" href="data:image/png;base64,{data}"/>'


def _label(label: PlacedLabel, *, formula: bool) -> str:
    """Words in the picture, with a seam or a plate around them."""
    plate = _rect(label.box, label.seam, PLATE_OPACITY / _OPAQUE) if label.plate else ""
    seam = f'stroke="{_hex(label.seam)}" stroke-width="{label.size * _SEAM:.1f}" paint-order="stroke" stroke-linejoin="round"'
    return plate + _text(label.box, label.text, label.size, label.colour, formula=formula, more=seam)


def _row(row: PlacedRow) -> str:
    """A row of words around the picture."""
    return _text(row.box, row.text, row.size, row.colour, formula=row.is_formula)


def _text(box: pygame.Rect, text: str, size: float, colour: Colour, *, formula: bool, more: str = "") -> str:
    """Words that can be edited, as wide as they are on the screen; a formula as an outline, named by its text."""
    if formula:
        em = float(round(size * EM))
        baseline = box.top + set_line(text, em).baseline
        path = f'<path transform="translate({box.left} {baseline}) scale(1 -1)" d="{outline(text, em)}"'
        return f'<g fill="{_hex(colour)}" {more}><title>{escape(text)}</title>{path}/></g>'
    baseline = round(box.top + _BASELINE * box.height)
    letters = f'font-family="{_FONT}" font-weight="bold" font-size="{size * EM:.1f}" textLength="{box.width}"'
    return f'<text x="{box.left}" y="{baseline}" {letters} fill="{_hex(colour)}" {more}>{escape(text)}</text>'


def _rect(box: pygame.Rect, colour: Colour, opacity: float = 1.0) -> str:
    """A filled rectangle."""
    return (
        f'<rect x="{box.left}" y="{box.top}" width="{box.width}" height="{box.height}" fill="{_hex(colour)}" '
        f'fill-opacity="{opacity:.3f}"/>'
    )


def _path(pixels: tuple[complex, ...]) -> str:
    """A line through points."""
    return "M" + "L".join([f"{pixel.real:.1f} {pixel.imag:.1f}" for pixel in pixels])


def _hex(colour: Colour) -> str:
    """A colour as #rrggbb."""
    return "#{:02x}{:02x}{:02x}".format(*colour)
