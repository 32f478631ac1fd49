"""The shapes that marks are drawn as, from back to front."""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from game.drawing.palette import Colour, Theme, mixed
from game.lab.drawing.colours import role_colour
from game.lab.drawing.seen import SeenPane, arc_pixels, is_near
from game.lab.drawing.shapes import ColourGrid, FilledPolygon, PixelShape, Polyline, Round
from game.lab.drawing.wanted_labels import SHORTEST
from game.lab.kit.picture import (
    AnnularSector,
    Annulus,
    Arc,
    Arrow,
    Circle,
    Disc,
    FieldValues,
    Line,
    Mark,
    PointMark,
    ScalarField,
    Stroke,
    Words,
)

_WIDTHS = {Stroke.SOLID: 0.1, Stroke.THICK: 0.2, Stroke.DASHED: 0.1}
"""Of lines, in units."""
_DASH = 0.5
"""Length of a dash, in units."""
_BALL_OPACITY = 0.235
"""What a ball overlaps can be seen through it."""
_POINT = 0.24
"""Radius of a point, in units."""
_EDGE, _LEAST_EDGE = 0.12, 2.0
"""Width of a sector's outline, in units, and at least, pixels."""
_LARGE = 8e3
"""Pixels: of a circle with a larger radius only the part in sight is drawn, as an arc."""
_LARGEST = 1e6
"""Pixels: a filled circle of a larger radius is not drawn."""
_CELL, _LEAST_CELL = 0.55, 5.0
"""Width of a field's cells in units, and at least, pixels."""
_SHADES, _FULL = 64, 0.8
"""Shades of a field's two colours; opacity of the full ones."""


def shapes_of(canvas: SeenPane, marks: Sequence[Mark]) -> list[PixelShape]:
    """The shapes of every mark whose toggle is on, without its words."""
    return [shape for mark in marks if mark.toggle is None or mark.toggle in canvas.shown for shape in _shapes(canvas, mark)]


def _shapes(canvas: SeenPane, mark: Mark) -> list[PixelShape]:  # noqa: C901, PLR0911  # a table of all kinds of marks
    """The shapes of one mark."""
    project = canvas.camera.project
    colour = canvas.theme.text if isinstance(mark, ScalarField) else role_colour(canvas.theme, mark.role)
    match mark:
        case Disc():
            return _ball(canvas, mark, colour)
        case Circle(centre, radius):
            return [_circle(canvas, centre, radius, colour, mark.stroke)]
        case AnnularSector():
            return _sector(canvas, mark, colour)
        case Annulus():
            return _annulus(canvas, mark, colour)
        case Line(points):
            return [_stroke(canvas, [project(point) for point in points], colour, mark.stroke)]
        case Arrow():
            return _arrow(canvas, mark, colour)
        case PointMark(position):
            return [Round(project(position), canvas.unit * _POINT, colour)]
        case Arc(centre, radius, start, sweep):
            return [_stroke(canvas, arc_pixels(canvas.camera, centre, radius, start, sweep), colour, mark.stroke)]
        case ScalarField():
            return _field(canvas, mark)
        case Words():
            return []


def _stroke(canvas: SeenPane, pixels: Sequence[complex], colour: Colour, stroke: Stroke) -> Polyline:
    """A line through pixels."""
    dash = canvas.unit * _DASH if stroke is Stroke.DASHED else 0.0
    return Polyline(tuple(pixels), colour, canvas.unit * _WIDTHS[stroke], dash)


def _circle(canvas: SeenPane, centre: complex, radius: float, colour: Colour, stroke: Stroke) -> PixelShape:
    """The line of a circle. centre, radius: world units."""
    pixels, middle = radius * canvas.camera.scale, canvas.camera.project(centre)
    if stroke is Stroke.DASHED or not (is_near(middle) and pixels < _LARGE):
        return _stroke(canvas, arc_pixels(canvas.camera, centre, radius, 0.0, math.tau), colour, stroke)
    return Round(middle, pixels, colour, max(round(canvas.unit * _WIDTHS[stroke]), 1))


def _ball(canvas: SeenPane, mark: Disc, colour: Colour) -> list[PixelShape]:
    """A translucent disc with a line around it."""
    centre, radius = canvas.camera.project(mark.centre), mark.radius * canvas.camera.scale
    if not is_near(centre) or not 1.0 <= radius < _LARGEST:
        return []
    line = _circle(canvas, mark.centre, mark.radius, colour, Stroke.SOLID)
    return [Round(centre, radius, colour, 0.0, _BALL_OPACITY), line]


def _sector(canvas: SeenPane, mark: AnnularSector, colour: Colour) -> list[PixelShape]:
    """A filled sector with a line around it."""
    inner, outer = max(mark.radius - mark.half_width, 0.0), mark.radius + mark.half_width
    outer_arc = arc_pixels(canvas.camera, 0j, outer, mark.angle - mark.half_angle, 2.0 * mark.half_angle)
    inner_arc = arc_pixels(canvas.camera, 0j, inner, mark.angle + mark.half_angle, -2.0 * mark.half_angle)
    fill = mixed(canvas.theme.ground, colour, mark.opacity)
    edge = mixed(canvas.theme.ground, mixed(colour, canvas.theme.text, 0.45), mark.opacity)
    outline = [pixel for pixel in outer_arc + inner_arc if is_near(pixel)]
    if len(outline) < 3:
        return []
    width = max(canvas.unit * _EDGE, _LEAST_EDGE)
    shapes: list[PixelShape] = [FilledPolygon(tuple(_inset(canvas, mark, width / 4.0)), fill)]
    if mark.half_angle >= math.pi:
        return shapes + [_circle(canvas, 0j, radius, edge, Stroke.SOLID) for radius in (inner, outer)]
    ends = ((outer_arc[-1], inner_arc[0]), (inner_arc[-1], outer_arc[0]))
    return shapes + [Polyline(tuple(pixels), edge, width) for pixels in (outer_arc, inner_arc, *ends)]


def _inset(canvas: SeenPane, mark: AnnularSector, pixels: float) -> list[complex]:
    """A sector's outline, its arcs moved inwards: a filled polygon has no smooth edge, so its line's must cover it."""
    half_width = max(mark.half_width - pixels / canvas.camera.scale, 0.5 * mark.half_width)
    inner, outer = max(mark.radius - half_width, 0.0), mark.radius + half_width
    there = arc_pixels(canvas.camera, 0j, outer, mark.angle - mark.half_angle, 2.0 * mark.half_angle)
    back = arc_pixels(canvas.camera, 0j, inner, mark.angle + mark.half_angle, -2.0 * mark.half_angle)
    return [pixel for pixel in there + back if is_near(pixel)]


def _annulus(canvas: SeenPane, mark: Annulus, colour: Colour) -> list[PixelShape]:
    """A faint ring with its two circles."""
    scale, centre = canvas.camera.scale, canvas.camera.project(0j)
    shapes: list[PixelShape] = []
    if mark.outer * scale < _LARGEST:
        fill = mixed(canvas.theme.ground, colour, mark.opacity)
        width = 0.0 if mark.inner <= 0.0 else max((mark.outer - mark.inner) * scale, 1.0)
        shapes.append(Round(centre, mark.outer * scale - width / 2.0, fill, width))
    edge = mixed(canvas.theme.ground, colour, min(2.2 * mark.opacity, 1.0))
    return shapes + [_circle(canvas, 0j, radius, edge, Stroke.SOLID) for radius in (mark.inner, mark.outer) if radius > 0.0]


def _arrow(canvas: SeenPane, mark: Arrow, colour: Colour) -> list[PixelShape]:
    """A vector with its head; nothing for the vector 0."""
    start, tip = canvas.camera.project(mark.start), canvas.camera.project(mark.start + mark.vector)
    length = abs(tip - start)
    if length < SHORTEST or not (is_near(start) and is_near(tip)):
        return []
    along = (tip - start) / length
    head = min(canvas.unit * (0.75 if mark.stroke is Stroke.SOLID else 0.95), length * 0.7)
    corners = (tip, tip - along * head + along * 0.38j * head, tip - along * head - along * 0.38j * head)
    return [_stroke(canvas, [start, tip - along * head * 0.8], colour, mark.stroke), FilledPolygon(corners, colour)]


def _field(canvas: SeenPane, mark: ScalarField) -> list[PixelShape]:
    """The cells in sight, in two colours that fade to the ground's where the number is 0."""
    camera, cell = canvas.camera, max(canvas.unit * _CELL, _LEAST_CELL) / canvas.camera.scale
    lower_left = camera.unproject(complex(canvas.corner.real, canvas.corner.imag + canvas.extent.imag))
    upper_right = camera.unproject(complex(canvas.corner.real + canvas.extent.real, canvas.corner.imag))
    left, right = (_cells_between(one.real, mark.lower.real, mark.upper.real, cell) for one in (lower_left, upper_right))
    low, high = (_cells_between(one.imag, mark.lower.imag, mark.upper.imag, cell) for one in (lower_left, upper_right))
    columns, rows = right - left + 1, high - low + 1
    positions = _Cells(mark.lower + complex(left, low) * cell, cell, columns, rows)
    colours = _field_colours(mark.values, mark.span, positions, canvas.theme)
    size = (max(round(columns * cell * camera.scale), 1), max(round(rows * cell * camera.scale), 1))
    return [ColourGrid(camera.project(positions.lower + 1j * rows * cell), size, columns, colours)]


class _Cells(NamedTuple):
    """Cells of a field in sight. lower: the lower left corner; cell: the width of each; world units."""

    lower: complex
    cell: float
    columns: int
    rows: int


def _cells_between(at: float, low: float, high: float, cell: float) -> int:
    """The number of cells from the lower border of a field to a coordinate within it."""
    return math.floor((min(max(at, low), high) - low) / cell)


@lru_cache(maxsize=8)
def _field_colours(values: FieldValues, span: float, cells: _Cells, theme: Theme) -> tuple[Colour, ...]:
    """The colour of every cell, row by row from the top. Cached: it takes some time, and stays while nothing moves."""
    lower, cell, columns, rows = cells
    above = [mixed(theme.ground, theme.layers[0], _FULL * k / _SHADES) for k in range(_SHADES + 1)]
    below = [mixed(theme.ground, theme.danger, _FULL * k / _SHADES) for k in range(_SHADES + 1)]
    first = lower + complex(0.5, rows - 0.5) * cell
    colours = []
    for row in range(rows):
        for column in range(columns):
            share = values.at(first + complex(column, -row) * cell) * _SHADES / span
            colours.append(above[min(round(share), _SHADES)] if share >= 0.0 else below[min(round(-share), _SHADES)])
    return tuple(colours)
