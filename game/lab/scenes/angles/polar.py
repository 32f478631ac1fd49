"""Polar coordinates, and the range of normalised angles."""

import math

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import angle_arc, degrees, ray, two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    Arrow,
    Circle,
    Line,
    Mark,
    Picture,
    PointMark,
    Prediction,
    Role,
    Stroke,
    Words,
    in_steps,
    one_step,
)
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import length, normalize_angle, to_cartesian, to_polar

_TINY = 1e-15
"""Radians. A negative angle nearer to 0 than this, plus 2 pi, is 2 pi itself in floating point."""


def _turned(given: Given) -> float:
    """The angle a, which need not be normalised: the slider's degrees, and a tiny angle that degrees cannot express."""
    return given.angle("turn") + given.number("epsilon") * 1e-17


def _picture(given: Given) -> Picture:
    """A point with its two kinds of coordinates, and an angle of any size with its direction."""
    p, turn = given.point("p"), _turned(given)
    radius, theta = to_polar(p)
    folded, plain = normalize_angle(turn), source.normalize_angle(turn)
    axis: list[Mark] = [Line((0j, 12 + 0j), Role.FAINT, None, Stroke.DASHED, "polar axis")]
    point: list[Mark] = [
        Circle(0j, radius, Role.FAINT, None, Stroke.DASHED),
        Line((0j, complex(p.real, 0.0), p), Role.FAINT),
        Arrow(0j, p, Role.PLAIN, None, Stroke.THICK, "p"),
    ]
    spiral: list[Mark] = [
        Line(_spiral(turn), Role.TWO),
        Words(_spiral(turn)[-1] * 1.08 + 0.3j, "a" if abs(turn) > 0.1 else "", Role.TWO),
    ]
    normalised: list[Mark] = [
        ray(folded, 5.0, Role.OURS),
        angle_arc(2.4, 0.0, folded, Role.OURS, "a, normalised"),
        PointMark(to_cartesian(5.0, folded), Role.OURS),
    ]
    polar = f"p = {two_decimals(p)}:   |p| = √(x² + y²) = {radius:.3f},   θ = {degrees(theta)}"
    steps = (
        one_step("p, a point", axis + point),
        one_step("|p| and θ, its polar coordinates", [angle_arc(1.2, 0.0, theta, Role.PLAIN, "θ")], [polar]),
        one_step("and back", [], [f"back:   |p| (cos θ, sin θ) = {two_decimals(to_cartesian(radius, theta))}"]),
        one_step("a, an angle of any size", spiral, [f"a = {_number(turn)} rad"]),
        one_step(
            "a normalised",
            normalised,
            [
                f"a mod 2π = {_number(plain)} rad" + (",   which is 2π: out of range" if plain >= math.tau else ""),
                f"normalised, in [0, 2π):   {_number(folded)} rad = {degrees(folded)}",
            ],
            Prediction("normalised a", None, to_cartesian(5.0, folded)),
        ),
    )
    return in_steps(steps, _cited(plain), _note(p, turn, plain))


def _spiral(turn: float) -> tuple[complex, ...]:
    """A spiral that turns from the polar axis by an angle of any size."""
    parts = max(round(abs(turn) * 12.0), 1)
    return tuple([to_cartesian(3.2 + 0.35 * abs(turn) * k / parts / math.tau, turn * k / parts) for k in range(parts + 1)])


def _number(angle: float) -> str:
    """A number of radians: tiny ones by their power of ten."""
    return f"{angle:.3g}" if 0.0 < abs(angle) < 1e-3 else f"{angle:.5f}"


def _cited(plain: float) -> CitedLine:
    """The line that makes the range half-open."""
    return code_line(normalize_angle, "return angle if angle < math.tau else 0.0" if plain >= math.tau else "angle %= math.tau")


def _note(p: complex, turn: float, plain: float) -> str:
    """What is special about these values."""
    if p == 0.0:
        return "p is the origin: it has no angle. 0 is a convention, and nothing may depend on it."
    if plain >= math.tau:
        return "The remainder of a tiny negative angle rounds to 2π itself. Equal directions would then differ by a whole turn."
    if turn == 0.0:
        return "The source asks for (0, 2π). A ball on the polar axis has the angle 0, so the range has to include it."
    return ""


def _check(given: Given) -> tuple[Claim, ...]:
    """The conversion and its inverse, and the range of the angles."""
    p, turn = given.point("p"), _turned(given)
    radius, theta = to_polar(p)
    folded = normalize_angle(turn)
    there = to_cartesian(1.0, turn) - to_cartesian(1.0, folded)
    plain = source.normalize_angle(turn)
    return (
        Claim(
            "to polar coordinates and back is the same point", length(to_cartesian(radius, theta) - p) <= 1e-12 * (1.0 + radius)
        ),
        Claim("the point's angle is in [0, 2π)", 0.0 <= theta < math.tau),
        Claim("the normalised angle is in [0, 2π)", 0.0 <= folded < math.tau),
        Claim("it has the same direction", length(there) < 1e-12),
        Claim("normalising again changes nothing", normalize_angle(folded) == folded),
        Claim("a plain remainder differs only where it leaves the range", (plain == folded) == (plain < math.tau)),
        Claim("the plain remainder leaves the range only for a tiny negative angle", plain < math.tau or -_TINY < turn < 0.0),
    )


SCENE = LabScene(
    name="polar",
    title="Polar coordinates and normalised angles",
    idea="A point is a distance and an angle. Angles are normalised to [0, 2π) once, and compared only then.",
    functions=("normalize_angle", "to_polar", "to_cartesian"),
    parameters=(
        Point("p", "p", -10.0, 10.0, 4 + 3j, meaning="a point"),
        Number("turn", "a", "°", -1080.0, 1080.0, 500.0, 1.0, "an angle of any size"),
        Number("epsilon", "ε", "× 1e-17 rad", -10.0, 10.0, 0.0, 1.0, "added to a"),
    ),
    handles=(
        handles.point("p", "p"),
        handles.Handle(
            "a",
            lambda given: to_cartesian(5.0, given.angle("turn")),
            lambda given, position: {"turn": _nearest_turn(given.number("turn"), position)},
        ),
    ),
    view_box=ViewBox(0.5 + 0.3j, 7.5 + 6.0j),
    shows=_picture,
    check=_check,
    rows=(1,),
    presets=(
        Preset("more than a turn", "turn=500"),
        Preset("1e-17 below the polar axis", "turn=0&epsilon=-1"),
        Preset("on the polar axis", "p=5,0&turn=0"),
        Preset("clockwise", "turn=-90"),
        Preset("the origin", "p=0,0"),
    ),
)


def _nearest_turn(before: float, position: complex) -> float:
    """The angle of a point, in degrees: of all that differ by whole turns, the one nearest to the angle before."""
    angle = math.degrees(to_polar(position)[1])
    return angle + 360.0 * round((before - angle) / 360.0)
