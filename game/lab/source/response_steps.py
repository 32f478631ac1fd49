"""The collision response, step by step: the source's four equations, and the result of the physics."""

from typing import NamedTuple

from physics import collision_response, dot, length


class ResponseSteps(NamedTuple):
    """Every velocity of one bounce, in the order in which the source computes them ("Collision response").

    relative: Δv = v - v_p.
    normal_part: Δv_n = (Δv · n) n.
    tangential_part: Δv_t = Δv - Δv_n.
    normal_change: Δv'_n = -2 Δv_n.
    tangential_change: Δv'_t = -μ min(|Δv_n|, |Δv_t|) Δv_t / |Δv_t|.
    before_reset: v_res = v + Δv'_n + Δv'_t.
    result: the velocity of length v_0 that `physics.collision_response` returns.

    Where the ball and the surface separate, both changes are 0 and both velocities after them are v.
    """

    relative: complex
    normal_part: complex
    tangential_part: complex
    normal_change: complex
    tangential_change: complex
    before_reset: complex
    result: complex


def response_steps(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> ResponseSteps:
    """The steps of one bounce. The arguments are those of `physics.collision_response`."""
    result = collision_response(v, normal, surface_velocity, friction, speed)
    relative = v - surface_velocity
    approach = dot(relative, normal)
    normal_part = normal * approach
    tangential_part = relative - normal_part
    if approach >= 0.0:
        return ResponseSteps(relative, normal_part, tangential_part, 0j, 0j, v, result)
    slip = length(tangential_part)
    share = friction * min(-approach, slip) / slip if slip > 0.0 else 0.0
    normal_change, tangential_change = normal_part * -2.0, tangential_part * -share
    before_reset = v + normal_change + tangential_change
    return ResponseSteps(relative, normal_part, tangential_part, normal_change, tangential_change, before_reset, result)
