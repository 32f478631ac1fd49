"""The bounce off a paddle that moves, with friction."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import Deciding, code
from game.lab.kit.marks import VELOCITY_SCALE, ball_marks, contact_marks, ring_marks, second_opinion, two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import Arrow, Mark, Picture, Stroke, Tone, single
from game.lab.kit.scene import Claim, Preset, Scene, View
from game.lab.source import literal
from physics import Ball, Contact, Ring, collision_response, contact, dot, length, to_cartesian
from physics.tolerances import STOPPED

_RADIUS, _HALF_WIDTH, _HALF_ANGLE = 9.0, 0.5, 0.35
_BALL_RADIUS = 0.5


class _Bounce(NamedTuple):
    """All velocities of one bounce, in the source's letters."""

    ball: Ball  # at the moment of touch
    ring: Ring
    found: Contact
    surface: complex  # v_p
    normal_part: complex  # dv_n
    tangent_part: complex  # dv_t
    result: complex  # v_res
    after: complex  # v
    speed: float  # v_0

    @property
    def approach(self) -> float:
        """dv . n: below 0 where the two approach."""
        return dot(self.ball.velocity - self.surface, self.found.normal)

    @property
    def pace(self) -> float:
        """v_p . n: how fast the surface comes after the ball."""
        return dot(self.surface, self.found.normal)

    @property
    def stopped(self) -> bool:
        """Whether v_res is 0 but for rounding."""
        return length(self.result) <= STOPPED * self.speed

    @property
    def slow(self) -> bool:
        """Whether the reset to v_0 leaves the ball slower than the surface."""
        return not self.stopped and dot(self.result, self.found.normal) / length(self.result) * self.speed < self.pace


def _bounce(given: Given) -> _Bounce:
    """The bounce that the values make: the ball is put where it touches the paddle."""
    speed, mu = given.number("speed"), given.number("mu")
    ring = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, math.pi / 2.0, given.number("spin"), mu)
    velocity = to_cartesian(speed, given.angle("heading"))
    ball = _touching(given, ring, velocity)
    found = contact(ball, ring, 0)
    surface = ring.surface_velocity(found.point)
    normal_part = found.normal * dot(velocity - surface, found.normal)
    tangent_part = velocity - surface - normal_part
    result = literal.bounced(velocity, found.normal, surface, mu)
    after = collision_response(velocity, found.normal, surface, mu, speed)
    return _Bounce(ball, ring, found, surface, normal_part, tangent_part, result, after, speed)


def _touching(given: Given, ring: Ring, velocity: complex) -> Ball:
    """The ball, moved along the normal to where it just touches."""
    there = contact(Ball(given.point("ball"), velocity, _BALL_RADIUS), ring, 0)
    return Ball(there.point + there.normal * _BALL_RADIUS, velocity, _BALL_RADIUS)


def _start(given: Given) -> complex:
    """Where velocities are drawn from: the ball's centre."""
    return _bounce(given).ball.position


def _picture(given: Given) -> Picture:
    """The velocity before, its two parts relative to the paddle, and the velocity after."""
    bounce = _bounce(given)
    p, q = bounce.ball.position, bounce.found.point
    marks: list[Mark] = [*ring_marks(bounce.ring), *ball_marks(p, _BALL_RADIUS)]
    marks += contact_marks(bounce.ball, bounce.found)
    marks.append(_arrow(q, bounce.surface, Tone.TWO, "v_p"))
    marks.append(_arrow(p, bounce.normal_part, Tone.THREE, "Δv_n", Stroke.DASHED))
    marks.append(_arrow(p, bounce.tangent_part, Tone.FOUR, "Δv_t", Stroke.DASHED))
    marks.append(_arrow(p, bounce.ball.velocity, Tone.PLAIN, "v before"))
    marks.append(_arrow(p, bounce.after, Tone.GOOD, "v after"))
    marks += second_opinion(given, bounce.ball, bounce.ring, (0,), bounce.found)
    return single(tuple(marks), _formula(bounce), _deciding(bounce), _note(bounce))


def _arrow(start: complex, velocity: complex, tone: Tone, label: str, stroke: Stroke = Stroke.THICK) -> Arrow:
    """A velocity."""
    return Arrow(start, velocity * VELOCITY_SCALE, tone, None, stroke, label)


def _formula(bounce: _Bounce) -> tuple[str, ...]:
    """The source's four equations."""
    normal, tangent, mu = length(bounce.normal_part), length(bounce.tangent_part), bounce.ring.friction
    compared = f"Δv = v - v_p = {two_decimals(bounce.ball.velocity - bounce.surface)},   Δv · n = {bounce.approach:.2f}"
    if bounce.approach >= 0.0:
        return (compared, "Δv · n is not below 0: they separate, nothing happens")
    return (
        compared,
        f"Δv'_n = -2 Δv_n,   |Δv_n| = {normal:.2f}",
        f"Δv'_t = -μ min(|Δv_n|, |Δv_t|) Δv_t / |Δv_t|,   |Δv'_t| = {mu:g} · {min(normal, tangent):.2f}",
        f"v_res = v + Δv'_n + Δv'_t = {two_decimals(bounce.result)},   |v_res| = {length(bounce.result):.2f}",
        f"v := v_0 v_res / |v_res| = {two_decimals(bounce.after)},   v_0 = {bounce.speed:g}",
    )


def _deciding(bounce: _Bounce) -> Deciding:
    """The branch of the response that was taken."""
    if bounce.approach >= 0.0:
        return code(collision_response, "if approach >= 0.0")
    if bounce.stopped:
        return code(collision_response, "STOPPED * speed")
    if bounce.slow:
        return code(collision_response, "leaving_at(")
    return code(collision_response, "result = v - normal")


def _note(bounce: _Bounce) -> str:
    """What is special."""
    if bounce.approach >= 0.0:
        return "The ball already moves away from the surface: answering again would pull it back in."
    if bounce.stopped:
        return "|v_res| = 0: the surface retreats at half the ball's speed. There is no direction to keep; it leaves along n."
    if bounce.slow:
        return "At v_0 the ball would be slower than the surface, and be overtaken: it is carried along at the surface's pace."
    if length(bounce.tangent_part) == 0.0:
        return "|Δv_t| = 0: nothing slides, so there is no friction."
    return ""


def _check(given: Given) -> tuple[Claim, ...]:
    """What must be true of every bounce."""
    bounce = _bounce(given)
    normal, after, speed = bounce.found.normal, bounce.after, bounce.speed
    answered = bounce.approach < 0.0
    ordinary = answered and not bounce.stopped and not bounce.slow
    leaves = dot(after - bounce.surface, normal)
    kept = bounce.result - bounce.surface
    sliding = kept - normal * dot(kept, normal)
    tangent, mu = bounce.tangent_part, bounce.ring.friction
    least = min(length(bounce.normal_part), length(tangent))
    mirrored = collision_response(
        bounce.ball.velocity.conjugate(), normal.conjugate(), bounce.surface.conjugate(), bounce.ring.friction, speed
    )
    aligned = length(bounce.result) * speed - dot(bounce.result, after)
    taken = length(tangent) - length(sliding)
    return (
        Claim("the ball touches the paddle", abs(bounce.found.gap) < 1e-9),
        Claim("a ball that separates keeps its velocity", answered or after == bounce.ball.velocity),
        Claim("after a bounce the speed is v_0", not answered or abs(length(after) - speed) < 1e-9),
        Claim("it leaves no slower than the surface, if v_0 allows", not answered or leaves > -1e-9 or bounce.pace > speed),
        Claim("its direction is that of v_res", not ordinary or abs(aligned) < 1e-6),
        Claim("friction never turns the sliding round", not answered or dot(sliding, tangent) >= -1e-9),
        Claim("it takes μ min(|Δv_n|, |Δv_t|) of it", not answered or abs(taken - mu * least) < 1e-9),
        Claim("in a mirror it looks the same", mirrored == after.conjugate()),
    )


SCENE = Scene(
    name="response-paddle",
    title="Response: a moving paddle with friction",
    idea="The bounce happens in the frame of the surface that is touched: its motion, and its roughness, aim the ball.",
    functions=("collision_response",),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 0.8 + 7j, meaning="pulled to where it touches"),
        Number("heading", "ψ", "°", 0.0, 360.0, 60.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 0.5, 20.0, 10.0, 0.1, "the ball's fixed speed"),
        Number("spin", "ω", "rad/s", -3.0, 3.0, 0.6, 0.01, "the paddle's spin; v_p = ω × q"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.5, 0.01, "friction"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", _start, VELOCITY_SCALE, "velocity"),
        handles.Handle("ball", _start, lambda _given, place: {"ball": place}, lambda _given: _BALL_RADIUS),
    ),
    view=View(0.0 + 7.6j, 5.2 + 3.6j),
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
)
