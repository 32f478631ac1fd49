"""Comparison d: pymunk's own solver answers the same bounce."""

import math

from physics import Feature
from physics.tolerances import LEAST_GRAZE, LEAST_SEPARATION, STOPPED
from tools.crosscheck.comparisons.diagnosis import named_velocity
from tools.crosscheck.comparisons.hit_frame import Moment
from tools.crosscheck.pymunk_model.one_bounce import Surface, bounced, movement
from tools.crosscheck.pymunk_model.ring_model import Part, Touch
from tools.crosscheck.results.cases import Class, Comparison
from tools.crosscheck.results.rows import Rows

_ROUNDINGS = 64
"""Half units in the last place of a velocity, in both engines' formulas together: about 30 operations each."""


def checked_bounce(moment: Moment, rows: Rows, touch: Touch) -> Class:
    """Compare the mirrored velocity, then the game's own with its friction and its fixed speed."""
    hit, ring = moment.hit, moment.ring
    surface = Surface(touch.piece, moment.model.geometry, moment.angle, ring.spin)
    normal = moment.world(touch.normal)
    pushed = 1j * ring.spin * (moment.position - normal * touch.distance)
    relative = hit.before - pushed
    mirrored = bounced(moment.position, hit.before, touch.distance, surface, 0.0)
    normal_error, push_error = _errors(moment, touch)
    raw = 2.0 * (abs(relative) * normal_error + push_error) + _rounding(moment)

    ours = (
        hit.before - 2.0 * _dot(hit.before - ring.surface_velocity(hit.contact.point), hit.contact.normal) * hit.contact.normal
    )
    error = abs(ours - mirrored)
    kind = Class.FACETS if error <= raw else Class.UNEXPLAINED
    what = "velocities without friction" if kind == Class.FACETS else "the normal leads to another bounce"
    rows.measure(moment, kind, Comparison.BOUNCE, what, (error, raw), (ours, mirrored))

    result = mirrored
    if ring.friction > 0.0:
        grip = _coulomb(relative, normal, ring.friction)
        result = bounced(moment.position, hit.before, touch.distance, surface, grip)
        raw *= 1.0 + ring.friction
    return max(kind, _checked_velocity(moment, rows, (result, normal, pushed), (raw, normal_error, push_error)))


def _checked_velocity(
    moment: Moment, rows: Rows, pymunks: tuple[complex, complex, complex], errors: tuple[float, float, float]
) -> Class:
    """Whether the game's velocity is pymunk's, with the source's and the game's rules applied to it.

    pymunks: velocity, normal and the surface's velocity; errors: the bounds of those three.

    The rules: the speed is reset, |a/|a| - b/|b|| <= 2 |a - b| / (|a| + |b|); a ball that is stopped leaves along the
    normal; one that would not leave the surface is carried: it leaves with the least normal speed, the rest of its speed
    along the surface.
    """
    result, normal, pushed = pymunks
    raw, normal_error, push_error = errors
    hit, speed = moment.hit, moment.tick.speed
    least = _dot(pushed, normal) + _least_departure(moment) * speed
    size = abs(result)
    stopped = size <= STOPPED * speed + raw
    expected = normal * speed if stopped else result * (speed / size)
    bound = speed * raw / max(size - raw, raw) + _rounding(moment)
    kind = Class.RULE if stopped else Class.FACETS
    if _dot(expected, normal) < least:
        expected = _carried(expected, normal, least, speed)
        if abs(_dot(result, 1j * normal)) <= raw:  # no sense along the surface is left, and rounding chooses one
            expected = min(expected, _mirrored(expected, normal), key=lambda one: abs(hit.after - one))
        steep = least / math.sqrt(max(speed * speed - least * least, 1e-12 * speed * speed))
        bound += push_error * (1.0 + abs(steep)) + speed * normal_error * (1.0 + abs(steep))
        kind = Class.RULE
    error = abs(hit.after - expected)
    if error > bound:
        kind, what = Class.UNEXPLAINED, f"the game's velocity is {named_velocity(moment, normal, bound)}"
    else:
        what = "carried or stopped: the rule applied" if kind == Class.RULE else "the velocities after the bounce"
    rows.measure(moment, kind, Comparison.VELOCITY, what, (error, bound), (hit.after, expected))
    if kind == Class.RULE:
        rows.disagree(moment.case(kind, Comparison.VELOCITY, what, (error, bound), (hit.after, result)))
    return kind


def _least_departure(moment: Moment) -> float:
    """The game's rule: the fraction of its speed by which a ball leaves what could meet it again at once."""
    feature = moment.hit.contact.feature
    follows = feature == Feature.INNER_FACE or (moment.ring.spin != 0.0 and feature != Feature.OUTER_FACE)
    return LEAST_SEPARATION if follows else LEAST_GRAZE


def _errors(moment: Moment, touch: Touch) -> tuple[float, float]:
    """Bounds for the normal, in radians, and for the surface's speed along it, per unit of the bounce.

    On a facet the surface moves along the normal, though an arc would not: by spin times the distance from the facet's middle.
    """
    normal = moment.normal_noise + movement(moment.hit.before) / moment.ball_radius
    push = abs(moment.ring.spin) * (moment.contact_noise + moment.ring.outer_radius * moment.normal_noise)
    if touch.piece.part == Part.INNER_FACET:
        normal += moment.half_facet
        push += abs(moment.ring.spin) * moment.model.geometry.inner * math.sin(moment.half_facet)
    return normal, push


def _coulomb(relative: complex, normal: complex, friction: float) -> float:
    """Coulomb's coefficient that makes pymunk's solver obey the source's law of friction in this bounce.

    The source changes the tangential velocity by mu min(|dv_n|, |dv_t|); Coulomb's law by its coefficient times the change
    of the normal velocity, 2 |dv_n|.
    """
    into = -_dot(relative, normal)
    across = abs(relative + normal * into)
    return friction * min(into, across) / (2.0 * into) if into > 0.0 else 0.0


def _carried(v: complex, normal: complex, least: float, speed: float) -> complex:
    """A velocity of that speed with the least normal component, its tangential sense kept."""
    tangent = normal * 1j
    if _dot(v, tangent) < 0.0:
        tangent = -tangent
    along = math.sqrt(max(speed * speed - least * least, 0.0))
    return normal * min(least, speed) + tangent * along


def _mirrored(v: complex, normal: complex) -> complex:
    """A velocity with the other sense along the surface."""
    return 2.0 * _dot(v, normal) * normal - v


def _rounding(moment: Moment) -> float:
    """World units per second: what rounding makes of a velocity."""
    return (
        _ROUNDINGS * 2.0**-53 * (moment.tick.speed + abs(moment.hit.before) + abs(moment.ring.spin) * moment.ring.outer_radius)
    )


def _dot(a: complex, b: complex) -> float:
    return (a.conjugate() * b).real
