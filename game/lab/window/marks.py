"""Every kind of mark on a pane: first the marks from back to front, then the labels, so that no mark covers them."""

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pygame

from game.drawing.palette import Colour, mixed
from game.lab.kit.picture import (
    AnnularSector,
    Annulus,
    Arc,
    Arrow,
    Circle,
    Disc,
    Field,
    Line,
    Mark,
    PointMark,
    Role,
    Stroke,
    Words,
)
from game.lab.window.canvas import PaneCanvas, arc_pixels, draw_circle, draw_stroke, write_words
from game.lab.window.colours import role_colour, text_colour
from game.lab.window.strokes import draw_disc, draw_path, draw_polygon, draw_segment, is_near, rounded

_BALL_OPACITY = 60
"""Of 255: what a ball overlaps can be seen through it."""
_POINT = 0.24
"""Radius of a point, in units."""
_EDGE = 0.12
"""Width of a sector's outline, in units."""
_LARGEST = 1e6
"""Pixels: a filled circle of a larger radius is not drawn."""
_MOST_CELLS = 16384
"""Pixels: a field drawn wider or higher is left out."""
_SHORTEST = 1.0
"""Pixels: a shorter arrow is left out, and so is its label."""


class _Label(NamedTuple):
    """Words beside a mark. anchor: the point of their box that is at the pixel, as in pygame.Rect."""

    pixel: complex
    text: str
    role: Role
    anchor: str = "center"


def draw_marks(canvas: PaneCanvas, marks: Sequence[Mark]) -> None:
    """Every mark whose toggle is on."""
    seen = [mark for mark in marks if mark.toggle is None or mark.toggle in canvas.shown]
    before = canvas.surface.get_clip()
    canvas.surface.set_clip(canvas.area)
    for mark in seen:
        _draw(canvas, mark)
    taken: list[pygame.Rect] = []
    for mark in seen:
        label = _label(canvas, mark)
        if label is not None:
            colour = text_colour(canvas.theme, label.role)
            box = write_words(canvas, label.pixel, label.text, colour, label.anchor, taken)
            taken += [] if box is None else [box]
    canvas.surface.set_clip(before)


def _draw(canvas: PaneCanvas, mark: Mark) -> None:
    """One mark without its label."""
    project = canvas.camera.project
    colour = canvas.theme.text if isinstance(mark, Field) else role_colour(canvas.theme, mark.role)
    match mark:
        case Disc():
            _draw_ball(canvas, mark, colour)
        case Circle(centre, radius):
            draw_circle(canvas, centre, radius, colour, mark.stroke)
        case AnnularSector():
            _draw_sector(canvas, mark, colour)
        case Annulus():
            _draw_annulus(canvas, mark, colour)
        case Line(points):
            draw_stroke(canvas, [project(point) for point in points], colour, mark.stroke)
        case Arrow():
            _draw_arrow(canvas, mark, colour)
        case PointMark(position):
            draw_disc(canvas.surface, project(position), canvas.unit * _POINT, colour)
        case Arc(centre, radius, start, sweep):
            draw_stroke(canvas, arc_pixels(canvas.camera, centre, radius, start, sweep), colour, mark.stroke)
        case Field():
            _draw_field(canvas, mark)


def _label(canvas: PaneCanvas, mark: Mark) -> _Label | None:
    """The words of a mark, beside it; None for a mark without words."""
    project, unit = canvas.camera.project, canvas.unit
    match mark:
        case PointMark(position, label=text) if text:
            return _Label(project(position) + complex(0.8, -0.8) * unit, text, mark.role)
        case Arrow(start, vector, label=text) if text and abs(vector) * canvas.camera.scale >= _SHORTEST:
            on_screen = vector.conjugate() / abs(vector)
            return _Label(project(start + vector) + on_screen * unit * 0.8, text, mark.role, _anchor(on_screen))
        case Line(points, label=text) if text:
            return _Label((project(points[0]) + project(points[-1])) / 2.0 - 0.9j * unit, text, mark.role)
        case Arc(centre, radius, start, sweep, label=text) if text and abs(sweep) * radius * canvas.camera.scale > unit:
            middle = start + sweep / 2.0
            pixel = project(centre + cmath.rect(radius, middle)) + cmath.rect(1.26 * unit, -middle)
            return _Label(pixel, text, mark.role)
        case Words(position, text) if text:
            return _Label(project(position), text, mark.role)
    return None


def _anchor(direction: complex) -> str:
    """The side of words at the tip of an arrow that faces it. direction: of the arrow on the screen, y downwards."""
    if abs(direction.real) > abs(direction.imag):
        return "midleft" if direction.real > 0.0 else "midright"
    return "midtop" if direction.imag > 0.0 else "midbottom"


def _draw_ball(canvas: PaneCanvas, mark: Disc, colour: Colour) -> None:
    """A translucent disc with a line around it."""
    centre, radius = canvas.camera.project(mark.centre), mark.radius * canvas.camera.scale
    if not is_near(centre) or not 1.0 <= radius < _LARGEST:
        return
    box = pygame.Rect(0, 0, 2 * math.ceil(radius) + 2, 2 * math.ceil(radius) + 2)
    box.center = rounded(centre)
    seen = box.clip(canvas.area)
    if seen.width > 0 and seen.height > 0:
        layer = pygame.Surface(seen.size, pygame.SRCALPHA)
        inside = centre - complex(*seen.topleft)
        pygame.draw.circle(layer, (*colour, _BALL_OPACITY), (inside.real, inside.imag), radius)
        canvas.surface.blit(layer, seen)
    draw_circle(canvas, mark.centre, mark.radius, colour, Stroke.SOLID)


def _draw_sector(canvas: PaneCanvas, mark: AnnularSector, colour: Colour) -> None:
    """A filled sector with a line around it."""
    inner, outer = max(mark.radius - mark.half_width, 0.0), mark.radius + mark.half_width
    outer_arc = arc_pixels(canvas.camera, 0j, outer, mark.angle - mark.half_angle, 2.0 * mark.half_angle)
    inner_arc = arc_pixels(canvas.camera, 0j, inner, mark.angle + mark.half_angle, -2.0 * mark.half_angle)
    fill = mixed(canvas.theme.ground, colour, mark.opacity)
    edge = mixed(canvas.theme.ground, mixed(colour, canvas.theme.text, 0.45), mark.opacity)
    outline = [pixel for pixel in outer_arc + inner_arc if is_near(pixel)]
    if len(outline) < 3:
        return
    draw_polygon(canvas.surface, fill, [(pixel.real, pixel.imag) for pixel in outline])
    width = max(canvas.unit * _EDGE, 2.0)
    if mark.half_angle >= math.pi:
        for radius in (inner, outer):
            draw_circle(canvas, 0j, radius, edge, Stroke.SOLID)
        return
    for arc in (outer_arc, inner_arc):
        draw_path(canvas.surface, arc, edge, width)
    for start, end in ((outer_arc[-1], inner_arc[0]), (inner_arc[-1], outer_arc[0])):
        draw_segment(canvas.surface, start, end, edge, width)


def _draw_annulus(canvas: PaneCanvas, mark: Annulus, colour: Colour) -> None:
    """A faint ring with its two circles."""
    scale, centre = canvas.camera.scale, canvas.camera.project(0j)
    if mark.outer * scale < _LARGEST:
        fill = mixed(canvas.theme.ground, colour, mark.opacity)
        width = 0 if mark.inner <= 0.0 else max(round((mark.outer - mark.inner) * scale), 1)
        pygame.draw.circle(canvas.surface, fill, (centre.real, centre.imag), mark.outer * scale, width)
    edge = mixed(canvas.theme.ground, colour, min(2.2 * mark.opacity, 1.0))
    for radius in (mark.inner, mark.outer):
        if radius > 0.0:
            draw_circle(canvas, 0j, radius, edge, Stroke.SOLID)


def _draw_arrow(canvas: PaneCanvas, mark: Arrow, colour: Colour) -> None:
    """A vector with its head; nothing for the vector 0."""
    start, tip = canvas.camera.project(mark.start), canvas.camera.project(mark.start + mark.vector)
    length = abs(tip - start)
    if length < _SHORTEST or not (is_near(start) and is_near(tip)):
        return
    along = (tip - start) / length
    head = min(canvas.unit * (0.75 if mark.stroke is Stroke.SOLID else 0.95), length * 0.7)
    draw_stroke(canvas, [start, tip - along * head * 0.8], colour, mark.stroke)
    corners = [tip, tip - along * head + along * 0.38j * head, tip - along * head - along * 0.38j * head]
    draw_polygon(canvas.surface, colour, [(corner.real, corner.imag) for corner in corners])
    pygame.draw.aalines(canvas.surface, colour, True, [(corner.real - 0.5, corner.imag - 0.5) for corner in corners])


def _draw_field(canvas: PaneCanvas, mark: Field) -> None:
    """Cells in two colours, fading to the ground's where the number is 0."""
    theme = canvas.theme
    share = np.nan_to_num(np.clip(mark.values / mark.span, -1.0, 1.0))[:, ::-1, None]
    ground = np.array(theme.ground, dtype=np.float64)
    above, below = (np.array(colour, dtype=np.float64) for colour in (theme.layers[0], theme.danger))
    rgb = ground + (above - ground) * np.clip(share, 0.0, 1.0) * 0.8 + (below - ground) * np.clip(-share, 0.0, 1.0) * 0.8
    cells = pygame.surfarray.make_surface(rgb.astype(np.uint8))
    upper_left = canvas.camera.project(complex(mark.lower.real, mark.upper.imag))
    lower_right = canvas.camera.project(complex(mark.upper.real, mark.lower.imag))
    size = (max(round(lower_right.real - upper_left.real), 1), max(round(lower_right.imag - upper_left.imag), 1))
    if max(size) < _MOST_CELLS:
        canvas.surface.blit(pygame.transform.smoothscale(cells, size), rounded(upper_left))
