"""Case 2: the ball's angle lies outside of the sector's."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import ball_marks, contact_marks, degrees, gap_words, is_unit, ray, second_opinion, two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    AnnularSector,
    Line,
    Mark,
    Picture,
    PointMark,
    Prediction,
    RevealStep,
    Role,
    Stroke,
    Toggle,
    in_steps,
    one_step,
)
from game.lab.kit.scene import Claim, EngineUse, LabScene, Preset, ViewBox
from physics import (
    Ball,
    Contact,
    Feature,
    Ring,
    angle_of,
    closest_point_on_line,
    contact,
    dot,
    length,
    min_difference,
    narrow_phase_case_1,
    narrow_phase_case_2,
    normalize_angle,
    on_left,
    to_cartesian,
)
from physics.narrow_phase import end_normal

_SAMPLES = 64
_WORDS = {
    Feature.END: "the end itself: the normal is perpendicular to it",
    Feature.CORNER: "a corner, to which the foot is clamped: the normal points from it to p",
    Feature.OUTER_FACE: "the outer face",
    Feature.INNER_FACE: "the inner face",
}


class _EndCase(NamedTuple):
    """The arguments of narrow_phase_case_2, and the end that it chooses.

    sign: 1 the counter-clockwise end, -1 the clockwise one. a, b: the end's inner and outer corner.
    """

    ball: Ball
    theta: float
    radius: float
    angle: float
    half_width: float
    half_angle: float
    sign: int
    a: complex
    b: complex

    @property
    def applies(self) -> bool:
        """Whether the ball's angle lies outside of the sector's."""
        return min_difference(self.theta, self.angle) > self.half_angle

    @property
    def normal(self) -> complex | None:
        """What case 2 answers; None where it is not asked."""
        if not self.applies:
            return None
        return narrow_phase_case_2(
            self.ball.position, self.ball.radius, self.theta, self.radius, self.angle, self.half_width, self.half_angle
        )


def _case(given: Given) -> _EndCase:
    """The call that the values make."""
    ball = Ball(given.point("ball"), 0j, given.number("r"))
    theta, angle, half_angle = angle_of(ball.position), normalize_angle(given.angle("angle")), given.angle("half_angle")
    radius, half_width = given.number("radius"), given.number("half_width")
    sign = 1 if on_left(theta, angle) else -1
    a, b = source.end_points(radius, half_width, angle + sign * half_angle)
    return _EndCase(ball, theta, radius, angle, half_width, half_angle, sign, a, b)


def _ring(case: _EndCase) -> Ring | None:
    """The sector as a ring; None where it has no width, which a ring must have."""
    return Ring(case.radius, case.half_width, case.half_angle, 1, case.angle) if case.half_angle > 0.0 else None


def _picture(given: Given) -> Picture:
    """The sector, the end that is nearer in angle, and the closest point on it."""
    case = _case(given)
    ball, ring = case.ball, _ring(case)
    found = _found(case, ring)
    sector = AnnularSector(case.radius, case.half_width, case.angle, case.half_angle, Role.SECTOR)
    more = second_opinion(given, ball, ring, (0,), found) if ring is not None else ()
    compared, *lines = _formula(case, found)
    steps = [
        one_step("a ball and a sector", [sector, *ball_marks(ball.position, ball.radius)]),
        one_step("θ, the ball's angle: case 2?", [ray(case.theta, 15.0)], [compared]),
    ]
    if case.applies:
        steps += _end_steps(case, found, more, lines)
    else:
        steps.append(one_step("case 1 instead", [*contact_marks(ball, found), *more], lines))
    return in_steps(steps, _cited(case, found), _note(case, found))


def _end_steps(case: _EndCase, found: Contact, more: Sequence[Mark], lines: Sequence[str]) -> list[RevealStep]:
    """Which end, its corners A and B, the closest point q, and n. lines: one for each. more: the second engine's marks."""
    closest, gap, normal, *touch = contact_marks(case.ball, found)
    which, corners, nearest, answer = lines
    middle = to_cartesian(case.radius, case.angle)
    a, b = [PointMark(point, Role.PLAIN, Toggle.CLOSEST, name) for point, name in ((case.a, "A"), (case.b, "B"))]
    return [
        one_step("which end?", [Line((0j, middle * 1.4), Role.FAINT, None, Stroke.DASHED, "θ_p")], [which]),
        one_step("A and B, its corners", [Line((case.a, case.b), Role.PLAIN, Toggle.CLOSEST, Stroke.THICK), a, b], [corners]),
        one_step("q, the closest point of AB", [closest, gap], [nearest], Prediction("q", None, found.point)),
        one_step(
            "n, from q to p",
            [normal, *touch, *more],
            [answer],
            Prediction("n", found.point, found.point + found.normal),
        ),
    ]


def _found(case: _EndCase, ring: Ring | None) -> Contact:
    """Where the ball and the sector are nearest."""
    if ring is not None and not case.applies:
        return contact(case.ball, ring, 0)
    p, r = case.ball.position, case.ball.radius
    q = closest_point_on_line(case.a, case.b, p)
    normal = narrow_phase_case_2(p, math.inf, case.theta, case.radius, case.angle, case.half_width, case.half_angle)
    feature = Feature.CORNER if q in (case.a, case.b) else Feature.END
    return Contact(normal or 1 + 0j, q, length(p - q) - r, feature)


def _formula(case: _EndCase, found: Contact) -> tuple[str, ...]:
    """Which case, which end, and the distance."""
    difference = min_difference(case.theta, case.angle)
    compared = f"min_difference(θ, θ_p) = {degrees(difference)} {'>' if case.applies else '≤'} φ_p = {degrees(case.half_angle)}"
    if not case.applies:
        return (compared, "so this is case 1: a face is nearest", gap_words(found.gap))
    distance = length(case.ball.position - found.point)
    side = "is" if case.sign > 0 else "is not"
    touches = found.gap < 0.0
    answer = f"n = (p - q) / |p - q| = {two_decimals(found.normal)}" if touches else "None"
    return (
        compared,
        f"θ = {degrees(case.theta)} {side} on the left of θ_p = {degrees(case.angle)}: sign = {case.sign}",
        f"A = (r_p - w_p, θ_p + sign φ_p) = {two_decimals(case.a)},   B = (r_p + w_p, θ_p + sign φ_p) = {two_decimals(case.b)}",
        f"q = {two_decimals(found.point)},   p = {two_decimals(case.ball.position)}",
        f"|p - q| = {distance:.3f} {'<' if touches else '≥'} r = {case.ball.radius:g}:   {answer}",
    )


def _cited(case: _EndCase, found: Contact) -> CitedLine:
    """The line that says what the normal is."""
    if not case.applies:
        return code_line(narrow_phase_case_1, "return -n if length(p) < radius else n")
    if found.gap >= 0.0:
        return code_line(narrow_phase_case_2, "if distance >= ball_radius:")
    return code_line(end_normal, "return unit(p - end.q) if end.q in (end.a, end.b) and distance > 0.0 else end.outward")


def _note(case: _EndCase, found: Contact) -> str:
    """What is nearest, or what is degenerate."""
    if case.ball.position == 0.0:
        return "The ball is on the centre: it has no angle, and θ = 0 by convention."
    if case.half_angle == 0.0:
        return "φ_p = 0: the sector is only a segment. A ring of the game cannot have it; case 2 answers all the same."
    if not case.applies and case.half_angle >= math.pi:
        return "φ_p = 180°: the ring is closed. It has no ends, so every ball is case 1."
    if length(case.ball.position - found.point) == 0.0:
        return "p = q: the source leaves out the distance 0. The normal is the end's own."
    return f"Nearest: {_WORDS[found.feature]}."


def _check(given: Given) -> tuple[Claim, ...]:
    """The closest point against many points of the end, the normal against its definition."""
    case = _case(given)
    p, r = case.ball.position, case.ball.radius
    q = closest_point_on_line(case.a, case.b, p)
    distance = length(p - q)
    nearest = min([length(p - (case.a + (case.b - case.a) * (k / _SAMPLES))) for k in range(_SAMPLES + 1)])
    other = closest_point_on_line(*source.end_points(case.radius, case.half_width, case.angle - case.sign * case.half_angle), p)
    normal, ring = case.normal, _ring(case)
    gap = None if ring is None or not case.applies else contact(case.ball, ring, 0).gap
    return (
        Claim("no point of the end is nearer to p than q", distance <= nearest + 1e-9),
        Claim("the other end is no nearer", not case.applies or distance <= length(p - other) + 1e-9),
        Claim("there is a normal exactly where |p - q| < r", (normal is not None) == (case.applies and distance < r)),
        Claim("the normal has length 1", normal is None or is_unit(normal)),
        Claim("the normal points from q to p", normal is None or abs(dot(normal, p - q) - distance) < 1e-9),
        Claim("contact() agrees on the gap", gap is None or abs(gap - (distance - r)) < 1e-9),
    )


SCENE = LabScene(
    name="case-2",
    title="Narrow phase, case 2: an end and its corners",
    idea="Outside of the sector's angle the nearer end is a segment AB; the normal points from its closest point to the ball.",
    functions=("narrow_phase_case_2", "closest_point_on_line", "to_cartesian"),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 9.4 + 3.9j, meaning="the ball's centre"),
        Number("r", "r", "", 0.05, 5.0, 0.9, 0.05, "the ball's radius"),
        Number("radius", "r_p", "", 2.0, 13.0, 10.0, 0.05, "the sector's middle radius"),
        Number("angle", "θ_p", "°", 0.0, 360.0, 0.0, 0.5, "the sector's middle angle"),
        Number("half_width", "w_p", "", 0.05, 1.9, 1.0, 0.05, "its half width"),
        Number("half_angle", "φ_p", "°", 0.0, 180.0, 20.0, 0.5, "its half angle"),
    ),
    handles=(handles.point("ball", "ball", "r"), *handles.sector_handles("radius", "half_width", "angle", "half_angle")),
    view_box=ViewBox(9.4 + 2.5j, 4.0 + 2.9j),
    shows=_picture,
    check=_check,
    rows=(3, 11),
    presets=(
        Preset("beside the end", "ball=9.4,3.9"),
        Preset("outer corner", "ball=10.9,4.4"),
        Preset("inner corner", "ball=8.1,3.6"),
        Preset("the clockwise end", "ball=9.4,-3.9"),
        Preset("case 1 instead", "ball=8.4,1"),
        Preset("no width", "half_angle=0&ball=9.6,0.6"),
        Preset("the ball on the centre", "ball=0,0"),
    ),
    engine_use=EngineUse.TOGGLE,
)
