"""Comparison d for a ball that touches two sectors at the same moment: pymunk's solver answers both in one step."""

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tools.crosscheck.comparisons.bounce import (
    SolvedBounce,
    compared_mirror,
    least_departure,
    mirrored,
    velocity_rounding,
    with_friction,
)
from tools.crosscheck.comparisons.contact_check import ContactCheck
from tools.crosscheck.comparisons.hit_frame import CheckedTick, Moment, dot, moment_of
from tools.crosscheck.comparisons.rules import STOPPED
from tools.crosscheck.pymunk_model.one_bounce import ITERATIONS, Wall, bounced_off_walls
from tools.crosscheck.results.measurements import Compared, Comparison, ContactVerdict

_PARALLEL = 1e-6
"""Radians. Normals that differ by less, or by pi less so much, are those of one surface, or of a lane."""
_CERTAIN = 1e-6
"""Fraction of the speed, above the bounds of both engines: the rule that two sectors answer together certainly applies."""


class _Together(NamedTuple):
    """What both surfaces do with a ball.

    answers: each surface's own. velocity: of the fixed speed, after both. bound: how far rounding may take it.
    """

    answers: tuple[SolvedBounce, SolvedBounce]
    velocity: complex
    bound: float


def compare_double_bounce(checks: Sequence[ContactCheck]) -> None:
    """Compare one bounce off two sectors at once: each mirror, then the game's velocity with what both do together."""
    moment = checks[0].moment
    for check in checks:
        assert check.touched is not None
        check.measure(compared_mirror(check.moment, mirrored(check.moment, check.touched)))
    together = _answered(checks)
    if together is None:
        what = "two hits are one bounce, but off one and the same surface"
        compared = Compared(Comparison.VELOCITY, ContactVerdict.UNEXPLAINED, what, math.inf, 0.0, moment.hit.after)
    else:
        error = abs(moment.hit.after - together.velocity)
        fine = error <= together.bound
        what = "the velocities after a bounce off two sectors at once"
        if not fine:
            what = "the game's velocity is not that of a bounce off both sectors at once"
        verdict = ContactVerdict.EXACT if fine else ContactVerdict.UNEXPLAINED
        answers = moment.hit.after, together.velocity
        compared = Compared(Comparison.VELOCITY, verdict, what, error, together.bound, *answers)
    for check in checks:
        check.measure(compared)


def compare_sole_bounce(check: ContactCheck, checked: CheckedTick) -> None:
    """Notice a ball that touches a second sector, approaches both, and bounces off one of them only.

    Both count where neither impulse alone makes the ball leave both, and where it then leaves both fast enough.
    """
    for other in _others_touched(check, checked):
        together = _answered((check, other))
        if together is not None and _both_count(check, other, together):
            after = check.moment.hit.after
            what = "the ball touches two sectors at once and bounces off one of them only"
            error = abs(after - together.velocity)
            answers = after, together.velocity
            check.measure(Compared(Comparison.VELOCITY, ContactVerdict.UNEXPLAINED, what, error, together.bound, *answers))
            return


def _answered(checks: Sequence[ContactCheck]) -> _Together | None:
    """What two surfaces do with a ball together; None where they are one, or a lane.

    pymunk's solver answers both walls in one step, without friction. Each surface's friction is pymunk's, too: what its own
    bounce with friction differs from that without.
    """
    moment = checks[0].moment
    answers, walls = [], []
    friction = 0j
    for check in checks:
        assert check.touched is not None
        answer = mirrored(check.moment, check.touched)
        answers.append(answer)
        walls.append(Wall(answer.normal, check.touched.distance, answer.pushed))
        coefficient = check.moment.numbers.friction
        if coefficient > 0.0:
            friction += with_friction(check.moment, check.touched, answer, coefficient).velocity - answer.velocity
    n, m = answers[0].normal, answers[1].normal
    if min(abs(n + m), abs(n - m)) <= _PARALLEL:
        return None
    result = bounced_off_walls(moment.position, moment.hit.before, walls) + friction
    bound = _bound(moment, answers)
    size = abs(result)
    along = n + m if size <= STOPPED * moment.speed + bound else result
    bound = moment.speed * bound / max(size - bound, bound) + velocity_rounding(moment)
    return _Together((answers[0], answers[1]), along * (moment.speed / abs(along)), bound)


def _bound(moment: Moment, answers: Sequence[SolvedBounce]) -> float:
    """How far rounding may take the velocity after a bounce off two walls.

    The change of velocity is -2 (a + b) s / s^2 - 2 (a - b) d / d^2 for the approaches a and b, and the normals' sum s and
    difference d. The approaches err by what the surfaces' speeds and the normals do, s and d by the normals' errors; each
    term grows as 1 / |s| or 1 / |d|. pymunk's solver comes closer by the square of the normals' cosine each time.
    """
    n, m = answers[0].normal, answers[1].normal
    normal_error = math.fsum([answer.normal_error for answer in answers])
    push_error = math.fsum([answer.push_error for answer in answers])
    size = max([abs(moment.hit.before - answer.pushed) for answer in answers])
    steep = 1.0 / abs(n + m) + 1.0 / abs(n - m)
    unsolved = 4.0 * size * abs(dot(n, m)) ** (2 * ITERATIONS)
    return (2.0 * push_error + 8.0 * size * normal_error) * steep + unsolved + velocity_rounding(moment) * (1.0 + steep)


def _both_count(check: ContactCheck, other: ContactCheck, together: _Together) -> bool:
    """Whether the rule that two sectors answer together certainly applies."""
    speed, before = check.moment.speed, check.moment.hit.before
    one, two = together.answers
    a, b = dot(before - one.pushed, one.normal), dot(before - two.pushed, two.normal)
    cosine, margin = dot(one.normal, two.normal), _CERTAIN * speed
    if max(a - cosine * b, b - cosine * a) > -margin:
        return False
    for one_check, answer in ((check, one), (other, two)):
        assert one_check.touched is not None
        least = dot(answer.pushed, answer.normal) + least_departure(one_check.moment, one_check.touched) * speed
        if dot(together.velocity, answer.normal) < least + margin:
            return False
    return True


def _others_touched(check: ContactCheck, checked: CheckedTick) -> Iterator[ContactCheck]:
    """The shapes of other sectors that the ball touches at the same moment, as contacts of their own."""
    moment = check.moment
    touched = check.touched
    assert touched is not None
    for k, (ring, model) in enumerate(zip(checked.tick.arena.rings, checked.models, strict=True)):
        geometry, reach = model.geometry, touched.distance + moment.contact_noise
        if not model.living or abs(abs(moment.position) - geometry.radius) - geometry.half_width > reach:
            continue
        local = moment.position * cmath.rect(1.0, -(ring.phase + ring.spin * moment.hit.time))
        for shape, distance in model.exact_near(local, reach):
            if (k, shape.slot) == (moment.hit.ring, touched.shape.slot):
                continue
            other = ContactCheck(moment_of(checked, moment.hit._replace(ring=k, slot=shape.slot), moment.position))
            other.touched = model.contact(local, distance, shape)
            yield other
