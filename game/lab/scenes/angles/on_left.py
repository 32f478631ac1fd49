"""Which end of a sector is nearer: the source's rule beside ours."""

import math
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line, source_line
from game.lab.kit.marks import degrees, ray
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import (
    AnnularSector,
    Arrow,
    Disc,
    Line,
    Mark,
    Pane,
    Picture,
    PointMark,
    RevealStep,
    Role,
    Stroke,
    Toggle,
    in_steps,
)
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import (
    closest_point_on_line,
    length,
    min_difference,
    narrow_phase_case_2,
    normalize_angle,
    on_left,
    to_cartesian,
)

_RADIUS, _HALF_WIDTH = 6.0, 1.0


class _ChosenEnd(NamedTuple):
    """The end that one rule chooses: its sign, its corners A and B, the closest point q, and the normal, if they touch."""

    sign: int
    a: complex
    b: complex
    q: complex
    normal: complex | None


class _BothRulesForEnd(NamedTuple):
    """The ball, the sector, and the ends that both rules choose. Angles are radians."""

    p: complex
    r: float
    theta: float
    angle: float
    half_angle: float
    theirs: _ChosenEnd
    ours: _ChosenEnd

    @property
    def applies(self) -> bool:
        """Whether this is case 2 at all."""
        return min_difference(self.theta, self.angle) > self.half_angle


def _both(given: Given) -> _BothRulesForEnd:
    """The ends that both rules choose for the same ball."""
    r, theta, angle = given.number("r"), normalize_angle(given.angle("theta")), normalize_angle(given.angle("angle"))
    half_angle = given.angle("half_angle")
    p = to_cartesian(_RADIUS, theta)
    theirs = _chosen_end(p, r, angle, half_angle, source.end_sign(theta, angle, half_angle))
    ours = _chosen_end(p, r, angle, half_angle, 1 if on_left(theta, angle) else -1)
    return _BothRulesForEnd(p, r, theta, angle, half_angle, theirs, ours)


def _chosen_end(p: complex, r: float, angle: float, half_angle: float, sign: int) -> _ChosenEnd:
    """The end on one side. sign: 1 the counter-clockwise one."""
    a, b = source.end_points(_RADIUS, _HALF_WIDTH, angle + sign * half_angle)
    return _ChosenEnd(sign, a, b, closest_point_on_line(a, b, p), source.end_normal(p, r, a, b))


def _picture(given: Given) -> Picture:
    """The source's choice at the left, ours at the right."""
    both = _both(given)
    panes = (Pane((), "the source: on_left(θ, θ_p + φ_p)"), Pane((), "here: on_left(θ, θ_p)"))
    far = normalize_angle(both.angle + both.half_angle)
    theirs, ours = _end_marks(both, both.theirs, Role.SOURCE), _end_marks(both, both.ours, Role.OURS)
    distances = f"{length(both.p - both.theirs.q):.3f} by the source's end, {length(both.p - both.ours.q):.3f} by ours"
    steps = (
        RevealStep(
            "a ball and a wide sector",
            (_situation(both),) * 2,
            (f"θ = {degrees(both.theta)},   θ_p = {degrees(both.angle)},   φ_p = {degrees(both.half_angle)}",),
        ),
        RevealStep(
            "the source's end",
            (theirs, ()),
            (f"the source:   on_left(θ, θ_p + φ_p = {degrees(far)}) = {both.theirs.sign > 0}:   sign = {both.theirs.sign}",),
        ),
        RevealStep(
            "the end by the sector's middle",
            ((), ours),
            (f"here:   on_left(θ, θ_p) = {both.ours.sign > 0}:   sign = {both.ours.sign}",),
        ),
        RevealStep("which is nearer?", ((), ()), (f"|p - q|:   {distances}",)),
    )
    return in_steps(steps, _cited(both), _note(both), panes)


def _situation(both: _BothRulesForEnd) -> tuple[Mark, ...]:
    """The ball and the sector."""
    return (
        AnnularSector(_RADIUS, _HALF_WIDTH, both.angle, both.half_angle, Role.SECTOR),
        ray(both.angle, 8.0, Role.FAINT, "θ_p"),
        ray(both.theta, 8.0),
        Disc(both.p, both.r, Role.BALL),
    )


def _end_marks(both: _BothRulesForEnd, end: _ChosenEnd, role: Role) -> tuple[Mark, ...]:
    """The end that a rule chooses."""
    if not both.applies:
        return ()
    marks: list[Mark] = [
        Line((end.a, end.b), role, Toggle.CLOSEST, Stroke.THICK),
        PointMark(end.q, role, Toggle.CLOSEST, "q"),
    ]
    if end.normal is not None:
        marks.append(Arrow(end.q, end.normal * 2.0, role, Toggle.NORMALS, label="n"))
    return tuple(marks)


def _cited(both: _BothRulesForEnd) -> CitedLine:
    """The line that chooses the end."""
    if both.theirs.sign != both.ours.sign:
        return source_line("Narrow phase, case 2", "sign = 1 if on_left(θ, θ_p + φ_p) else -1")
    return code_line(narrow_phase_case_2, "end = nearest_end(p, theta, radius, angle, half_width, half_angle)")


def _note(both: _BothRulesForEnd) -> str:
    """Which rule is wrong, and why."""
    if not both.applies:
        return "θ lies within the sector: this is case 1, and neither rule is asked."
    if both.theirs.sign == both.ours.sign:
        return "Both rules choose the same end."
    if abs(min_difference(both.theta, both.angle) - math.pi) < 1e-9:
        return "The ball is exactly opposite: both ends are equally near."
    return (
        "offset + φ_p > π: θ is on the left of the end at θ_p + φ_p, yet the other end is nearer. "
        "The source chooses the wrong end."
    )


def _check(given: Given) -> tuple[Claim, ...]:
    """Exactly where the source chooses the wrong end."""
    both = _both(given)
    offset = min_difference(both.theta, both.angle)
    ours, theirs = length(both.p - both.ours.q), length(both.p - both.theirs.q)
    arguments = both.p, both.r, both.theta, _RADIUS, both.angle, _HALF_WIDTH, both.half_angle
    normal = narrow_phase_case_2(*arguments) if both.applies else None
    borders = offset - both.half_angle, abs(offset + both.half_angle - math.pi), math.pi - offset, both.half_angle
    clear = both.applies and min(borders) > 1e-6
    wide = offset + both.half_angle > math.pi
    return (
        Claim("our end is the nearer one", not both.applies or ours <= theirs + 1e-9),
        Claim(
            "the source chooses the other end exactly when offset + φ_p > π and the ball is clockwise of θ_p",
            not clear or (both.theirs.sign != both.ours.sign) == (wide and both.ours.sign < 0),
        ),
        Claim("narrow_phase_case_2 chooses our end", (normal is not None) == (both.applies and ours < both.r)),
        Claim("for a narrow sector both rules agree", not both.applies or wide or not clear or theirs == ours),
    )


SCENE = LabScene(
    name="on-left",
    title="Which end? on_left and the wide sector",
    idea="Seen from an end of a wide sector, a ball beyond the other end is still on the left. The sector's middle decides.",
    functions=("on_left", "narrow_phase_case_2"),
    parameters=(
        Number("theta", "θ", "°", 0.0, 360.0, 200.0, 0.5, "the ball's angle"),
        Number("r", "r", "", 0.1, 4.0, 1.4, 0.05, "the ball's radius"),
        Number("angle", "θ_p", "°", 0.0, 360.0, 0.0, 0.5, "the sector's middle angle"),
        Number("half_angle", "φ_p", "°", 0.0, 180.0, 150.0, 0.5, "its half angle"),
    ),
    handles=(
        handles.on_circle("theta", lambda _: _RADIUS, "ball"),
        handles.on_circle("angle", lambda _: _RADIUS, "sector"),
        handles.half_angle("half_angle", "angle", lambda _: _RADIUS + 0.6 * _HALF_WIDTH, 1.0),
        handles.half_angle("half_angle", "angle", lambda _: _RADIUS + 0.6 * _HALF_WIDTH, -1.0),
    ),
    view_box=ViewBox(0j, 8.4 + 8.4j),
    shows=_picture,
    check=_check,
    rows=(2,),
    presets=(
        Preset("a wide sector: the source errs", "theta=200&half_angle=150"),
        Preset("the same, mirrored: both are right", "theta=160&half_angle=150"),
        Preset("a narrow sector: both are right", "theta=330&half_angle=20"),
        Preset("the ball reaches both ends", "theta=190&half_angle=160&r=2.4"),
        Preset("opposite", "theta=180&half_angle=150&r=2"),
    ),
)
