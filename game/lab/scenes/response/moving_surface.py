"""The bounce off a surface with any velocity, also along its normal: the source's response, vector by vector."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.bounce import Bounce, bounce, response_line
from game.lab.kit.marks import two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import Arrow, Disc, Line, Mark, Picture, PointMark, Role, Stroke, Toggle, in_steps, one_step
from game.lab.kit.response_reveal import DrawnBounce, response_reveal
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import collision_response, dot, length, to_cartesian, to_polar

_BALL_RADIUS = 0.7
_SCALE = 0.4
"""World units drawn per unit of speed."""
_SURFACE = 7.0
"""Half the length of the drawn surface, world units."""
_HATCHES, _HATCH = 20, 0.45
"""Strokes that show on which side the material is; their length in world units."""
_NORMAL = 1.4
"""World units drawn for the unit normal."""


class _SurfaceBounce(NamedTuple):
    """A ball that touches a flat surface at the origin, and the bounce."""

    centre: complex
    found: Bounce


def _surface_bounce(given: Given) -> _SurfaceBounce:
    """The bounce that the values make."""
    n, speed = to_cartesian(1.0, given.angle("normal")), given.number("speed")
    v = to_cartesian(speed, given.angle("heading"))
    return _SurfaceBounce(n * _BALL_RADIUS, bounce(v, n, given.point("v_p"), given.number("mu"), speed))


def _picture(given: Given) -> Picture:
    """The situation first, then the response's vectors one after the other."""
    centre, found = _surface_bounce(given)
    n = found.normal
    line = f"n = {two_decimals(n)},   μ_p = {found.friction:g}"
    first = one_step("the ball touches", _situation(n, centre), [line])
    steps = [first, *response_reveal(DrawnBounce(found, centre, 0j, _SCALE))]
    return in_steps(steps, response_line(found), _note(found))


def _situation(n: complex, centre: complex) -> list[Mark]:
    """The surface with its material hatched, the ball, and the normal."""
    along = n * 1j
    feet = [along * (_SURFACE * (2.0 * k / _HATCHES - 1.0)) for k in range(1, _HATCHES + 1)]
    return [
        *[Line((foot, foot + (along - n) * _HATCH), Role.FAINT) for foot in feet],
        Line((along * -_SURFACE, along * _SURFACE), Role.SECTOR, None, Stroke.THICK),
        Disc(centre, _BALL_RADIUS, Role.BALL),
        PointMark(0j, Role.OURS, Toggle.CONTACTS, "q"),
        Arrow(0j, n * _NORMAL, Role.OURS, Toggle.NORMALS, Stroke.SOLID, "n"),
    ]


def _note(found: Bounce) -> str:
    """What is special about these values."""
    if found.separates:
        return "The ball already moves away from the surface: answering again would pull it back in."
    if found.stopped:
        return "|v_res| = 0: the surface retreats at half the ball's speed. No direction is left; the ball leaves along n."
    if found.surface_speed >= found.speed:
        return "The surface is as fast as the ball: no velocity of length v_0 gets away from it. No level has such a surface."
    if found.overtaken:
        return "At v_0 the surface would overtake the ball: it is carried, with the surface's own speed along n."
    if found.surface_speed > 0.0:
        return "The surface comes towards the ball: the bounce makes it faster, and the reset brings it back to v_0."
    return (
        "The surface retreats: the bounce makes the ball slower, and the reset brings it back to v_0."
        if found.surface_speed
        else ""
    )


def _check(given: Given) -> tuple[Claim, ...]:
    """The bounce does not depend on how the scene is turned, and its parts are what the source says."""
    _, found = _surface_bounce(given)
    steps, n, v_p, speed = found.steps, found.normal, found.surface_velocity, found.speed
    met, turn = not found.separates, to_cartesian(1.0, 1.0)
    turned = collision_response(found.v * turn, n * turn, v_p * turn, found.friction, speed)
    steady = found.separates == (dot((found.v - v_p) * turn, n * turn) >= 0.0)
    ordinary = met and not found.stopped and not found.overtaken and length(steps.result) > 1e-6 * speed
    return (
        Claim("the two parts of Δv add up to it", length(steps.normal_part + steps.tangential_part - steps.relative) < 1e-9),
        Claim("Δv_t has no part along n", abs(dot(steps.tangential_part, n)) < 1e-9),
        Claim(
            "along n, v_res leaves the surface as fast as v came",
            not met or abs(dot(steps.result - v_p, n) + found.approach) < 1e-9,
        ),
        Claim("the speed stays v_0", abs(length(steps.velocity) - speed) < 1e-9),
        Claim(
            "the turned bounce has the turned result",
            not (ordinary and steady) or length(turned - steps.velocity * turn) < 1e-5 * speed or _is_near_carried(found),
        ),
    )


def _is_near_carried(found: Bounce) -> bool:
    """Whether rounding decides if the ball is carried."""
    v_res = found.steps.result
    return abs(dot(v_res, found.normal) / length(v_res) * found.speed - found.surface_speed) < 1e-9 * found.speed


def _degrees_of(point: complex, before: float) -> float:
    """The angle of a point; the angle before, for the origin."""
    return math.degrees(to_polar(point)[1]) if point else before


SCENE = LabScene(
    name="moving-surface",
    title="Response: any surface, vector by vector",
    idea="The surface may move in any direction, also along its normal. Space shows one vector after the other.",
    functions=("collision_response",),
    parameters=(
        Number("heading", "ψ", "°", 0.0, 360.0, 305.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 0.5, 20.0, 9.0, 0.1, "the ball's fixed speed"),
        Point("v_p", "v_p", -20.0, 20.0, -2.5 + 2j, 0.1, "the surface's velocity"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.5, 0.01, "friction"),
        Number("normal", "ψ_n", "°", 0.0, 360.0, 90.0, 0.5, "direction of n"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: _surface_bounce(given).centre, _SCALE, "v")._replace(step=2),
        handles.vector("v_p", lambda _: 0j, _SCALE, "v_p")._replace(step=3),
        handles.Handle(
            "n",
            lambda given: to_cartesian(_NORMAL, given.angle("normal")),
            lambda given, target: {"normal": _degrees_of(target, given.number("normal"))},
        ),
    ),
    view_box=ViewBox(0.6 + 1.1j, 5.6 + 4.7j),
    shows=_picture,
    check=_check,
    rows=(4, 5),
    presets=(
        Preset("towards the ball", "v_p=-2.5,2"),
        Preset("at rest", "v_p=0,0"),
        Preset("along itself: only friction feels it", "v_p=-4,0&mu=1"),
        Preset("retreating", "v_p=0,-2"),
        Preset("stopped dead", "heading=270&v_p=0,-4.5"),
        Preset("carried", "heading=340&v_p=0,7&mu=0"),
        Preset("separating", "heading=60&v_p=0,2"),
    ),
)
