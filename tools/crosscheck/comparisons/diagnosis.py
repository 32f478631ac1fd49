"""Names for disagreements: which mistake would explain what the game did?"""

import math

from tools.crosscheck.comparisons.hit_frame import Moment, angle_between, dot
from tools.crosscheck.pymunk_model.ring_model import Part, ShapeContact

_CLOSE = 1e-6
"""Radians, or a fraction of a speed: as near as a wrong formula that has been guessed right comes."""


def named_normal(moment: Moment, touched: ShapeContact) -> str:
    """What the game's normal is, where it is not pymunk's; completes "the game's normal is"."""
    ours = moment.hit.contact.normal
    pymunks = moment.world(touched.normal)
    if angle_between(ours, -pymunks) < _CLOSE:
        return "the opposite of pymunk's"
    nearest_first = sorted(
        moment.model.ends(moment.hit.slot), key=lambda end: end.point_query((moment.local.real, moment.local.imag)).distance
    )
    for index, end in enumerate(nearest_first):
        own = moment.world(complex(*end.normal))
        if min(angle_between(ours, own), angle_between(ours, -own)) < _CLOSE:
            if index == 0 and touched.shape.part == Part.CORNER:
                return "that of an end where pymunk has a corner"
            return "that of the sector's other end" if index else "that of an end"
    degrees = math.degrees(math.atan2((pymunks.conjugate() * ours).imag, (pymunks.conjugate() * ours).real))
    return f"turned by {degrees:+.3g} degrees"


def named_velocity(moment: Moment, normal: complex, bound: float) -> str:
    """What the game's velocity is, where it is not pymunk's; completes "the game's velocity is"."""
    hit, friction, speed = moment.hit, moment.numbers.friction, moment.speed
    tolerance = bound + _CLOSE * speed
    if abs(abs(hit.after) - speed) > tolerance:
        return f"of length {abs(hit.after):.6g}, not {speed:.6g}"
    if abs(hit.after - _bounced_at_rest(hit.before, normal, friction, speed)) <= tolerance:
        return "that off a ring at rest (its spin is ignored)"
    return "unchanged" if abs(hit.after - hit.before) <= tolerance else "another"


def with_article(feature: str) -> str:
    """A feature with "a" or "an" before it."""
    return f"{'an' if feature[0] in 'aeiou' else 'a'} {feature}"


def _bounced_at_rest(v: complex, normal: complex, friction: float, speed: float) -> complex:
    """The source's response of a surface that does not move: none if the ball leaves it."""
    into = dot(v, normal)
    if into >= 0.0:
        return v
    across = v - into * normal
    grip = friction * min(abs(into), abs(across)) / abs(across) if across else 0.0
    result = v - 2.0 * into * normal - grip * across
    return result * (speed / abs(result)) if result else normal * speed
