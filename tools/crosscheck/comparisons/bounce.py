"""Comparison d: pymunk's own solver answers the same bounce."""

import math
from typing import NamedTuple

from tools.crosscheck.comparisons.contact_check import ContactCheck
from tools.crosscheck.comparisons.diagnosis import named_velocity
from tools.crosscheck.comparisons.hit_frame import Moment, dot
from tools.crosscheck.comparisons.rules import LEAST_GRAZE, LEAST_SEPARATION, STOPPED
from tools.crosscheck.pymunk_model.one_bounce import Solver, TouchingBall, movement
from tools.crosscheck.pymunk_model.ring_model import Part, ShapeContact
from tools.crosscheck.results.measurements import Compared, Comparison, ContactVerdict

_ROUNDINGS = 64
"""Half units in the last place of a velocity, in both engines' formulas together: about 30 operations each."""


_SOLVER = Solver()


class SolvedBounce(NamedTuple):
    """What pymunk makes of a bounce, and how far rounding may have taken it.

    normal: of the shape, in the world. pushed: the surface's velocity. velocity: after the bounce, before the game's rules.
    normal_error: radians; push_error, velocity_error: world units per second.
    """

    normal: complex
    pushed: complex
    velocity: complex
    normal_error: float
    push_error: float
    velocity_error: float


def compare_bounce(check: ContactCheck) -> None:
    """Compare the mirrored velocity, then the game's own with its friction and its fixed speed."""
    assert check.touched is not None
    moment, touched = check.moment, check.touched
    answer = mirrored(moment, touched)
    check.measure(compared_mirror(moment, answer))
    friction = moment.numbers.friction
    if friction > 0.0:
        answer = with_friction(moment, touched, answer, friction)
    check.measure(_compared_velocity(moment, touched, answer))


def mirrored(moment: Moment, touched: ShapeContact) -> SolvedBounce:
    """pymunk's bounce without friction."""
    normal, pushed = moment.world(touched.normal), moment.pushed(touched)
    relative = moment.hit.before - pushed
    normal_error = moment.normal_noise + movement(moment.hit.before) / moment.ball_radius
    push_error = abs(moment.spin) * (moment.contact_noise + moment.model.geometry.outer * moment.normal_noise)
    velocity_error = 2.0 * (abs(relative) * normal_error + push_error) + velocity_rounding(moment)
    velocity = _SOLVER.bounced(_ball(moment, touched, normal), moment.surface(touched), 0.0)
    return SolvedBounce(normal, pushed, velocity, normal_error, push_error, velocity_error)


def with_friction(moment: Moment, touched: ShapeContact, answer: SolvedBounce, friction: float) -> SolvedBounce:
    """pymunk's bounce with Coulomb's coefficient that makes its solver obey the source's law of friction.

    The source changes the tangential velocity by mu min(|dv_n|, |dv_t|); Coulomb's law by its coefficient times the change
    of the normal velocity, 2 |dv_n|.
    """
    relative = moment.hit.before - answer.pushed
    into = -dot(relative, answer.normal)
    across = abs(relative + answer.normal * into)
    coefficient = friction * min(into, across) / (2.0 * into) if into > 0.0 else 0.0
    velocity = _SOLVER.bounced(_ball(moment, touched, answer.normal), moment.surface(touched), coefficient)
    return answer._replace(velocity=velocity, velocity_error=answer.velocity_error * (1.0 + friction))


def compared_mirror(moment: Moment, answer: SolvedBounce) -> Compared:
    """The game's normal and contact point, put into the mirror's formula, against pymunk's bounce."""
    contact, before = moment.hit.contact, moment.hit.before
    approach = dot(before - 1j * moment.spin * contact.point, contact.normal)
    ours = before - 2.0 * approach * contact.normal
    error = abs(ours - answer.velocity)
    fine = error <= answer.velocity_error
    verdict = ContactVerdict.EXACT if fine else ContactVerdict.UNEXPLAINED
    what = "velocities without friction" if fine else "the normal or the point leads to another bounce"
    return Compared(Comparison.BOUNCE, verdict, what, error, answer.velocity_error, ours, answer.velocity)


def _compared_velocity(moment: Moment, touched: ShapeContact, answer: SolvedBounce) -> Compared:
    """Whether the game's velocity is pymunk's, with the source's and the game's rules applied to it.

    The rules: the speed is reset, |a/|a| - b/|b|| <= 2 |a - b| / (|a| + |b|); a ball that is stopped leaves along the
    normal; one that would not leave the surface is carried: it leaves with the least normal speed, the rest of its speed
    along the surface.
    """
    normal, pushed, result, normal_error, push_error, raw = answer
    after, speed = moment.hit.after, moment.speed
    least = dot(pushed, normal) + least_departure(moment, touched) * speed
    size = abs(result)
    stopped = size <= STOPPED * speed + raw
    expected = normal * speed if stopped else result * (speed / size)
    bound = speed * raw / max(size - raw, raw) + velocity_rounding(moment)
    ruled = stopped
    if dot(expected, normal) < least:
        expected = _carried(expected, normal, least, speed)
        if abs(dot(result, 1j * normal)) <= raw:  # no sense along the surface is left, and rounding chooses one
            other = 2.0 * dot(expected, normal) * normal - expected
            expected = min(expected, other, key=lambda one: abs(after - one))
        steep = least / math.sqrt(max(speed * speed - least * least, 1e-12 * speed * speed))
        bound += (push_error + speed * normal_error) * (1.0 + abs(steep))
        ruled = True
    error = abs(after - expected)
    if error > bound:
        what = f"the game's velocity is {named_velocity(moment, normal, bound)}"
        return Compared(Comparison.VELOCITY, ContactVerdict.UNEXPLAINED, what, error, bound, after, expected)
    verdict = ContactVerdict.RULE if ruled else ContactVerdict.EXACT
    what = "carried or stopped: the rule applied" if ruled else "the velocities after the bounce"
    return Compared(Comparison.VELOCITY, verdict, what, error, bound, after, result if ruled else expected)


def least_departure(moment: Moment, touched: ShapeContact) -> float:
    """The game's rule: the fraction of its speed by which a ball leaves what could meet it again at once."""
    part = touched.shape.part
    follows = part == Part.INNER_CIRCLE or (moment.spin != 0.0 and part != Part.OUTER_CIRCLE)
    return LEAST_SEPARATION if follows else LEAST_GRAZE


def _ball(moment: Moment, touched: ShapeContact, normal: complex) -> TouchingBall:
    """The ball at the moment of touch."""
    return TouchingBall(moment.position, moment.hit.before, normal, touched.distance)


def _carried(v: complex, normal: complex, least: float, speed: float) -> complex:
    """A velocity of that speed with the least normal component and the same tangential sense."""
    tangent = normal * 1j
    if dot(v, tangent) < 0.0:
        tangent = -tangent
    along = math.sqrt(max(speed * speed - least * least, 0.0))
    return normal * min(least, speed) + tangent * along


def velocity_rounding(moment: Moment) -> float:
    """World units per second: what rounding makes of a velocity."""
    rim = abs(moment.spin) * moment.model.geometry.outer
    return _ROUNDINGS * 2.0**-53 * (moment.speed + abs(moment.hit.before) + rim)
