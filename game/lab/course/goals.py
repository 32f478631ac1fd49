"""The goals of the exercises: what of a scene's values must hold, measured by the physics."""

import math
from typing import Any

from game.lab.course.tasks import GoalState
from game.lab.kit.bounce import Bounce, bounce
from game.lab.kit.parameters import Given
from physics import (
    Ball,
    Contact,
    Feature,
    Outcome,
    Ring,
    angle_of,
    broad_phase_outcome,
    contact,
    dot,
    length,
    min_difference,
    normalize_angle,
    to_cartesian,
)

_RADIUS, _HALF_WIDTH = 8.0, 0.9
"""The ring of the scene nearest-sector."""
_LEAST_ANGLE = 1e-9
"""Radians. A ring's half angle is above 0; the scene case-2 shows a sector of none, too."""


def between_the_rings(given: Given, _state: Any) -> GoalState:
    """The ball's centre is between bricks and paddles, and touches neither ring."""
    p = given.point("ball")
    paddles = Ring(given.number("r_p"), given.number("w_p"), math.pi, 1)
    bricks = Ring(given.number("r_b"), given.number("w_b"), math.pi, 1)
    outcome = broad_phase_outcome(p, given.number("r"), given.number("r_g"), paddles, [bricks])
    between = bricks.radius < length(p) < paddles.radius
    return GoalState(outcome is Outcome.NO_COLLISION and between, f"{outcome.value}, |p| = {length(p):.2f}")


def across_the_axis(given: Given, _state: Any) -> GoalState:
    """The plain difference is large, the angle small."""
    a, b = normalize_angle(given.angle("a")), normalize_angle(given.angle("b"))
    plain, least = math.degrees(a - b), math.degrees(min_difference(a, b))
    return GoalState(plain > 300.0 and least < 30.0, f"a - b = {plain:.1f}°, min_difference = {least:.1f}°")


def two_at_once(given: Given, _state: Any) -> GoalState:
    """The ball touches two sectors."""
    count = given.count("n")
    ring = Ring(_RADIUS, _HALF_WIDTH, given.number("fill") * math.pi / count, count, given.angle("phase"))
    ball = Ball(given.point("ball"), 0j, given.number("r"))
    touched = len([slot for slot in range(count) if contact(ball, ring, slot).gap < 0.0])
    return GoalState(touched >= 2 and given.number("fill") < 1.0, f"the ball touches {touched}")


def outer_face(given: Given, _state: Any) -> GoalState:
    """The ball just touches the outer face, by case 1."""
    found, over = _sector_contact(given)
    near = over and found.feature is Feature.OUTER_FACE and -0.1 <= found.gap <= 0.0
    return GoalState(near, f"case {1 if over else 2}, gap = {found.gap:.3f}")


def just_missed(given: Given, _state: Any) -> GoalState:
    """Case 2, and the ball misses the end by less than 0.1."""
    found, over = _sector_contact(given)
    return GoalState(not over and 0.0 < found.gap < 0.1, f"case {1 if over else 2}, gap = {found.gap:.3f}")


def outer_corner(given: Given, _state: Any) -> GoalState:
    """Case 2, and the ball touches the outer corner."""
    found, over = _sector_contact(given)
    outer = length(found.point) > given.number("radius")
    touches = not over and found.feature is Feature.CORNER and outer and found.gap < 0.0
    return GoalState(touches, f"nearest: {found.feature.value}, gap = {found.gap:.3f}")


def alongside(given: Given, _state: Any) -> GoalState:
    """The surface moves, and the ball neither approaches it nor leaves it."""
    found = _bounce(given)
    moves = length(found.surface_velocity) > 1.0
    return GoalState(moves and abs(found.approach) < 0.1, f"Δv · n = {found.approach:.2f}")


def nothing_slides(given: Given, _state: Any) -> GoalState:
    """Friction takes all of a sliding that was there."""
    found = _bounce(given)
    before, relative = length(found.steps.tangential_part), found.steps.result - found.surface_velocity
    after = length(relative - found.normal * dot(relative, found.normal))
    done = not found.separates and before > 2.0 and after < 0.05
    return GoalState(done, f"sliding before {before:.2f}, after {after:.2f}")


def nearly_stopped(given: Given, _state: Any) -> GoalState:
    """v_res is almost 0."""
    found = _bounce(given)
    return GoalState(not found.separates and length(found.steps.result) < 0.3, f"|v_res| = {length(found.steps.result):.2f}")


def straight_back(given: Given, _state: Any) -> GoalState:
    """A slanting ball leaves along the normal."""
    found = _bounce(given)
    slant = math.degrees(min_difference(angle_of(-found.v), angle_of(found.normal)))
    leaves = math.degrees(min_difference(angle_of(found.steps.velocity), angle_of(found.normal)))
    done = not found.separates and slant > 20.0 and leaves < 2.0
    return GoalState(done, f"comes at {slant:.1f}° to n, leaves at {leaves:.1f}°")


def _sector_contact(given: Given) -> tuple[Contact, bool]:
    """The contact in the scenes case-1 and case-2, and whether it is case 1."""
    ring = Ring(
        given.number("radius"), given.number("half_width"), max(given.angle("half_angle"), 1e-9), 1, given.angle("angle")
    )
    ball = Ball(given.point("ball"), 0j, given.number("r"))
    over = min_difference(angle_of(ball.position), ring.angle(0)) <= ring.half_angle
    return contact(ball, ring, 0), over


def _bounce(given: Given) -> Bounce:
    """The bounce in the scene moving-surface."""
    n, speed = to_cartesian(1.0, given.angle("normal")), given.number("speed")
    return bounce(to_cartesian(speed, given.angle("heading")), n, given.point("v_p"), given.number("mu"), speed)
