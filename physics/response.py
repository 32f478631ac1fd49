"""Velocity after a bounce (the source: "Collision response")."""

import math

from physics.tolerances import STOPPED
from physics.vectors import dot, length, quarter_turn, unit


def collision_response(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> complex:
    """Velocity of a ball after it bounces off a moving surface, of length `speed`; v itself when the two separate.

    v: the ball's velocity. normal: unit, from the surface to the ball. surface_velocity: of the surface at the contact
    point (the source's v_p). friction: mu in [0, 1]. speed: the ball's fixed speed v_0 > 0.

    With dv = v - v_p, split into dv_n along the normal and dv_t across it:
    dv_n' = -2 dv_n, dv_t' = -mu min(|dv_n|, |dv_t|) dv_t / |dv_t|, v_res = v + dv_n' + dv_t', v := v_0 v_res / |v_res|.

    Beyond the source: where v_res = 0 the ball leaves along the normal; where the reset to v_0 leaves it slower than the
    surface, it is carried: its normal speed is the surface's.

    >>> collision_response(3 - 4j, 1j, 0j, 0.0, 5.0)
    (3+4j)
    """
    relative = v - surface_velocity
    approach = dot(relative, normal)
    if approach >= 0.0:
        return v
    across = relative - normal * approach
    slip = length(across)
    grip = friction * min(-approach, slip) / slip if slip > 0.0 else 0.0
    result = v - normal * (2.0 * approach) - across * grip
    if length(result) <= STOPPED * speed:
        return normal * speed
    result = unit(result) * speed
    pace = dot(surface_velocity, normal)
    return leaving_at(result, normal, pace, speed) if dot(result, normal) < pace else result


def leaving_at(v: complex, normal: complex, normal_speed: float, speed: float) -> complex:
    """Velocity of length `speed` with a given component along the normal, its tangential sense kept.

    v = u n + tangent sqrt(v_0^2 - u^2). Where |u| >= v_0 no tangential part is left: the ball leaves along the normal.
    """
    if normal_speed >= speed:
        return normal * speed
    tangent = quarter_turn(normal)
    if dot(v, tangent) < 0.0:
        tangent = -tangent
    along = math.sqrt(speed - normal_speed) * math.sqrt(speed + normal_speed) if normal_speed > -speed else 0.0
    return unit(normal * normal_speed + tangent * along) * speed
