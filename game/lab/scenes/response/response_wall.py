"""The bounce off a wall at rest."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import Deciding, code
from game.lab.kit.marks import (
    VELOCITY_SCALE,
    angle_between,
    ball_marks,
    contact_marks,
    ring_marks,
    second_opinion,
    two_decimals,
)
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Arrow, Line, Mark, Picture, Stroke, Toggle, Tone, single
from game.lab.kit.scene import Claim, Preset, Scene, View
from physics import Ball, Contact, Ring, collision_response, contact, cross, dot, length, to_cartesian, to_polar

_RADIUS, _HALF_WIDTH, _HALF_ANGLE = 6.0, 0.6, 0.7
_BALL_RADIUS = 0.5


class _Bounce(NamedTuple):
    """A ball that touches the outer face, and its velocity after."""

    ball: Ball
    ring: Ring
    found: Contact
    after: complex
    speed: float

    @property
    def approaches(self) -> bool:
        """v . n < 0."""
        return dot(self.ball.velocity, self.found.normal) < 0.0


def _bounce(given: Given) -> _Bounce:
    """The bounce that the values make."""
    speed, mu = given.number("speed"), given.number("mu")
    ring = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, math.pi / 2.0, 0.0, mu)
    place = to_cartesian(ring.outer_radius + _BALL_RADIUS, given.angle("theta"))
    ball = Ball(place, to_cartesian(speed, given.angle("heading")), _BALL_RADIUS)
    found = contact(ball, ring, 0)
    return _Bounce(ball, ring, found, collision_response(ball.velocity, found.normal, 0j, mu, speed), speed)


def _start(given: Given) -> complex:
    """Where velocities are drawn from: the ball's centre."""
    return _bounce(given).ball.position


def _picture(given: Given) -> Picture:
    """The flight to the wall and from it, and the mirrored one that a smooth wall would give."""
    bounce = _bounce(given)
    p, v, n = bounce.ball.position, bounce.ball.velocity, bounce.found.normal
    marks: list[Mark] = [*ring_marks(bounce.ring), *ball_marks(p, _BALL_RADIUS), *contact_marks(bounce.ball, bounce.found)]
    marks.append(Line((p - v * VELOCITY_SCALE, p), Tone.PLAIN, Toggle.SWEPT, Stroke.DASHED))
    if bounce.approaches:
        mirrored = v - n * (2.0 * dot(v, n))
        marks.append(Arrow(p, mirrored * VELOCITY_SCALE, Tone.FAINT, None, Stroke.DASHED, "mirrored"))
    marks.append(Arrow(p, v * VELOCITY_SCALE, Tone.PLAIN, None, Stroke.THICK, "v before"))
    marks.append(Arrow(p, bounce.after * VELOCITY_SCALE, Tone.GOOD, None, Stroke.THICK, "v after"))
    marks += second_opinion(given, bounce.ball, bounce.ring, (0,), bounce.found)
    return single(tuple(marks), _formula(bounce), _deciding(bounce), _note(bounce))


def _formula(bounce: _Bounce) -> tuple[str, ...]:
    """The equations with v_p = 0."""
    v, n, mu = bounce.ball.velocity, bounce.found.normal, bounce.ring.friction
    approach = dot(v, n)
    compared = f"v_p = 0, so Δv = v = {two_decimals(v)},   Δv · n = {approach:.2f}"
    if not bounce.approaches:
        return (compared, "Δv · n is not below 0: they separate, nothing happens")
    normal, slip = -approach, length(v - n * approach)
    return (
        compared,
        f"|Δv_n| = {normal:.2f},   |Δv_t| = {slip:.2f},   μ min(|Δv_n|, |Δv_t|) = {mu * min(normal, slip):.2f}",
        f"v := v_0 v_res / |v_res| = {two_decimals(bounce.after)}",
        f"to the normal:   in {angle_between(-v, n)},   out {angle_between(bounce.after, n)}",
    )


def _deciding(bounce: _Bounce) -> Deciding:
    """The branch that was taken."""
    return code(collision_response, "grip = friction" if bounce.approaches else "if approach >= 0.0")


def _note(bounce: _Bounce) -> str:
    """What is special."""
    if not bounce.approaches:
        return "The ball flies away from the wall or along it."
    if bounce.ring.friction == 0.0:
        return "Smooth: the angle out is the angle in."
    if abs(cross(bounce.ball.velocity, bounce.found.normal)) < 1e-9 * bounce.speed:
        return "Straight on: nothing slides, so there is no friction."
    return "Rough: what slides along the wall grows less, and the reset to v_0 turns the ball towards the normal."


def _check(given: Given) -> tuple[Claim, ...]:
    """Mirror, time, and friction."""
    bounce = _bounce(given)
    v, n, after, speed = bounce.ball.velocity, bounce.found.normal, bounce.after, bounce.speed
    mu, approaches = bounce.ring.friction, bounce.approaches
    backwards = collision_response(-after, n, 0j, 0.0, speed)
    steeper = abs(cross(after, n)) <= abs(cross(v, n)) + 1e-9
    return (
        Claim("the ball touches the wall", abs(bounce.found.gap) < 1e-9),
        Claim("the speed stays v_0", abs(length(after) - speed) < 1e-9),
        Claim("it leaves the wall", not approaches or dot(after, n) > 0.0),
        Claim("a smooth wall is a mirror", not approaches or mu > 0.0 or length(after - v + n * (2.0 * dot(v, n))) < 1e-9),
        Claim("and works backwards in time", not approaches or mu > 0.0 or length(backwards + v) < 1e-9),
        Claim("friction turns towards the normal, never past it", not approaches or steeper),
        Claim("and never back along the wall", not approaches or cross(after, n) * cross(v, n) >= -1e-9),
    )


SCENE = Scene(
    name="response-wall",
    title="Response: a wall at rest",
    idea="A smooth wall is a mirror; friction takes from what slides, and the fixed speed turns the rest towards the normal.",
    functions=("collision_response",),
    parameters=(
        Number("theta", "θ", "°", 50.0, 130.0, 80.0, 0.5, "where the ball touches"),
        Number("heading", "ψ", "°", 0.0, 360.0, 320.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 0.5, 20.0, 10.0, 0.1, "the ball's fixed speed"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.3, 0.01, "friction"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", _start, VELOCITY_SCALE, "velocity"),
        handles.Handle(
            "ball",
            _start,
            lambda _, place: {"theta": math.degrees(to_polar(place)[1])},
            lambda _: _BALL_RADIUS,
        ),
    ),
    view=View(0.4 + 7.2j, 5.4 + 3.4j),
    shows=_picture,
    check=_check,
    presets=(
        Preset("smooth", "mu=0"),
        Preset("as rough as can be", "mu=1"),
        Preset("straight on", "theta=90&heading=270"),
        Preset("grazing", "theta=90&heading=359&mu=1"),
        Preset("separating", "heading=60"),
    ),
)
