"""One bounce with no friction, half of it, and all of it, side by side."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.bounce import Bounce, bounce
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks, two_decimals
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Arrow, Disc, Mark, Pane, Picture, RevealStep, Role, Stroke, Toggle, in_steps
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import Ball, Ring, contact, dot, length, response_steps, to_cartesian

FRICTIONS = (0.0, 0.5, 1.0)
_RADIUS, _HALF_WIDTH, _HALF_ANGLE = 6.0, 0.6, 0.5
_BALL_RADIUS = 0.5
_NORMAL_LENGTH = 1.2
"""World units drawn for the unit normal."""
_TOP = complex(0.0, _RADIUS + _HALF_WIDTH)
"""The touched point: the highest of the outer face, where the normal is the y axis."""
_CENTRE = _TOP + _BALL_RADIUS * 1j
"""Of the ball that touches there."""


class _FrictionBounces(NamedTuple):
    """A ball at the moment when it touches the paddle, and its bounce for each of FRICTIONS."""

    ball: Ball
    ring: Ring
    bounces: tuple[Bounce, ...]


def _friction_bounces(given: Given) -> _FrictionBounces:
    """The bounces that the values make."""
    speed = given.number("speed")
    ring = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, math.pi / 2.0, given.number("spin"))
    ball = Ball(_CENTRE, to_cartesian(speed, given.angle("heading")), _BALL_RADIUS)
    touch = contact(ball, ring, 0)
    surface = ring.surface_velocity(touch.point)
    return _FrictionBounces(ball, ring, tuple([bounce(ball.velocity, touch.normal, surface, mu, speed) for mu in FRICTIONS]))


def _picture(given: Given) -> Picture:
    """Three times the same bounce, each with another friction."""
    ball, ring, bounces = _friction_bounces(given)
    panes = tuple([Pane((), f"μ_p = {found.friction:g}") for found in bounces])
    p = ball.position
    situation: tuple[Mark, ...] = (
        *ring_marks(ring),
        Disc(p, ball.radius, Role.BALL),
        Arrow(_TOP, bounces[0].normal * _NORMAL_LENGTH, Role.OURS, Toggle.NORMALS, Stroke.SOLID, "n"),
    )
    before = (_arrow(_TOP, bounces[0].surface_velocity, Role.TWO, "v_p"), _arrow(p, bounces[0].v, Role.PLAIN, "v before"))
    tip = p + bounces[0].v * VELOCITY_SCALE
    changes = [(_arrow(tip, found.steps.tangential_change, Role.FOUR, "Δv'_t", Stroke.SOLID),) for found in bounces]
    after = [(_arrow(p, found.steps.velocity, Role.GOOD, "v after"),) for found in bounces]
    lines = _formula(bounces)
    steps = (
        RevealStep("the same bounce three times", (situation,) * 3),
        RevealStep("v and v_p", (before,) * 3, lines[:2]),
        RevealStep("Δv'_t, the friction", tuple(changes), lines[2:3]),
        RevealStep("v after the bounce", tuple(after), lines[3:]),
    )
    return in_steps(steps, _cited(bounces[0]), _note(bounces[0]), panes)


def _arrow(start: complex, velocity: complex, role: Role, label: str, stroke: Stroke = Stroke.THICK) -> Arrow:
    """A velocity."""
    return Arrow(start, velocity * VELOCITY_SCALE, role, None, stroke, label)


def _formula(bounces: tuple[Bounce, ...]) -> tuple[str, ...]:
    """The parts that are the same in all three, and what friction makes of them."""
    first = bounces[0]
    compared = f"Δv = v - v_p = {two_decimals(first.steps.relative)},   Δv · n = {first.approach:.2f}"
    if first.separates:
        return (compared, "Δv · n is not below 0: they separate, nothing happens")
    normal, tangential = length(first.steps.normal_part), length(first.steps.tangential_part)
    changes = ",   ".join([f"{found.friction:g}: {length(found.steps.tangential_change):.2f}" for found in bounces])
    angles = ",   ".join([f"{found.friction:g}: {_angle_to_normal(found.steps.velocity):.1f}°" for found in bounces])
    return (
        compared,
        f"|Δv_n| = {normal:.2f},   |Δv_t| = {tangential:.2f},   min(|Δv_n|, |Δv_t|) = {min(normal, tangential):.2f}",
        f"|Δv'_t| = μ_p min(|Δv_n|, |Δv_t|)   for μ_p = {changes}",
        f"angle from n to v after, above 0 clockwise,   for μ_p = {angles}",
    )


def _angle_to_normal(velocity: complex) -> float:
    """The angle between a velocity and the normal, degrees, above 0 clockwise."""
    return round(math.degrees(math.atan2(velocity.real, velocity.imag)), 1) + 0.0


def _cited(found: Bounce) -> CitedLine:
    """The line with the friction, unless nothing is answered."""
    if found.separates:
        return code_line(response_steps, "if approach >= 0.0:")
    return code_line(response_steps, "grip = friction * min(-approach, slip) / slip if slip > 0.0 else 0.0")


def _note(found: Bounce) -> str:
    """What is special about these values."""
    if found.separates:
        return "The ball moves away from the surface: there is no bounce, and friction does nothing."
    normal, tangential = length(found.steps.normal_part), length(found.steps.tangential_part)
    if tangential < 1e-9 * found.speed:
        return "|Δv_t| = 0: nothing slides, so all three are the same."
    if tangential <= normal:
        return (
            "|Δv_t| ≤ |Δv_n|: with μ_p = 1 friction takes all of the sliding, and v_res has the surface's tangential velocity."
        )
    return "|Δv_t| > |Δv_n|: friction is bounded by |Δv_n|. A grazing ball goes on sliding, even with μ_p = 1."


def _check(given: Given) -> tuple[Claim, ...]:
    """Friction acts along the surface only, and more of it leaves less sliding."""
    _, _, bounces = _friction_bounces(given)
    first = bounces[0]
    met = not first.separates
    normal, tangential = length(first.steps.normal_part), length(first.steps.tangential_part)
    along = [dot(found.steps.result, found.normal) for found in bounces]
    sliding = [length(_sliding(found)) for found in bounces]
    halves = abs(2.0 * length(bounces[1].steps.tangential_change) - length(bounces[2].steps.tangential_change))
    return (
        Claim("friction does not change v_res along the normal", not met or max(along) - min(along) < 1e-9),
        Claim("without friction v_res slides as before", not met or abs(sliding[0] - tangential) < 1e-9),
        Claim("more friction leaves no more sliding", not met or sliding[0] >= sliding[1] - 1e-9 >= sliding[2] - 2e-9),
        Claim("half the friction is half the change", not met or halves < 1e-9),
        Claim("with μ_p = 1 and |Δv_t| ≤ |Δv_n| nothing slides", not met or tangential > normal or sliding[2] < 1e-9),
        Claim(
            "all three have the speed v_0", all([abs(length(found.steps.velocity) - found.speed) < 1e-9 for found in bounces])
        ),
    )


def _sliding(found: Bounce) -> complex:
    """The tangential part of v_res relative to the surface."""
    relative = found.steps.result - found.surface_velocity
    return relative - found.normal * dot(relative, found.normal)


SCENE = LabScene(
    name="friction",
    title="Response: friction 0, 1/2 and 1",
    idea="Friction takes μ_p min(|Δv_n|, |Δv_t|) from the sliding, so that the paddle's own motion bends the ball's path.",
    functions=("collision_response",),
    parameters=(
        Number("heading", "ψ", "°", 0.0, 360.0, 300.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 0.5, 15.0, 9.0, 0.1, "the ball's fixed speed"),
        Number("spin", "ω", "rad/s", -2.0, 2.0, 0.4, 0.01, "the paddle's spin; v_p = ω × q"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda _: _CENTRE, VELOCITY_SCALE, "velocity")._replace(step=2),
        handles.Handle(
            "v_p",
            lambda given: _TOP - given.number("spin") * _TOP.imag * VELOCITY_SCALE,
            lambda _, target: {"spin": (_TOP - target).real / _TOP.imag / VELOCITY_SCALE},
            step=2,
        ),
    ),
    view_box=ViewBox(0.0 + 7.0j, 3.3 + 2.8j),
    shows=_picture,
    check=_check,
    presets=(
        Preset("against the paddle's motion", "heading=300&spin=0.4"),
        Preset("with the paddle's motion", "heading=300&spin=-0.5"),
        Preset("a paddle at rest", "spin=0"),
        Preset("grazing: friction is bounded", "heading=345&spin=0.8"),
        Preset("straight on", "heading=270&spin=0"),
        Preset("straight on, the paddle moves", "heading=270&spin=0.6"),
        Preset("separating", "heading=60"),
    ),
)
