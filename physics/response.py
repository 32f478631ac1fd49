"""Velocity after a bounce (the source: "Collision response")."""

import math
from typing import NamedTuple

from physics.tolerances import STOPPED
from physics.vectors import dot, length, quarter_turn, unit


class Response(NamedTuple):
    """Every quantity of the source's response, in the order of its slides; world units per second.

    While the two separate, dv . n >= 0, the changes are 0 and the velocity is v itself.

    Attributes:
        relative: dv = v - v_p.
        normal_part: dv_n = (dv . n) n.
        tangential_part: dv_t = dv - dv_n.
        normal_change: dv_n' = -2 dv_n, "bounce off the paddle".
        tangential_change: dv_t' = -mu min(|dv_n|, |dv_t|) dv_t / |dv_t|, "match the paddle's velocity".
        result: v_res = v + dv_n' + dv_t'.
        velocity: v := v_0 v_res / |v_res|, of length v_0, or what goes beyond the source.
    """

    relative: complex
    normal_part: complex
    tangential_part: complex
    normal_change: complex
    tangential_change: complex
    result: complex
    velocity: complex


def collision_response(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> complex:
    """Velocity of a ball after it bounces off a moving surface, of length `speed`; v itself when the two separate.

    v: the ball's velocity. normal: unit, from the surface to the ball. surface_velocity: of the surface at the contact
    point (the source's v_p). friction: mu in [0, 1]. speed: the ball's fixed speed v_0 > 0. All velocities in world units
    per second.
    `response_steps` has the quantities on the way.

    >>> collision_response(3 - 4j, 1j, 0j, 0.0, 5.0)
    (3+4j)
    """
    return response_steps(v, normal, surface_velocity, friction, speed).velocity


def response_steps(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> Response:
    """The steps of a collision response; arguments as of `collision_response`.

    Beyond the source: where v_res = 0 the ball leaves along the normal; where the reset to v_0 leaves it slower than the
    surface, it is carried: its normal speed is the surface's.
    """
    relative = v - surface_velocity
    approach = dot(relative, normal)
    normal_part = normal * approach
    tangential_part = relative - normal_part
    if approach >= 0.0:
        return Response(relative, normal_part, tangential_part, 0j, 0j, v, v)
    slip = length(tangential_part)
    grip = friction * min(-approach, slip) / slip if slip > 0.0 else 0.0
    normal_change = normal * (-2.0 * approach)
    tangential_change = tangential_part * -grip
    result = v + normal_change + tangential_change
    if length(result) <= STOPPED * speed:
        velocity = normal * speed
    else:
        velocity = unit(result) * speed
        pace = dot(surface_velocity, normal)
        if dot(velocity, normal) < pace:
            velocity = leaving_at(velocity, v, normal, pace, speed)
    return Response(relative, normal_part, tangential_part, normal_change, tangential_change, result, velocity)


def leaving_at(v: complex, before: complex, normal: complex, normal_speed: float, speed: float) -> complex:
    """Velocity of length `speed` with a given component along the normal, in the tangential sense of v.

    v = u n + tangent sqrt(v_0^2 - u^2). Where |u| >= v_0 no tangential part is left: the ball leaves along the normal.
    before: the ball's velocity before the bounce, whose sense counts where friction left v none.
    """
    if normal_speed >= speed:
        return normal * speed
    tangent = quarter_turn(normal)
    sense = dot(v, tangent)
    if abs(sense) <= STOPPED * speed:
        sense = dot(before, tangent)
    if sense < 0.0:
        tangent = -tangent
    along = math.sqrt(speed - normal_speed) * math.sqrt(speed + normal_speed) if normal_speed > -speed else 0.0
    return unit(normal * normal_speed + tangent * along) * speed
