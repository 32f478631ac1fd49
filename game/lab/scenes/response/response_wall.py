"""The bounce off a wall at rest."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.bounce import Bounce, bounce
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import (
    angle_between,
    ball_marks,
    contact_marks,
    ring_marks,
    second_opinion,
    two_decimals,
)
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Arrow, Line, Mark, Picture, Role, Stroke, Toggle, in_steps, one_step, with_more_marks
from game.lab.kit.response_reveal import DrawnBounce, response_reveal
from game.lab.kit.scene import Claim, EngineUse, LabScene, Preset, ViewBox
from physics import Ball, Contact, Ring, collision_response, contact, cross, dot, length, response_steps, to_cartesian, to_polar

_RADIUS, _HALF_WIDTH, _HALF_ANGLE = 6.0, 0.6, 0.7
_BALL_RADIUS = 0.5
_SCALE = 0.34
"""World units drawn per unit of speed."""


class _WallBounce(NamedTuple):
    """A ball that touches the outer face, the contact, and the bounce with its steps."""

    ball: Ball
    ring: Ring
    touch: Contact
    found: Bounce


def _wall_bounce(given: Given) -> _WallBounce:
    """The bounce that the values make."""
    speed, mu = given.number("speed"), given.number("mu")
    ring = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, math.pi / 2.0, 0.0, mu)
    position = to_cartesian(ring.outer_radius + _BALL_RADIUS, given.angle("theta"))
    ball = Ball(position, to_cartesian(speed, given.angle("heading")), _BALL_RADIUS)
    touch = contact(ball, ring, 0)
    return _WallBounce(ball, ring, touch, bounce(ball.velocity, touch.normal, 0j, mu, speed))


def _start(given: Given) -> complex:
    """Where velocities are drawn from: the ball's centre."""
    return _wall_bounce(given).ball.position


def _picture(given: Given) -> Picture:
    """The flight to the wall and from it, and the mirrored one that a smooth wall would give."""
    ball, ring, touch, found = _wall_bounce(given)
    p, v = ball.position, ball.velocity
    situation: list[Mark] = [*ring_marks(ring), *ball_marks(p, _BALL_RADIUS), *contact_marks(ball, touch)]
    situation.append(Line((p - v * _SCALE, p), Role.PLAIN, Toggle.SWEPT, Stroke.DASHED))
    line = f"n = {two_decimals(found.normal)},   μ_p = {found.friction:g}"
    first = one_step("the ball touches a wall at rest", situation, [line])
    steps = [first, *response_reveal(DrawnBounce(found, p, touch.point, _SCALE), "the wall is at rest:   v_p")]
    if not found.separates:
        mirrored = (v + found.steps.normal_change) * _SCALE
        angles = f"in {angle_between(-v, found.normal)},   out {angle_between(found.steps.velocity, found.normal)}"
        mirror = Arrow(p, mirrored, Role.FAINT, None, Stroke.DASHED, "mirrored")
        steps.append(one_step("beside a mirror", [mirror], [f"to the normal:   {angles}"]))
    steps[-1] = with_more_marks(steps[-1], second_opinion(given, ball, ring, (0,), touch))
    return in_steps(steps, _cited(found), _note(found))


def _cited(found: Bounce) -> CitedLine:
    """The branch that was taken."""
    if found.separates:
        return code_line(response_steps, "if approach >= 0.0:")
    return code_line(response_steps, "grip = friction * min(-approach, slip) / slip if slip > 0.0 else 0.0")


def _note(found: Bounce) -> str:
    """What is special about these values."""
    if found.separates:
        return "The ball flies away from the wall or along it."
    if found.friction == 0.0:
        return "Smooth: the angle out is the angle in."
    if abs(cross(found.v, found.normal)) < 1e-9 * found.speed:
        return "Straight on: nothing slides, so there is no friction."
    return "Rough: friction makes the ball slide more slowly, and the reset to v_0 turns it towards the normal."


def _check(given: Given) -> tuple[Claim, ...]:
    """Mirror, time, and friction."""
    _, _, touch, found = _wall_bounce(given)
    v, n, after, speed = found.v, found.normal, found.steps.velocity, found.speed
    mu, met = found.friction, not found.separates
    backwards = collision_response(-after, n, 0j, 0.0, speed)
    steeper = abs(cross(after, n)) <= abs(cross(v, n)) + 1e-9
    return (
        Claim("the ball touches the wall", abs(touch.gap) < 1e-9),
        Claim("the speed stays v_0", abs(length(after) - speed) < 1e-9),
        Claim("it leaves the wall", not met or dot(after, n) > 0.0),
        Claim("a smooth wall is a mirror", not met or mu > 0.0 or length(after - v + n * (2.0 * dot(v, n))) < 1e-9),
        Claim("the bounce off a smooth wall works backwards in time", not met or mu > 0.0 or length(backwards + v) < 1e-9),
        Claim("friction turns the ball towards the normal, never past it", not met or steeper),
        Claim("friction never sends the ball back along the wall", not met or cross(after, n) * cross(v, n) >= -1e-9),
    )


SCENE = LabScene(
    name="response-wall",
    title="Response: a wall at rest",
    idea="A smooth wall is a mirror. Friction slows the sliding, and the reset to v_0 turns the ball towards the normal.",
    functions=("collision_response",),
    parameters=(
        Number("theta", "θ", "°", 50.0, 130.0, 80.0, 0.5, "where the ball touches"),
        Number("heading", "ψ", "°", 0.0, 360.0, 320.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 0.5, 20.0, 10.0, 0.1, "the ball's fixed speed"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.3, 0.01, "friction"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", _start, _SCALE, "velocity")._replace(step=2),
        handles.Handle(
            "ball",
            _start,
            lambda _, position: {"theta": math.degrees(to_polar(position)[1])},
            lambda _: _BALL_RADIUS,
        ),
    ),
    view_box=ViewBox(1.8 + 7.4j, 5.0 + 3.3j),
    shows=_picture,
    check=_check,
    presets=(
        Preset("smooth", "mu=0"),
        Preset("full friction", "mu=1"),
        Preset("straight on", "theta=90&heading=270"),
        Preset("grazing", "theta=90&heading=359&mu=1"),
        Preset("separating", "heading=60"),
    ),
    engine_use=EngineUse.TOGGLE,
)
