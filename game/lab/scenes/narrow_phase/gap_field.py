"""The gap between a ball and a sector, and the normal, at every position of the ball."""

import math
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import FEATURE_WORDS, ball_marks, contact_marks, is_unit, outline_points, second_opinion, two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    Arc,
    Arrow,
    Line,
    Mark,
    Picture,
    Prediction,
    Role,
    ScalarField,
    Stroke,
    Toggle,
    Words,
    in_steps,
    one_step,
)
from game.lab.kit.scene import Claim, EngineUse, LabScene, Preset, ViewBox
from physics import Ball, Contact, Feature, Ring, contact, length, to_cartesian
from physics.narrow_phase import end_contact, end_normal, face_contact

_BOX = ViewBox(1.5 + 1.6j, 10.2 + 6.2j)
_HALF, _NORMALS_HALF = 26 + 14j, 15 + 8j
"""Half of what the field covers, and of what the drawn normals do, around the view's centre."""
_BAND, _SPAN = 1.0, 7.0
_SPACING, _ARROW = 1.7, 0.65
_SAMPLES = 32
_FAR = 40.0
_ROLES = {Feature.OUTER_FACE: Role.GOOD, Feature.INNER_FACE: Role.TWO, Feature.END: Role.THREE, Feature.CORNER: Role.FOUR}


class _BallAndSector(NamedTuple):
    """A ball, a sector, and where the two are nearest."""

    ball: Ball
    ring: Ring
    found: Contact


class _Outline(NamedTuple):
    """A sector, seen from its middle angle: its distances, computed independently of the code that the scene shows.

    turn: that takes its middle to the x axis. end: unit, along its upper end; 0 for a closed ring.
    """

    turn: complex
    end: complex
    radius: float
    half_width: float

    @classmethod
    def of(cls, ring: Ring) -> "_Outline":
        """Of a ring's first sector."""
        end = 0j if ring.half_angle >= math.pi else to_cartesian(1.0, ring.half_angle)
        return cls(to_cartesian(1.0, -ring.phase), end, ring.radius, ring.half_width)

    def distance(self, p: complex) -> float:
        """Of a point, below 0 inside."""
        turned = self.turn * p
        x, y = turned.real, abs(turned.imag)
        face = abs(math.hypot(x, y) - self.radius) - self.half_width
        if self.end == 0.0:
            return face
        along, beside = self.end.real * x + self.end.imag * y, self.end.real * y - self.end.imag * x
        inner, outer = self.radius - self.half_width, self.radius + self.half_width
        far = math.hypot(along - min(max(along, inner), outer), beside)
        if math.atan2(y, x) > math.atan2(self.end.imag, self.end.real):
            return far
        return face if face > 0.0 else max(face, -far)


class _BandedGap(NamedTuple):
    """The gap of a ball anywhere, every other band of it fainter."""

    outline: _Outline
    ball_radius: float

    def at(self, p: complex) -> float:
        """With the ball's centre at a point."""
        gap = self.outline.distance(p) - self.ball_radius
        return gap if math.floor(gap / _BAND) % 2 == 0 else 0.7 * gap


def _ball_and_sector(given: Given) -> _BallAndSector:
    """The ball and the sector that the values make."""
    ring = Ring(given.number("radius"), given.number("half_width"), given.angle("half_angle"), 1, given.angle("angle"))
    ball = Ball(given.point("ball"), 0j, given.number("r"))
    return _BallAndSector(ball, ring, contact(ball, ring, 0))


def _picture(given: Given) -> Picture:
    """Bands of equal gap, normals on a coarse grid, the borders between faces, ends and corners, and the ball."""
    ball, ring, found = _ball_and_sector(given)
    bands = _BandedGap(_Outline.of(ring), ball.radius)
    field: list[Mark] = [ScalarField(_BOX.centre - _HALF, _BOX.centre + _HALF, bands, _SPAN, Toggle.BANDS), *_sides(ring)]
    p, q = ball.position, found.point
    closest, drawn_gap, normal, *touch = contact_marks(ball, found)
    gap = (
        f"gap = |p - q| - r = {length(p - q):.3f} - {ball.radius:g} = {length(p - q) - ball.radius:.3f}"
        if not _is_inside(p, ring)
        else f"gap = -|p - q| - r = -{length(p - q):.3f} - {ball.radius:g} = {found.gap:.3f}"
    )
    legend = (
        f"nearest: {FEATURE_WORDS[found.feature]};   bands of colour, {_BAND:g} wide: blue for gaps above 0, red for overlaps"
    )
    steps = (
        one_step("a ball and a sector, and the gap at every position of the ball", [*field, *ball_marks(p, ball.radius)]),
        one_step("the gap", [closest, drawn_gap], [gap]),
        one_step(
            "n, its gradient",
            [normal, *touch],
            [f"p = {two_decimals(p)},   q = {two_decimals(q)},   n = {two_decimals(found.normal)}"],
            Prediction("n", q, q + found.normal),
        ),
        one_step(
            "the normals everywhere, and where they jump",
            [
                *[Line(points, Role.PLAIN, None, Stroke.DASHED) for points in _borders(ring)],
                *_normals(ball.radius, ring),
                *_legend(ring),
                *second_opinion(given, ball, ring, (0,), found),
            ],
            [legend],
        ),
    )
    return in_steps(steps, _cited(found), _note(ball, ring))


def _sides(ring: Ring) -> list[Mark]:
    """The sector's outline only, since the field colours its inside."""
    start, sweep = ring.phase - ring.half_angle, 2.0 * ring.half_angle
    marks: list[Mark] = [
        Arc(0j, radius, start, sweep, Role.SECTOR, None, Stroke.THICK) for radius in (ring.inner_radius, ring.outer_radius)
    ]
    if ring.half_angle < math.pi:
        ends = [source.end_points(ring.radius, ring.half_width, angle) for angle in (start, start + sweep)]
        marks += [Line(end, Role.SECTOR, None, Stroke.THICK) for end in ends]
    return marks


def _legend(ring: Ring) -> list[Mark]:
    """What the colours of the arrows mean, each in its region."""
    turn = to_cartesian(1.0, ring.phase)
    positions = {
        Feature.OUTER_FACE: complex(ring.outer_radius + 2.0, 0.0),
        Feature.INNER_FACE: complex(max(ring.inner_radius - 1.0, 0.3), 0.0),
    }
    if ring.half_angle < math.pi:
        end = to_cartesian(1.0, -ring.half_angle)
        positions[Feature.END] = end * complex(ring.radius, -1.4)
        positions[Feature.CORNER] = end * complex(ring.outer_radius + 1.5, -1.2)
    return [
        Words(turn * position, FEATURE_WORDS[feature], _ROLES[feature], Toggle.NORMALS)
        for feature, position in positions.items()
    ]


def _borders(ring: Ring) -> list[tuple[complex, ...]]:
    """The lines on which two parts of the sector are equally near."""
    inner, outer, half = ring.inner_radius, ring.outer_radius, ring.half_angle
    turn = to_cartesian(1.0, ring.phase)
    if half >= math.pi:
        return [tuple([turn * to_cartesian(ring.radius, math.tau * k / _SAMPLES) for k in range(_SAMPLES + 1)])]
    end, square = to_cartesian(1.0, half), to_cartesian(1.0, half + math.pi / 2.0)
    lines: list[tuple[complex, ...]] = [(0j, end * inner), (end * outer, end * _FAR)]
    for corner in (end * inner, end * outer):
        reach = min(_FAR, corner.imag / -square.imag) if square.imag < 0.0 else _FAR
        lines.append((corner, corner + square * reach))
    depth = min(ring.half_width / ring.radius, math.sin(min(half, math.pi / 2.0)))
    sines = [depth * k / _SAMPLES for k in range(_SAMPLES + 1)]
    lines += [
        tuple([to_cartesian(face / (1.0 + sign * s), half - math.asin(s)) for s in sines])
        for face, sign in ((outer, 1), (inner, -1))
    ]
    sides = [tuple([turn * point for point in line]) for line in lines]
    sides += [tuple([turn * point.conjugate() for point in line]) for line in lines]
    middle = max(half - math.asin(depth), 0.0)
    ridge = [turn * to_cartesian(ring.radius, middle * (2.0 * k / _SAMPLES - 1.0)) for k in range(_SAMPLES + 1)]
    return [*sides, (0j, -turn * _FAR), tuple(ridge)]


def _normals(ball_radius: float, ring: Ring) -> list[Mark]:
    """A normal at every point of a coarse grid, in the colour of the feature that is nearest there."""
    across, up = round(_NORMALS_HALF.real / _SPACING), round(_NORMALS_HALF.imag / _SPACING)
    positions = [_BOX.centre + complex(i, j) * _SPACING for i in range(-across, across + 1) for j in range(-up, up + 1)]
    marks: list[Mark] = []
    for position in positions:
        found = contact(Ball(position, 0j, ball_radius), ring, 0)
        vector = found.normal * _ARROW
        marks.append(Arrow(position - vector / 2.0, vector, _ROLES[found.feature], Toggle.NORMALS, Stroke.SOLID))
    return marks


def _is_inside(p: complex, ring: Ring) -> bool:
    """Whether a point lies in the material."""
    return _Outline.of(ring).distance(p) < 0.0


def _cited(found: Contact) -> CitedLine:
    """The line that found the normal."""
    if found.feature is Feature.CORNER:
        return code_line(end_contact, "feature = Feature.CORNER if end.q in (end.a, end.b) else Feature.END")
    if found.feature is Feature.END:
        return code_line(end_normal, "return unit(p - end.q) if end.q in (end.a, end.b) and distance > 0.0 else end.outward")
    return code_line(face_contact, "if distance < ring.radius:")


def _note(ball: Ball, ring: Ring) -> str:
    """What is special at this position."""
    if ball.position == 0.0:
        return "The centre: every point of the inner face is equally near. By convention the ball's angle is 0 there."
    if _is_inside(ball.position, ring):
        return "Inside the material |p - q| is the distance to the nearest side, and n points out through that side."
    if ring.half_angle >= math.pi:
        return "φ_p = 180°: a closed ring has no ends and no corners."
    return "On a dashed border two parts of the sector are equally near. The normal may jump there; the gap never does."


def _check(given: Given) -> tuple[Claim, ...]:
    """The gap is a distance: by its definition, by its slope, and on the line to q."""
    ball, ring, found = _ball_and_sector(given)
    p, r = ball.position, ball.radius
    there = _Outline.of(ring).distance(p)
    other = p + to_cartesian(0.3 + 0.5 * r, 7.0 * (p.real + p.imag))
    gap = contact(Ball(other, 0j, r), ring, 0).gap
    half_way = contact(Ball((p + found.point) / 2.0, 0j, r), ring, 0).gap
    nearest = min([length(p - point) for point in outline_points(ring, _SAMPLES)])
    return (
        Claim("contact() measures the distance that the field shows", abs(found.gap - (there - r)) < 1e-9),
        Claim("no point of the outline is nearer than q", abs(there) <= nearest + 1e-9),
        Claim("halfway to q, half of the distance is left", abs(half_way + r - (found.gap + r) / 2.0) < 1e-9),
        Claim("the gap changes no faster than the ball moves", abs(gap - found.gap) <= length(other - p) + 1e-9),
        Claim("the normal has length 1", is_unit(found.normal)),
        Claim(
            "the normal points from q to p, inside the material from p to q",
            length(p - found.point - found.normal * (found.gap + r)) < 1e-9,
        ),
    )


SCENE = LabScene(
    name="gap-field",
    title="The field of the gap and of its normals",
    idea="The gap has no jumps anywhere around a sector, and the normal is its gradient: at faces, ends and corners alike.",
    functions=("narrow_phase_case_1", "narrow_phase_case_2"),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 8.4 + 6.3j, meaning="the ball's centre"),
        Number("r", "r", "", 0.05, 3.0, 0.5, 0.05, "the ball's radius"),
        Number("radius", "r_p", "", 2.0, 13.0, 5.5, 0.05, "the sector's middle radius"),
        Number("angle", "θ_p", "°", 0.0, 360.0, 20.0, 0.5, "the sector's middle angle"),
        Number("half_width", "w_p", "", 0.05, 1.9, 1.2, 0.05, "its half width"),
        Number("half_angle", "φ_p", "°", 0.5, 180.0, 40.0, 0.5, "its half angle"),
    ),
    handles=(handles.point("ball", "ball", "r"), *handles.sector_handles("radius", "half_width", "angle", "half_angle")),
    view_box=_BOX,
    shows=_picture,
    check=_check,
    rows=(3, 7),
    presets=(
        Preset("beyond a corner", "ball=8.4,6.3"),
        Preset("inside of the material", "ball=3.2,3.7"),
        Preset("on the centre", "ball=0,0"),
        Preset("a wide sector", "half_angle=140&ball=-2.5,-1"),
        Preset("a closed ring", "half_angle=180&ball=1.5,1"),
        Preset("a sliver", "half_angle=0.5&half_width=1.9"),
    ),
    engine_use=EngineUse.TOGGLE,
)
