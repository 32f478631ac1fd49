"""The bounce of a ball at the moment of touch: the source's response, and what an exact sweep needs beyond it.

A ball never leaves so slowly that it meets the surface again at once; and one that touches two surfaces at the same moment
bounces off both.
"""

from physics.response import collision_response, leaving_at, response_steps
from physics.shapes import Ball, Contact, Feature, Ring
from physics.tolerances import LEAST_GRAZE, LEAST_SEPARATION, PARALLEL, STOPPED
from physics.vectors import dot, length, unit


def bounce(ball: Ball, found: Contact, ring: Ring, speed: float) -> complex:
    """Velocity of a ball after a contact: the response, and never so slowly off the surface that the two meet again at once."""
    v, normal, surface_velocity = ball.velocity, found.normal, ring.surface_velocity(found.point)
    after = collision_response(v, normal, surface_velocity, ring.friction, speed)
    least = dot(surface_velocity, normal) + least_separation(found, ring) * speed
    return leaving_at(after, v, normal, least, speed) if dot(after, normal) < least else after


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


def least_separation(found: Contact, ring: Ring) -> float:
    """Fraction of the ball's speed by which it leaves at least: more where the surface may follow the ball."""
    follows = found.feature == Feature.INNER_FACE or (ring.spin != 0.0 and found.feature != Feature.OUTER_FACE)
    return LEAST_SEPARATION if follows else LEAST_GRAZE
