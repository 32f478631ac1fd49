"""Velocity after a bounce (the source: "Collision response")."""

import math
from typing import NamedTuple

from physics.shapes import Ball, Contact, Feature, Ring
from physics.tolerances import LEAST_GRAZE, LEAST_SEPARATION, PARALLEL, STOPPED
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


def bounce(ball: Ball, found: Contact, ring: Ring, speed: float) -> complex:
    """Velocity of a ball after a contact: the response, and never so slowly off the surface that the two meet again at once."""
    v, normal, surface_velocity = ball.velocity, found.normal, ring.surface_velocity(found.point)
    after = collision_response(v, normal, surface_velocity, ring.friction, speed)
    least = dot(surface_velocity, normal) + least_separation(found, ring) * speed
    return leaving_at(after, v, normal, least, speed) if dot(after, normal) < least else after


def least_separation(found: Contact, ring: Ring) -> float:
    """Fraction of the ball's speed by which it leaves at least: more where the surface may follow the ball."""
    follows = found.feature == Feature.INNER_FACE or (ring.spin != 0.0 and found.feature != Feature.OUTER_FACE)
    return LEAST_SEPARATION if follows else LEAST_GRAZE


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


def bounce_off_two(ball: Ball, found: Contact, ring: Ring, other: Contact, other_ring: Ring, speed: float) -> complex | None:
    """Velocity of a ball that touches two surfaces at the same moment and approaches both; None where one bounce answers both.

    With a_i = (v - v_p,i) . n_i, both approaches are reversed at once: the change D has D . n_i = -2 a_i. In terms of
    s = n_1 + n_2 and d = n_1 - n_2, at right angles to each other, D = -2 (a_1 + a_2) s / s^2 - 2 (a_1 - a_2) d / d^2.
    Off surfaces at rest the ball goes straight back. The order of the two does not matter: what is its own mirror image
    stays so. None where the surfaces face the same or opposite directions, or where one of them would have to pull.
    """
    n, m = found.normal, other.normal
    both, apart = n + m, n - m
    both_square, apart_square = dot(both, both), dot(apart, apart)
    if min(both_square, apart_square) <= PARALLEL * PARALLEL:
        return None
    one = response_steps(ball.velocity, n, ring.surface_velocity(found.point), ring.friction, speed)
    two = response_steps(ball.velocity, m, other_ring.surface_velocity(other.point), other_ring.friction, speed)
    a, b = dot(one.relative, n), dot(two.relative, m)
    cosine = dot(n, m)
    if a - cosine * b >= 0.0 or b - cosine * a >= 0.0:
        return None  # the impulse of one surface alone makes the ball leave both
    change = both * (-2.0 * (a + b) / both_square) + apart * (-2.0 * (a - b) / apart_square)
    result = ball.velocity + change + one.tangential_change + two.tangential_change
    if length(result) <= STOPPED * speed:
        result = both
    after = unit(result) * speed
    for contact, under in ((found, ring), (other, other_ring)):
        least = dot(under.surface_velocity(contact.point), contact.normal) + least_separation(contact, under) * speed
        if dot(after, contact.normal) < least:
            return None
    return after
