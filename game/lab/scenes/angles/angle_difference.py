"""The difference of two angles, also across the polar axis."""

import math

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import angle_arc, degrees, ray
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Circle, Line, Mark, Picture, PointMark, Role, Stroke, Words, in_steps, one_step
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import add_angles, min_difference, normalize_angle, on_left, signed_difference, subtract_angles, to_cartesian

_RADIUS = 4.0


def _angles(given: Given) -> tuple[float, float]:
    """Both, normalised."""
    return normalize_angle(given.angle("a")), normalize_angle(given.angle("b"))


def _picture(given: Given) -> Picture:
    """Two directions, the smaller angle between them, and the plain difference a - b."""
    a, b = _angles(given)
    shorter = signed_difference(a, b)
    directions: list[Mark] = [
        Line((0j, 8 + 0j), Role.FAINT, None, Stroke.DASHED),
        Words(5.0 - 0.3j, "polar axis", Role.FAINT),
        Circle(0j, _RADIUS, Role.FAINT),
        ray(a, _RADIUS, Role.PLAIN),
        ray(b, _RADIUS, Role.TWO),
        PointMark(to_cartesian(_RADIUS, a), Role.PLAIN, label="a"),
        PointMark(to_cartesian(_RADIUS, b), Role.TWO, label="b"),
    ]
    plain = [angle_arc(1.2, b, a - b, Role.SOURCE, "a - b")] if abs(a - b) > math.pi else []
    difference = (
        f"a - b = {degrees(a)} - {degrees(b)} = {degrees(a - b)}",
        f"counter-clockwise from b to a:   {degrees(subtract_angles(a, b))}",
    )
    steps = (
        one_step("two directions", directions),
        one_step("a - b, the plain difference", plain, difference),
        one_step(
            "the smaller angle",
            [angle_arc(2.2, b, shorter, Role.OURS, "smaller angle")],
            [f"min_difference(a, b) = {degrees(min_difference(a, b))}"],
        ),
        one_step("on which side?", [], [f"on_left(a, b) = {on_left(a, b)}:   a {_side(shorter)} b"]),
    )
    return in_steps(steps, _cited(a, b), _note(a, b))


def _side(shorter: float) -> str:
    """On which side of b a lies."""
    if shorter == 0.0:
        return "is"
    if shorter == math.pi:
        return "is opposite to"
    return "is counter-clockwise of" if shorter > 0.0 else "is clockwise of"


def _cited(a: float, b: float) -> CitedLine:
    """The line that returns the smaller angle."""
    if -math.pi < a - b <= math.pi:
        return code_line(signed_difference, "difference = a - b")
    return code_line(
        signed_difference,
        "return difference - math.tau" if a - b > math.pi else "return difference + math.tau if difference <= -math.pi",
    )


def _note(a: float, b: float) -> str:
    """What is special about these values."""
    if a == b:
        return "The same direction: neither is on the left of the other."
    if abs(abs(a - b) - math.pi) < 1e-12:
        return "Opposite directions: both angles are half a turn, and neither is on the left of the other."
    if abs(a - b) > math.pi:
        return "The smaller angle lies across the polar axis. The plain difference a - b is the larger angle."
    return ""


def _check(given: Given) -> tuple[Claim, ...]:
    """Symmetries of a difference."""
    a, b = _angles(given)
    difference = min_difference(a, b)
    turns = [add_angles(a, k) for k in (1.0, 2.0, 4.0)], [add_angles(b, k) for k in (1.0, 2.0, 4.0)]
    there = to_cartesian(1.0, b + signed_difference(a, b)) - to_cartesian(1.0, a)
    inside = 1e-9 < difference < math.pi - 1e-9
    return (
        Claim("the difference is in [0, π]", 0.0 <= difference <= math.pi),
        Claim("it is the same from b to a", abs(min_difference(b, a) - difference) < 1e-12),
        Claim("b turned by the signed difference is a", abs(there) < 1e-12),
        Claim(
            "it does not depend on where the polar axis is", all([_same(x, y, difference) for x, y in zip(*turns, strict=True)])
        ),
        Claim("exactly one of two is on the left of the other", not inside or on_left(a, b) != on_left(b, a)),
        Claim("it is the angle between the two unit vectors", abs(_between(a, b) - difference) < 1e-7),
    )


def _same(a: float, b: float, difference: float) -> bool:
    """Whether two turned angles differ by as much."""
    return abs(min_difference(a, b) - difference) < 1e-12


def _between(a: float, b: float) -> float:
    """The angle between two directions by their scalar product."""
    turn = to_cartesian(1.0, a) * to_cartesian(1.0, b).conjugate()
    return math.acos(min(max(turn.real, -1.0), 1.0))


SCENE = LabScene(
    name="angle-difference",
    title="The difference of two angles, across the polar axis",
    idea="Two directions enclose two angles. The smaller one counts, also where it lies across the polar axis.",
    functions=("min_difference", "on_left", "normalize_angle"),
    parameters=(
        Number("a", "a", "°", 0.0, 360.0, 25.0, 0.5, "such as the ball's angle"),
        Number("b", "b", "°", 0.0, 360.0, 340.0, 0.5, "such as a paddle's angle"),
    ),
    handles=(
        handles.on_circle("a", lambda _: _RADIUS, "a"),
        handles.on_circle("b", lambda _: _RADIUS, "b"),
    ),
    view_box=ViewBox(0.6 + 0j, 5.4 + 4.5j),
    shows=_picture,
    check=_check,
    rows=(1,),
    presets=(
        Preset("across the polar axis", "a=25&b=340"),
        Preset("across it, clockwise", "a=340&b=25"),
        Preset("not across it", "a=100&b=40"),
        Preset("opposite", "a=200&b=20"),
        Preset("the same", "a=30&b=30"),
    ),
)
