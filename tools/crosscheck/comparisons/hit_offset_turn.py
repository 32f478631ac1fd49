"""Comparison h: the arcade rules' turn of a ball by the position of its hit on a paddle.

Computed again from the level's number and the point that the flight leads to. Where the rules aim at a brick as well, only the
bounds are held: the turn goes at most AIM_MOST further, and never back into the paddle.
"""

import cmath
import math

from tools.crosscheck.comparisons.hit_frame import CheckedTick, angle_between, dot
from tools.crosscheck.comparisons.rules import AIM_MOST, MOST_LEANING, TURN_NOISE
from tools.crosscheck.games.trajectory import Answer, Leg
from tools.crosscheck.results.measurements import Compared, Comparison, ContactVerdict, Measurement
from tools.crosscheck.results.rows import ContactRows


def compare_hit_offset_turns(checked: CheckedTick, ends: dict[int, Leg], rows: ContactRows) -> None:
    """Compare every answer of a tick. ends: by the hit's id, the leg that led to it."""
    for answer in checked.tick.answers:
        leg = ends.get(id(answer.hit))
        if leg is None:
            continue
        error, bound = _difference(checked, answer, leg.end)
        inward = dot(answer.velocity, -leg.end) > 0.0
        fine = error <= bound and inward
        verdict = ContactVerdict.EXACT if fine else ContactVerdict.UNEXPLAINED
        what = "the turn by the position of the hit" if inward else "the rules turned the ball back into the paddle"
        compared = Compared(Comparison.TURN, verdict, what, error, bound)
        situation = checked.situation(answer.hit.ball, answer.hit.ring, leg.end, answer.hit.time)
        rows.report(Measurement(compared, situation))


def _difference(checked: CheckedTick, answer: Answer, centre: complex) -> tuple[float, float]:
    """Radians between the direction in which a ball flies on and the one computed, and the bound."""
    hit, level = answer.hit, checked.tick.level
    ring = checked.tick.arena.rings[hit.ring]
    middle = ring.phase + ring.spin * hit.time + hit.slot * math.tau / ring.count
    offset = cmath.phase(centre * cmath.rect(1.0, -middle))
    share = max(-1.0, min(1.0, offset / level.rings[hit.ring].geometry.half_angle))
    normal = -centre / abs(centre)
    leaning = cmath.phase(hit.after * normal.conjugate())
    most = max(MOST_LEANING, abs(leaning))
    wanted = normal * cmath.rect(1.0, max(-most, min(most, leaning - share * level.turn)))
    return angle_between(answer.velocity, wanted), AIM_MOST + TURN_NOISE if answer.aimed else TURN_NOISE
