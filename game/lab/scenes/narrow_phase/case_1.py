"""Case 1: the ball's angle lies within the sector's."""

import math
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import (
    ball_marks,
    contact_marks,
    degrees,
    gap_words,
    is_unit,
    ray,
    ring_marks,
    second_opinion,
    two_decimals,
)
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import Arrow, Circle, Picture, Prediction, Role, Stroke, Toggle, in_steps, one_step
from game.lab.kit.scene import Claim, EngineUse, LabScene, Preset, ViewBox
from physics import (
    Ball,
    Contact,
    Feature,
    Ring,
    angle_of,
    closest_point_on_line,
    contact,
    cross,
    dot,
    length,
    min_difference,
    narrow_phase_case_1,
    to_cartesian,
)
from physics.narrow_phase import contact_above

_SAMPLES = 200


class _FaceCase(NamedTuple):
    """A ball and a sector, case 1's normal, and where the two are nearest."""

    ball: Ball
    ring: Ring
    theta: float
    normal: complex
    found: Contact

    @property
    def applies(self) -> bool:
        """Whether the ball's angle lies within the sector's."""
        return min_difference(self.theta, self.ring.angle(0)) <= self.ring.half_angle

    @property
    def inside(self) -> bool:
        """Whether the ball's centre is in the material."""
        return self.applies and self.ring.inner_radius < length(self.ball.position) < self.ring.outer_radius


def _case(given: Given) -> _FaceCase:
    """The ball and the sector that the values make."""
    ball = Ball(given.point("ball"), 0j, given.number("r"))
    ring = Ring(given.number("radius"), given.number("half_width"), given.angle("half_angle"), 1, given.angle("angle"))
    normal = narrow_phase_case_1(ball.position, ring.radius)
    return _FaceCase(ball, ring, angle_of(ball.position), normal, contact(ball, ring, 0))


def _picture(given: Given) -> Picture:
    """The sector, its middle radius where the sign turns, and the normal."""
    case = _case(given)
    ball, ring = case.ball, case.ring
    p, distance = ball.position, length(ball.position)
    closest, gap, normal, *touch = contact_marks(ball, case.found)
    compared = f"min_difference(θ, θ_p) = {degrees(min_difference(case.theta, ring.angle(0)))}"
    compared += f" {'≤' if case.applies else '>'} φ_p = {degrees(ring.half_angle)}"
    situation = one_step("a ball and a sector", [*ring_marks(ring), *ball_marks(p, ball.radius)])
    angle = one_step("θ, the ball's angle: case 1?", [ray(case.theta, 15.0)], [compared])
    last = [closest, gap, *touch, *second_opinion(given, ball, ring, (0,), case.found)]
    if not case.applies:
        ends = one_step("case 2 instead", [normal, *last], ["so this is case 2: an end is nearest"])
        return in_steps((situation, angle, ends), _cited(case), _note(case))
    n = p / distance if distance else 0j
    outward = Arrow(p, n * 0.8, Role.ONE, None, Stroke.SOLID)
    pushes = [Arrow(p, case.normal * 1.5, Role.SOURCE, Toggle.NORMALS, label="case 1")] if _disagrees(case) else []
    side = "<" if distance < ring.radius else "≥"
    sign = f"|p| = {distance:.3f} {side} r_p = {ring.radius:g}:   {'-n' if side == '<' else 'n'} = {two_decimals(case.normal)}"
    steps = (
        situation,
        angle,
        one_step("the direction away from the centre", [outward], [f"n = p / |p| = {two_decimals(n)}"]),
        one_step(
            "n, by the side of r_p",
            [Circle(0j, ring.radius, Role.FAINT, None, Stroke.DASHED), *pushes, normal],
            [sign],
            Prediction("n", case.found.point, case.found.point + case.found.normal),
        ),
        one_step("the gap", last, [gap_words(case.found.gap)]),
    )
    return in_steps(steps, _cited(case), _note(case))


def _disagrees(case: _FaceCase) -> bool:
    """Whether the centre is inside the material, and the shortest way out is not along case 1's normal."""
    return case.inside and dot(case.normal, case.found.normal) < 1.0 - 1e-9


def _cited(case: _FaceCase) -> CitedLine:
    """The line that gives the sign; inside the material, the line that compares the depths."""
    if case.inside:
        return code_line(contact_above, "if face.gap > -ball.radius or ring.half_angle == math.pi:")
    if case.applies:
        return code_line(narrow_phase_case_1, "return -n if length(p) < radius else n")
    return code_line(contact, "if not is_over(ring, theta, angle):")


def _note(case: _FaceCase) -> str:
    """What is special about these values."""
    if case.ball.position == 0.0:
        return "The ball is on the centre: p / |p| is 0 / 0. By convention its angle is 0 and its normal points inwards."
    if not case.applies:
        return ""
    if case.inside and case.found.feature is Feature.END:
        return "The centre is inside the material, and an end is nearest: the face's normal would push it through the sector."
    if case.inside:
        return "The centre is inside the material: it leaves through the nearest side, a face. In the game no ball gets there."
    return (
        "Inside of r_p: the inner face, the normal points to the centre."
        if length(case.ball.position) < case.ring.radius
        else ""
    )


def _check(given: Given) -> tuple[Claim, ...]:
    """By the distances to the sector's outline."""
    case = _case(given)
    ball, ring, found, p = case.ball, case.ring, case.found, case.ball.position
    nearest = _distance_to_outline(ring, p)
    spacing = 2.0 * ring.half_angle * ring.outer_radius / _SAMPLES
    depth = -found.gap - ball.radius if case.inside else found.gap + ball.radius
    elsewhere = case.inside or not case.applies
    outward = 1.0 if length(p) >= ring.radius else -1.0
    return (
        Claim("the normal has length 1", is_unit(case.normal) and is_unit(found.normal)),
        Claim("case 1's is radial", abs(cross(case.normal, p)) <= 1e-9 * (1.0 + length(p))),
        Claim("and points away from the middle radius", p == 0.0 or outward * dot(case.normal, p) > 0.0),
        Claim("outside of the material the contact's normal is case 1's", elsewhere or found.normal == case.normal),
        Claim("no point of the outline is nearer than the contact", depth <= nearest + 1e-9),
        Claim("and one is as near", depth >= nearest - spacing),
    )


def _distance_to_outline(ring: Ring, p: complex) -> float:
    """From a point to the nearest of many points of the two arcs, or to the two ends, where there are ends."""
    angles = [ring.angle(0) + ring.half_angle * (2.0 * k / _SAMPLES - 1.0) for k in range(_SAMPLES + 1)]
    arcs = [length(p - to_cartesian(radius, a)) for a in angles for radius in (ring.inner_radius, ring.outer_radius)]
    if ring.half_angle >= math.pi:
        return min(arcs)
    ends = [source.end_points(ring.radius, ring.half_width, angle) for angle in (angles[0], angles[-1])]
    return min([*arcs, *[length(p - closest_point_on_line(a, b, p)) for a, b in ends]])


SCENE = LabScene(
    name="case-1",
    title="Narrow phase, case 1: a face",
    idea="Within the sector's angle a face is nearest, so the normal is radial; the middle radius decides its sign.",
    functions=("narrow_phase_case_1",),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 7.6 + 1.6j, meaning="the ball's centre"),
        Number("r", "r", "", 0.05, 5.0, 0.9, 0.05, "the ball's radius"),
        Number("radius", "r_p", "", 2.0, 13.0, 9.0, 0.05, "the sector's middle radius"),
        Number("angle", "θ_p", "°", 0.0, 360.0, 0.0, 0.5, "the sector's middle angle"),
        Number("half_width", "w_p", "", 0.05, 1.9, 1.0, 0.05, "its half width"),
        Number("half_angle", "φ_p", "°", 0.5, 180.0, 25.0, 0.5, "its half angle"),
    ),
    handles=(
        handles.point("ball", "ball", "r"),
        *handles.sector_handles("radius", "half_width", "angle", "half_angle"),
    ),
    view_box=ViewBox(8.2 + 0j, 6.6 + 5.2j),
    shows=_picture,
    check=_check,
    rows=(7,),
    presets=(
        Preset("the inner face", "ball=7.6,1.6"),
        Preset("the outer face", "ball=10.6,-1"),
        Preset("inside: out through a face", "ball=9.3,0&r=0.4"),
        Preset("inside: out through an end", "ball=8.4,3.5&r=0.4"),
        Preset("a closed ring", "half_angle=180&ball=7,3"),
        Preset("the ball on the centre", "ball=0,0"),
    ),
    engine_use=EngineUse.TOGGLE,
)
