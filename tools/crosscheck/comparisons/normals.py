"""Comparisons a and b at one hit: is pymunk's normal ours, and does pymunk touch at all?"""

import math

from tools.crosscheck.comparisons.contact_check import ContactCheck
from tools.crosscheck.comparisons.diagnosis import named_normal, with_article
from tools.crosscheck.comparisons.hit_frame import Moment, angle_between
from tools.crosscheck.pymunk_model.ring_model import Part, ShapeContact
from tools.crosscheck.results.measurements import FEATURE_OF_PART, Compared, Comparison, ContactVerdict

_NOTHING = "the game bounced where pymunk sees nothing (invented bounce)"


def compare_normals(check: ContactCheck) -> None:
    """Compare the gap, the normal on exact shapes and the normal on the chain; afterwards `touched` is known."""
    moment = check.moment
    exact = moment.model.exact(moment.local, moment.reach)
    if exact is None:
        ours = moment.hit.contact.normal
        check.measure(
            Compared(Comparison.PRESENCE_HIT, ContactVerdict.UNEXPLAINED, _NOTHING, math.inf, moment.contact_noise, ours)
        )
        return
    check.touched = exact
    check.measure(_presence(moment, exact))
    part = exact.shape.part
    check.touched = _compare_normal(check, exact, Comparison.NORMAL_EXACT, moment.normal_noise)
    if part == Part.INNER_CIRCLE and moment.model.inner_sagitta >= moment.ball_radius:
        return  # so coarse a chord lies on the other side of the ball's centre
    faceted = moment.model.faceted(moment.local, moment.reach)
    if faceted is not None:
        _compare_normal(check, faceted, Comparison.NORMAL_FACETS, moment.facet_bound(part))


def _presence(moment: Moment, touched: ShapeContact) -> Compared:
    """Whether pymunk, too, says that the ball touches."""
    gap = touched.distance - moment.ball_radius
    answers = moment.hit.contact.normal, moment.world(touched.normal)
    if abs(gap) <= moment.contact_noise:
        what = "the gap that pymunk measures"
        return Compared(Comparison.PRESENCE_HIT, ContactVerdict.EXACT, what, abs(gap), moment.contact_noise, *answers)
    what = f"the game bounced {'before' if gap > 0.0 else 'after'} pymunk touches ({gap:+.3g} units from touch)"
    return Compared(Comparison.PRESENCE_HIT, ContactVerdict.UNEXPLAINED, what, abs(gap), moment.contact_noise, *answers)


def _compare_normal(check: ContactCheck, touched: ShapeContact, comparison: Comparison, bound: float) -> ShapeContact:
    """Whether pymunk's normal is ours, to within the bound; else whether another shape as near has ours.

    Returns the shape whose normal is ours, or pymunk's nearest where there is none.
    """
    moment = check.moment
    answers = moment.hit.contact.normal, moment.world(touched.normal)
    error = angle_between(*answers)
    if error <= bound:
        check.measure(Compared(comparison, ContactVerdict.EXACT, "the angle between the two normals", error, bound, *answers))
        return touched
    other = _tied(moment, comparison, bound)
    if other is not None:
        names = [with_article(FEATURE_OF_PART[shape.shape.part]) for shape in (other, touched)]
        what = f"the game names {names[0]}, pymunk {names[1]}; both are equally near"
        check.note(Compared(comparison, ContactVerdict.TIE, what, error, bound, *answers))
        return other
    what = f"the game's normal is {named_normal(moment, touched)}"
    check.measure(Compared(comparison, ContactVerdict.UNEXPLAINED, what, error, bound, *answers))
    return touched


def _tied(moment: Moment, comparison: Comparison, bound: float) -> ShapeContact | None:
    """Another shape as near as the nearest, to within rounding or the chords' sagitta, whose normal agrees with the game's."""
    ours, slack = moment.hit.contact.normal, moment.contact_noise
    if comparison == Comparison.NORMAL_EXACT:
        near = moment.model.exact_near(moment.local, moment.ball_radius + slack)
        contacts = [moment.model.contact(moment.local, distance, shape) for shape, distance in near]
    else:
        slack += moment.model.sagitta
        contacts = moment.model.faceted_near(moment.local, moment.ball_radius + slack)
    for touched in contacts:
        near_enough = touched.distance >= moment.ball_radius - slack
        if near_enough and angle_between(ours, moment.world(touched.normal)) <= bound:
            return touched
    return None


def across(touched: ShapeContact, moment: Moment) -> float:
    """The position of a contact across its feature, from 0 to 1: along the arc, along the end, around the corner."""
    geometry = moment.model.geometry
    pitch = math.tau / geometry.count
    bearing = math.remainder(math.atan2(moment.local.imag, moment.local.real) - touched.shape.slot * pitch, math.tau)
    part = touched.shape.part
    if part in {Part.OUTER_CIRCLE, Part.INNER_CIRCLE}:
        return 0.5 + 0.5 * bearing / geometry.half_angle
    point = moment.local - touched.normal * touched.distance
    if part == Part.END:
        return (abs(point) - geometry.inner) / (2.0 * geometry.half_width)
    along_end = abs((point.conjugate() * touched.normal).real) / abs(point)
    return math.asin(min(along_end, 1.0)) / (math.pi / 2.0)
