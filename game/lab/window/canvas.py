"""Marks of the world on a surface, anti-aliased, in the theme's colours."""

import cmath
import math
from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.drawing.camera import Camera
from game.drawing.palette import Colour, Theme, contrast, mixed
from game.drawing.text import Type
from game.lab.kit.picture import (
    Arc,
    Arrow,
    Band,
    Circle,
    Disc,
    Dot,
    Field,
    Line,
    Mark,
    Sector,
    Stroke,
    Toggle,
    Tone,
    Words,
)
from game.lab.kit.scene import View

_PIXELS_PER_CHORD = 3.0
_MOST_CHORDS = 720
_ROUND = 9
"""A line through so many points is a curve."""
_READABLE = 4.5
"""Contrast ratio of text, by WCAG 2."""
_VEIL = 60
"""How opaque a ball is, of 255."""
_WIDTHS = {Stroke.SOLID: 0.1, Stroke.THICK: 0.2, Stroke.DASHED: 0.1}
"""Of lines, in sizes of text."""
_LARGE = 8e3
"""Pixels: circles with a larger radius are drawn as far as they are seen."""
_FAR = 1e6
"""Pixels: nothing is drawn farther out."""


class Canvas(NamedTuple):
    """Where and how the world is drawn."""

    surface: pygame.Surface
    area: pygame.Rect
    camera: Camera
    theme: Theme
    type: Type
    unit: float  # size of body text, pixels
    shown: frozenset[Toggle]


def camera_for(view: View, area: pygame.Rect) -> Camera:
    """The camera that shows a part of the world in the middle of an area, as large as fits."""
    scale = max(min(area.width / (2.0 * view.half.real), area.height / (2.0 * view.half.imag)), 1e-3)
    return Camera(complex(*area.center) - view.centre.conjugate() * scale, scale)


def draw_marks(canvas: Canvas, marks: Sequence[Mark]) -> None:
    """Every mark that is to be shown, from back to front; then the labels, so that nothing covers them."""
    seen = [mark for mark in marks if mark.toggle is None or mark.toggle in canvas.shown]
    before = canvas.surface.get_clip()
    canvas.surface.set_clip(canvas.area)
    for mark in seen:
        _draw(canvas, mark)
    for mark in seen:
        _label(canvas, mark)
    canvas.surface.set_clip(before)


def tone_colour(theme: Theme, tone: Tone) -> Colour:
    """The colour that a role has."""
    return {
        Tone.PLAIN: theme.text,
        Tone.FAINT: mixed(theme.ground, theme.faint, 0.6),
        Tone.BALL: theme.ball,
        Tone.GHOST: theme.faint,
        Tone.SECTOR: theme.paddle,
        Tone.OTHER: mixed(theme.paddle, theme.ground, 0.55),
        Tone.OURS: theme.accent,
        Tone.SOURCE: theme.danger,
        Tone.PYMUNK: theme.layers[2],
        Tone.GOOD: theme.paddle_top,
        Tone.ONE: theme.layers[0],
        Tone.TWO: theme.layers[3],
        Tone.THREE: theme.layers[1],
        Tone.FOUR: theme.layers[5],
    }[tone]


@cache
def ink(theme: Theme, tone: Tone) -> Colour:
    """The colour of words of a role: the role's own, as far towards that of text as it takes to read them on the ground."""
    own = tone_colour(theme, tone)
    shades = [mixed(own, theme.text, share / 8.0) for share in range(9)]
    return next(shade for shade in shades if contrast(shade, theme.ground) >= _READABLE)


def _draw(canvas: Canvas, mark: Mark) -> None:
    """One mark without its label."""
    colour = canvas.theme.text if isinstance(mark, Field) else tone_colour(canvas.theme, mark.tone)
    match mark:
        case Disc():
            _ball(canvas, mark, colour)
        case Circle(centre, radius):
            _circle(canvas, centre, radius, colour, mark.stroke)
        case Sector():
            _sector(canvas, mark, colour)
        case Band():
            _band(canvas, mark, colour)
        case Line(points):
            _path(canvas, [canvas.camera.project(point) for point in points], colour, mark.stroke)
        case Arrow():
            _arrow(canvas, mark, colour)
        case Dot(place):
            _disc(canvas, place, canvas.unit * 0.24, colour)
        case Arc(centre, radius, start, sweep):
            _path(canvas, _arc_points(canvas, centre, radius, start, sweep), colour, mark.stroke)
        case Field():
            _field(canvas, mark)


def _label(canvas: Canvas, mark: Mark) -> None:
    """The words of a mark, beside it."""
    aside, unit = canvas.unit * 0.9, canvas.unit
    match mark:
        case Dot(place, label=text) if text:
            _write(canvas, canvas.camera.project(place) + complex(0.8, -0.8) * unit, text, mark.tone)
        case Arrow(start, way, label=text) if text and way:
            on_screen = way.conjugate() / abs(way)
            _write(canvas, canvas.camera.project(start + way) + on_screen * unit * 0.8, text, mark.tone, _anchor(on_screen))
        case Line(points, label=text) if text:
            middle = (canvas.camera.project(points[0]) + canvas.camera.project(points[-1])) / 2.0
            _write(canvas, middle - 1j * aside, text, mark.tone)
        case Arc(centre, radius, start, sweep, label=text) if text and abs(sweep) * radius * canvas.camera.scale > unit:
            middle = canvas.camera.project(centre + cmath.rect(radius, start + sweep / 2.0))
            _write(canvas, middle + cmath.rect(1.4 * aside, -(start + sweep / 2.0)), text, mark.tone)
        case Words(place, text):
            _write(canvas, canvas.camera.project(place), text, mark.tone)


def write_beside(canvas: Canvas, place: complex, text: str, colour: Colour, anchor: str = "center") -> None:
    """Words at a pixel with a seam in the ground's colour, kept inside the area; none far outside of it.

    anchor: the point of the words that is at the pixel, as in pygame.Rect.
    """
    size = canvas.unit * 0.95
    if not canvas.area.inflate(4 * canvas.unit, 4 * canvas.unit).collidepoint(place.real, place.imag):
        return
    line = canvas.type.rendered(text, size, colour)
    box = line.get_rect(**{anchor: _ints(place)}).clamp(canvas.area.inflate(-4, -4))
    seam = canvas.type.rendered(text, size, canvas.theme.ground)
    width = max(1, round(canvas.unit * 0.09))
    for dx, dy in ((-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, 1), (-1, 1), (1, -1)):
        canvas.surface.blit(seam, box.move(dx * width, dy * width))
    canvas.surface.blit(line, box)


def draw_note(
    surface: pygame.Surface, area: pygame.Rect, text: str, theme: Theme, type_: Type, unit: float, bottom: float
) -> float:
    """Words on a plate in an area; where the plate begins, pixels. bottom: where it ends."""
    lines = type_.wrapped(text, unit, area.width - 4.0 * unit)
    height = round(unit * (1.3 * len(lines) + 0.6))
    wide = max([type_.rendered(line, unit, theme.accent).get_width() for line in lines]) + round(1.6 * unit)
    plate = pygame.Rect(0, 0, wide, height)
    plate.midbottom = (area.centerx, round(bottom))
    pygame.draw.rect(surface, theme.panel, plate, 0, round(unit * 0.5))
    pygame.draw.rect(surface, theme.accent, plate, max(1, round(unit * 0.08)), round(unit * 0.5))
    for k, line in enumerate(lines):
        spot = complex(plate.centerx, plate.top + unit * (0.45 + 1.3 * k))
        type_.write(surface, line, unit, theme.text, spot, "midtop")
    return float(plate.top)


def _anchor(way: complex) -> str:
    """The point of words that are written at the tip of an arrow. way: of the arrow, on the screen."""
    if abs(way.real) > abs(way.imag):
        return "midleft" if way.real > 0.0 else "midright"
    return "midtop" if way.imag > 0.0 else "midbottom"


def _write(canvas: Canvas, place: complex, text: str, tone: Tone, anchor: str = "center") -> None:
    """Words in the colour of a role."""
    write_beside(canvas, place, text, ink(canvas.theme, tone), anchor)


def _ball(canvas: Canvas, mark: Disc, colour: Colour) -> None:
    """A disc that one sees through, with a line around it: what it overlaps is what the lab is about."""
    place, radius = canvas.camera.project(mark.centre), mark.radius * canvas.camera.scale
    if not _near(place) or not 1.0 <= radius < _FAR:
        return
    reach = pygame.Rect(0, 0, 2 * math.ceil(radius) + 2, 2 * math.ceil(radius) + 2)
    reach.center = _ints(place)
    seen = reach.clip(canvas.area)
    if seen.width > 0 and seen.height > 0:
        veil = pygame.Surface(seen.size, pygame.SRCALPHA)
        spot = place - complex(*seen.topleft)
        pygame.draw.circle(veil, (*colour, _VEIL), (spot.real, spot.imag), radius)
        canvas.surface.blit(veil, seen)
    _circle(canvas, mark.centre, mark.radius, colour, Stroke.SOLID)


def _circle(canvas: Canvas, centre: complex, radius: float, colour: Colour, stroke: Stroke) -> None:
    """The line of a circle."""
    pixels, place = radius * canvas.camera.scale, canvas.camera.project(centre)
    if stroke is Stroke.DASHED or not (_near(place) and pixels < _LARGE):
        _path(canvas, _arc_points(canvas, centre, radius, 0.0, math.tau), colour, stroke)
        return
    width = max(round(canvas.unit * _WIDTHS[stroke]), 1)
    pygame.draw.aacircle(canvas.surface, colour, (place.real - 0.5, place.imag - 0.5), pixels + width / 2.0, width)


def _disc(canvas: Canvas, centre: complex, radius: float, colour: Colour) -> None:
    """A disc. radius: pixels."""
    place = canvas.camera.project(centre)
    if _near(place) and radius < _FAR:
        pygame.draw.aacircle(canvas.surface, colour, (place.real - 0.5, place.imag - 0.5), max(radius, 0.5))


def _path(canvas: Canvas, places: Sequence[complex], colour: Colour, stroke: Stroke) -> None:
    """A line through pixels."""
    width = canvas.unit * _WIDTHS[stroke]
    if stroke is Stroke.DASHED:
        for start, end in _dashes(places, canvas.unit * 0.5, canvas.area):
            _stroke(canvas.surface, start, end, colour, width)
        return
    if len(places) >= _ROUND:
        _ribbon(canvas.surface, places, colour, width)
        return
    for start, end in pairwise(places):
        _stroke(canvas.surface, start, end, colour, width)


def _ribbon(surface: pygame.Surface, places: Sequence[complex], colour: Colour, width: float) -> None:
    """A smooth line of many short pieces, its two sides drawn as one."""
    points = np.array(places, dtype=np.complex128) - (0.5 + 0.5j)
    if not (np.abs(points.real).max() < _FAR and np.abs(points.imag).max() < _FAR):
        return
    way = np.gradient(points)
    side = 1j * way / np.maximum(np.abs(way), 1e-9) * max(width - 1.0, 0.0) / 2.0
    left, right = (_pairs(line) for line in (points + side, points - side))
    if width > 1.5:
        pygame.draw.polygon(surface, colour, left + right[::-1])
        pygame.draw.aalines(surface, colour, False, right)
    pygame.draw.aalines(surface, colour, False, left)


def _pairs(points: NDArray[np.complex128]) -> list[list[float]]:
    """Points as pygame takes them."""
    return np.ascontiguousarray(points).view(np.float64).reshape(-1, 2).tolist()


def _dashes(places: Sequence[complex], length: float, area: pygame.Rect) -> list[tuple[complex, complex]]:
    """The dashes of a line through pixels, those in sight."""
    dashes: list[tuple[complex, complex]] = []
    done = 0.0
    room = area.inflate(round(4 * length), round(4 * length))
    for start, end in pairwise(places):
        reach = abs(end - start)
        if reach == 0.0 or not room.clipline(_ints(start), _ints(end)):
            done += reach
            continue
        way = (end - start) / reach
        first, last = _seen_part(start, way, reach, room)
        k = math.floor((done + first) / (2.0 * length))
        while (begin := 2.0 * length * k - done) < last:
            a, b = max(begin, 0.0), min(begin + length, reach)
            if b > a:
                dashes.append((start + way * a, start + way * b))
            k += 1
        done += reach
    return dashes


def _seen_part(start: complex, way: complex, reach: float, room: pygame.Rect) -> tuple[float, float]:
    """From where to where along a line it can be in sight."""
    middle = (complex(*room.center) - start) * way.conjugate()
    around = math.hypot(room.width, room.height) / 2.0
    return max(middle.real - around, 0.0), min(middle.real + around, reach)


def _stroke(surface: pygame.Surface, start: complex, end: complex, colour: Colour, width: float) -> None:
    """A straight anti-aliased line of some width."""
    if not (_near(start) and _near(end)):
        return
    half = 0.5 + 0.5j
    start, end = start - half, end - half
    if width <= 1.5 or start == end:
        pygame.draw.aaline(surface, colour, (start.real, start.imag), (end.real, end.imag))
        return
    side = (end - start) / abs(end - start) * 1j * (width - 1.0) / 2.0
    corners = [start + side, end + side, end - side, start - side]
    pygame.draw.polygon(surface, colour, [(corner.real + 0.5, corner.imag + 0.5) for corner in corners])
    pygame.draw.aalines(surface, colour, True, [(corner.real, corner.imag) for corner in corners])


def _arc_points(canvas: Canvas, centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    """Pixels along an arc, close enough to look round."""
    chords = min(max(math.ceil(abs(sweep) * radius * canvas.camera.scale / _PIXELS_PER_CHORD), 8), _MOST_CHORDS)
    return [canvas.camera.project(centre + cmath.rect(radius, start + sweep * k / chords)) for k in range(chords + 1)]


def _sector(canvas: Canvas, mark: Sector, colour: Colour) -> None:
    """A filled sector with a line around it."""
    inner, outer = max(mark.radius - mark.half_width, 0.0), mark.radius + mark.half_width
    there = _arc_points(canvas, 0j, outer, mark.angle - mark.half_angle, 2.0 * mark.half_angle)
    back = _arc_points(canvas, 0j, inner, mark.angle + mark.half_angle, -2.0 * mark.half_angle)
    fill = mixed(canvas.theme.ground, colour, mark.strength)
    edge = mixed(canvas.theme.ground, mixed(colour, canvas.theme.text, 0.45), mark.strength)
    outline = [place for place in there + back if _near(place)]
    if len(outline) < 3:
        return
    pygame.draw.polygon(canvas.surface, fill, [(place.real, place.imag) for place in outline])
    width = max(canvas.unit * 0.12, 2.0)
    if mark.half_angle >= math.pi:
        for radius in (inner, outer):
            _circle(canvas, 0j, radius, edge, Stroke.SOLID)
        return
    for path in (there, back):
        _ribbon(canvas.surface, path, edge, width)
    for start, end in ((there[-1], back[0]), (back[-1], there[0])):
        _stroke(canvas.surface, start, end, edge, width)


def _band(canvas: Canvas, mark: Band, colour: Colour) -> None:
    """A faint ring with its two circles."""
    fill = mixed(canvas.theme.ground, colour, mark.strength)
    width = (mark.outer - mark.inner) * canvas.camera.scale
    centre = canvas.camera.project(0j)
    if mark.outer * canvas.camera.scale < _FAR:
        pygame.draw.circle(
            canvas.surface,
            fill,
            (centre.real, centre.imag),
            mark.outer * canvas.camera.scale,
            0 if mark.inner <= 0.0 else max(round(width), 1),
        )
    for radius in (mark.inner, mark.outer):
        if radius > 0.0:
            _circle(canvas, 0j, radius, mixed(canvas.theme.ground, colour, min(2.2 * mark.strength, 1.0)), Stroke.SOLID)


def _arrow(canvas: Canvas, mark: Arrow, colour: Colour) -> None:
    """A vector with its head; none for the vector 0."""
    start, tip = canvas.camera.project(mark.start), canvas.camera.project(mark.start + mark.way)
    length = abs(tip - start)
    if length < 1.0 or not (_near(start) and _near(tip)):
        return
    way = (tip - start) / length
    head = min(canvas.unit * (0.75 if mark.stroke is Stroke.SOLID else 0.95), length * 0.7)
    _path(canvas, [start, tip - way * head * 0.8], colour, mark.stroke)
    corners = [tip, tip - way * head + way * 0.38j * head, tip - way * head - way * 0.38j * head]
    pygame.draw.polygon(canvas.surface, colour, [(corner.real, corner.imag) for corner in corners])
    pygame.draw.aalines(canvas.surface, colour, True, [(corner.real - 0.5, corner.imag - 0.5) for corner in corners])


def _field(canvas: Canvas, mark: Field) -> None:
    """Cells in two colours, fading to the ground's where the number is 0."""
    theme = canvas.theme
    share = np.nan_to_num(np.clip(mark.values / mark.span, -1.0, 1.0))[:, ::-1, None]
    ground = np.array(theme.ground, dtype=np.float64)
    above, below = (np.array(colour, dtype=np.float64) for colour in (theme.layers[0], theme.danger))
    rgb = ground + (above - ground) * np.clip(share, 0.0, 1.0) * 0.8 + (below - ground) * np.clip(-share, 0.0, 1.0) * 0.8
    cells = pygame.surfarray.make_surface(rgb.astype(np.uint8))
    low = canvas.camera.project(complex(mark.lower.real, mark.upper.imag))
    high = canvas.camera.project(complex(mark.upper.real, mark.lower.imag))
    size = (max(round(high.real - low.real), 1), max(round(high.imag - low.imag), 1))
    if max(size) < 16384:
        canvas.surface.blit(pygame.transform.smoothscale(cells, size), (round(low.real), round(low.imag)))


def _near(place: complex) -> bool:
    """Whether a pixel is one that can be drawn to."""
    return abs(place.real) < _FAR and abs(place.imag) < _FAR


def _ints(place: complex) -> tuple[int, int]:
    """A pixel as whole numbers."""
    return round(place.real), round(place.imag)
