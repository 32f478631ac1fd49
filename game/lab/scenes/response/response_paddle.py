"""The bounce off a paddle that moves, with friction."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.bounce import Bounce, bounce, response_line
from game.lab.kit.marks import ball_marks, contact_marks, ring_marks, second_opinion, two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import Picture, in_steps, one_step, with_more_marks
from game.lab.kit.response_reveal import DrawnBounce, response_reveal
from game.lab.kit.scene import Claim, EngineUse, LabScene, Preset, ViewBox
from physics import Ball, Contact, Ring, collision_response, contact, dot, length, to_cartesian

_RADIUS, _HALF_WIDTH, _HALF_ANGLE = 9.0, 0.5, 0.35
_BALL_RADIUS = 0.5
_SCALE = 0.28
"""World units drawn per unit of speed."""


class _PaddleBounce(NamedTuple):
    """A ball at the moment when it touches the paddle, the contact, and the bounce with its steps."""

    ball: Ball
    ring: Ring
    touch: Contact
    found: Bounce


def _paddle_bounce(given: Given) -> _PaddleBounce:
    """The bounce that the values make: the ball is moved along the normal to where it touches the paddle."""
    speed, mu = given.number("speed"), given.number("mu")
    ring = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, math.pi / 2.0, given.number("spin"), mu)
    velocity = to_cartesian(speed, given.angle("heading"))
    ball = _touching(given, ring, velocity)
    touch = contact(ball, ring, 0)
    found = bounce(velocity, touch.normal, ring.surface_velocity(touch.point), mu, speed)
    return _PaddleBounce(ball, ring, touch, found)


def _touching(given: Given, ring: Ring, velocity: complex) -> Ball:
    """The ball, moved along the normal to where it just touches."""
    there = contact(Ball(given.point("ball"), velocity, _BALL_RADIUS), ring, 0)
    return Ball(there.point + there.normal * _BALL_RADIUS, velocity, _BALL_RADIUS)


def _start(given: Given) -> complex:
    """Where velocities are drawn from: the ball's centre."""
    return _paddle_bounce(given).ball.position


def _picture(given: Given) -> Picture:
    """The velocity before, its two parts relative to the paddle, and the velocity after."""
    ball, ring, touch, found = _paddle_bounce(given)
    situation = [*ring_marks(ring), *ball_marks(ball.position, _BALL_RADIUS), *contact_marks(ball, touch)]
    line = f"n = {two_decimals(found.normal)},   μ_p = {found.friction:g}"
    drawn = DrawnBounce(found, ball.position, touch.point, _SCALE)
    steps = [one_step("the ball touches a paddle", situation, [line]), *response_reveal(drawn, "v_p = ω × q")]
    steps[-1] = with_more_marks(steps[-1], second_opinion(given, ball, ring, (0,), touch))
    return in_steps(steps, response_line(found), _note(found))


def _note(found: Bounce) -> str:
    """What is special about these values."""
    if found.separates:
        return "The ball already moves away from the surface: answering again would pull it back in."
    if found.stopped:
        return "|v_res| = 0: the surface retreats at half the ball's speed. No direction is left; the ball leaves along n."
    if found.overtaken:
        return "At v_0 the ball the surface would overtake the ball: it is carried at the surface's speed."
    if length(found.steps.tangential_part) == 0.0:
        return "|Δv_t| = 0: nothing slides, so there is no friction."
    return ""


def _check(given: Given) -> tuple[Claim, ...]:
    """What must be true of every bounce."""
    _, _, touch, found = _paddle_bounce(given)
    normal, after, speed, surface, mu = found.normal, found.steps.velocity, found.speed, found.surface_velocity, found.friction
    v_res, tangential = found.steps.result, found.steps.tangential_part
    met = not found.separates
    ordinary = met and not found.stopped and not found.overtaken
    leaves = dot(after - surface, normal)
    relative = v_res - surface
    sliding = relative - normal * dot(relative, normal)
    least = min(length(found.steps.normal_part), length(tangential))
    mirrored = collision_response(found.v.conjugate(), normal.conjugate(), surface.conjugate(), mu, speed)
    aligned = length(v_res) * speed - dot(v_res, after)
    taken = length(tangential) - length(sliding)
    return (
        Claim("the ball touches the paddle", abs(touch.gap) < 1e-9),
        Claim("a ball that separates has the velocity that it had", met or after == found.v),
        Claim("after a bounce the speed is v_0", not met or abs(length(after) - speed) < 1e-9),
        Claim("it leaves no slower than the surface, if v_0 allows", not met or leaves > -1e-9 or found.surface_speed > speed),
        Claim("its direction is that of v_res", not ordinary or abs(aligned) < 1e-6),
        Claim("friction never reverses the sliding", not met or dot(sliding, tangential) >= -1e-9),
        Claim("friction takes μ min(|Δv_n|, |Δv_t|) of the sliding", not met or abs(taken - mu * least) < 1e-9),
        Claim("a mirrored bounce has the mirrored result", mirrored == after.conjugate()),
    )


SCENE = LabScene(
    name="response-paddle",
    title="Response: a moving paddle with friction",
    idea="The bounce is computed relative to the touched surface, so the paddle's motion and its friction aim the ball.",
    functions=("collision_response",),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 0.8 + 7j, meaning="moved to where it touches"),
        Number("heading", "ψ", "°", 0.0, 360.0, 60.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 0.5, 20.0, 10.0, 0.1, "the ball's fixed speed"),
        Number("spin", "ω", "rad/s", -3.0, 3.0, 0.6, 0.01, "the paddle's spin; v_p = ω × q"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.5, 0.01, "friction"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", _start, _SCALE, "velocity")._replace(step=2),
        handles.Handle("ball", _start, lambda _given, position: {"ball": position}, lambda _given: _BALL_RADIUS),
    ),
    view_box=ViewBox(0.4 + 7.3j, 5.4 + 4.4j),
    shows=_picture,
    check=_check,
    rows=(4, 5, 10),
    presets=(
        Preset("rough and moving", "mu=1&spin=1"),
        Preset("smooth: the paddle's motion along itself is not felt", "mu=0&spin=1"),
        Preset("off the end", "ball=-4.5,8&heading=10&spin=0.5"),
        Preset("stopped dead", "ball=-3.5557666235227523,8.282905511898685&heading=20.053522829578824&speed=9&mu=0&spin=-0.5"),
        Preset("carried", "ball=-6,8.6&heading=80&speed=4&mu=0&spin=0.4"),
        Preset("separating", "heading=270"),
    ),
    engine_use=EngineUse.TOGGLE,
)
