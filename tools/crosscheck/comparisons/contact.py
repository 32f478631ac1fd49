"""Comparisons a and b at one hit: is pymunk's normal ours, and does pymunk touch at all?"""

import math
from typing import NamedTuple

from tools.crosscheck.comparisons.diagnosis import named_normal
from tools.crosscheck.comparisons.hit_frame import Moment, angle_between, tie
from tools.crosscheck.pymunk_model.ring_model import Part, Touch
from tools.crosscheck.results.cases import Class, Comparison
from tools.crosscheck.results.rows import Rows


class Seen(NamedTuple):
    """What pymunk sees at a hit."""

    kind: Class
    touch: Touch | None  # the shape to bounce off; None where pymunk sees nothing near


_NOTHING = "the game bounced where pymunk sees nothing (invented bounce)"
_PART_NAMES = {
    Part.OUTER_FACET: "a facet of an outer face",
    Part.INNER_FACET: "a facet of an inner face",
    Part.END: "an end",
    Part.CORNER: "a corner",
    Part.OUTER_CIRCLE: "an outer face",
}


def checked_contact(moment: Moment, rows: Rows) -> Seen:
    """Compare normal and gap; the class of the contact and what pymunk touches there."""
    faceted = moment.model.faceted(moment.local, moment.reach)
    if faceted is None:
        distance, ours = math.inf, moment.hit.contact.normal
        rows.disagree(
            moment.case(Class.UNEXPLAINED, Comparison.PRESENCE_HIT, _NOTHING, (distance, moment.model.sagitta), (ours, 0j))
        )
        return Seen(Class.UNEXPLAINED, None)
    exact = moment.model.exact(moment.local, moment.reach)
    present = _present(moment, rows, exact or faceted)
    kind, touch = _same_normal(moment, rows, faceted, Comparison.NORMAL_FACETS, moment.facet_bound())
    if exact is not None:
        exact_kind, touch = _same_normal(moment, rows, exact, Comparison.NORMAL_EXACT, moment.normal_noise)
        kind = exact_kind if kind == Class.FACETS else max(kind, exact_kind)
    return Seen(max(kind, present), touch)


def _present(moment: Moment, rows: Rows, touch: Touch) -> Class:
    """Whether pymunk, too, says that the ball touches."""
    bound = moment.contact_noise + (moment.model.inner_sagitta if touch.piece.part == Part.INNER_FACET else 0.0)
    gap = touch.distance - moment.ball_radius
    fine = abs(gap) <= bound
    kind = _fine(touch) if fine else Class.UNEXPLAINED
    what = "the gap that pymunk measures"
    if not fine:
        what = f"the game bounced {'before' if gap > 0.0 else 'after'} pymunk touches ({gap:+.3g} units from touch)"
    rows.measure(
        moment, kind, Comparison.PRESENCE_HIT, what, (abs(gap), bound), (moment.hit.contact.normal, moment.world(touch.normal))
    )
    return kind


def _same_normal(moment: Moment, rows: Rows, touch: Touch, comparison: Comparison, bound: float) -> tuple[Class, Touch]:
    """Whether pymunk's normal is ours, to within the bound; else whether another shape as near has ours."""
    answers = moment.hit.contact.normal, moment.world(touch.normal)
    error = angle_between(*answers)
    if error <= bound:
        rows.measure(moment, _fine(touch), comparison, "the angle between the two normals", (error, bound), answers)
        return _fine(touch), touch
    other = tie(moment, bound)
    names = f"the game names {_with_article(moment.feature)}, pymunk {_PART_NAMES[touch.piece.part]}"
    if other is not None:
        what = f"{names}; both are equally near"
        rows.disagree(moment.case(Class.TIE, comparison, what, (error, bound), answers))
        return Class.TIE, other
    what = f"the game's normal is {named_normal(moment, touch)}"
    rows.measure(moment, Class.UNEXPLAINED, comparison, what, (error, bound), answers)
    return Class.UNEXPLAINED, touch


def _fine(touch: Touch) -> Class:
    """The class of an error within its bound."""
    return Class.FACETS if touch.piece.part in {Part.OUTER_FACET, Part.INNER_FACET} else Class.EXACT


def _with_article(feature: str) -> str:
    return f"{'an' if feature[0] in 'aeiou' else 'a'} {feature}"
