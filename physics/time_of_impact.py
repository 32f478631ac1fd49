"""First touch of a moving ball with a turning ring, exact in time.

The sweep says *when*, the source's functions say *what*. On each stretch of the flight in the ring's band the nearest slot
is asked for (`physics.sweep.band`). Where a stretch begins above a sector, that moment is the touch of a face: of an outer
one flying inward, of an inner one flying outward. Where it begins over a gap, the touch can only be with one of the gap's two
ends (`gap`), at rest (`resting_end`) or turning (`turning_end`, all in `physics.sweep`). At the moment of touch the narrow
phase says what is touched, and with which normal.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.broad_phase import nearest_slot
from physics.narrow_phase import contact_above, end_contact, is_over, nearest_end
from physics.polar import signed_difference
from physics.shapes import Ball, Contact, Feature, Ring
from physics.sweep.band import Stretch, band_stretches
from physics.sweep.gap import End, angle_of_end, gap_end
from physics.sweep.resting_end import touch_of_resting_end
from physics.sweep.turning_end import touch_of_turning_end
from physics.tolerances import TOUCH
from physics.vectors import dot, length


class Impact(NamedTuple):
    """The first touch of a ball with a ring.

    Attributes:
        time: seconds from now.
        slot: the sector that is touched.
        contact: at that moment.
    """

    time: float
    slot: int
    contact: Contact


def time_of_impact(ball: Ball, ring: Ring, dt: float, alive: Sequence[int] | None = None) -> Impact | None:
    """The first touch of the ball with a living sector within dt seconds, or None.

    ball and ring are given at time 0; dt: seconds, finite and >= 0, else ValueError. alive: one entry per slot, 0 where
    the slot is empty; None for a ring with all its sectors.
    A ball that touches or overlaps a sector at time 0 has its impact at 0 if it approaches it, and none with that
    sector while it separates from it. A graze that brings the ball no nearer than TOUCH may count as a touch or not.
    """
    if not 0.0 <= dt < math.inf:
        raise ValueError(f"dt must be finite and at least 0, not {dt}")
    return first_impact(ball, ring, dt, (1,) * ring.count if alive is None else alive)


def first_impact(ball: Ball, ring: Ring, dt: float, alive: Sequence[int]) -> Impact | None:
    """`time_of_impact` without its checks: dt is valid, and alive is given."""
    inward, outward = band_stretches(ball, ring, dt)
    impact = None if inward is None else _first_touch(ball, ring, inward, alive)
    if impact is None and outward is not None:
        impact = _first_touch(ball, ring, outward, alive)
    return impact


def _first_touch(ball: Ball, ring: Ring, stretch: Stretch, alive: Sequence[int]) -> Impact | None:
    """The first touch on one stretch of the flight."""
    start, span = stretch.start, stretch.stop - stretch.start
    if start > 0.0:
        ball = ball.moved(start)
        ring = ring.turned(start)
    theta = ball.theta()
    slot = nearest_slot(ring, theta)
    angle = ring.angle(slot)
    over = alive[slot] != 0 and is_over(ring, theta, angle)
    if over:
        found = contact_above(ball, ring, theta, angle)
        if _meets(ball, ring, found, stretch.heading):
            return Impact(start, slot, found)
        if _leaves(ball, ring, found, stretch.heading):
            return None
    reach = angular_reach(ball, ring, span)
    offset = signed_difference(theta, angle)
    clockwise = gap_end(ring, alive, slot, offset, -1, int(over), reach)
    counter = gap_end(ring, alive, slot, offset, 1, int(over), reach)
    first = None if clockwise is None else _touch_of_end(ball, ring, clockwise, span)
    second = None if counter is None else _touch_of_end(ball, ring, counter, span)
    if first is None or (second is not None and _is_before(second, first)):
        first = second
    return None if first is None else Impact(start + first.time, first.slot, first.contact)


def touched_now(ball: Ball, ring: Ring, alive: Sequence[int]) -> tuple[Impact | None, Impact | None]:
    """The sectors of a ring that the ball touches and approaches at this very moment: the one it is over, or its gap's ends.

    Touching means a gap of at most TOUCH. The ball reaches into the ring's band. The impacts' time is 0.
    """
    touch = TOUCH * (ring.radius + ring.half_width + ball.radius)
    theta = ball.theta()
    slot = nearest_slot(ring, theta)
    angle = ring.angle(slot)
    if alive[slot] != 0 and is_over(ring, theta, angle):
        return _touch(ball, ring, slot, contact_above(ball, ring, theta, angle), touch), None
    reach, offset = angular_reach(ball, ring, 0.0), signed_difference(theta, angle)
    clockwise, counter = gap_end(ring, alive, slot, offset, -1, 0, reach), gap_end(ring, alive, slot, offset, 1, 0, reach)
    return (
        None if clockwise is None else _touch(ball, ring, clockwise.slot, _contact_with(ball, ring, clockwise), touch),
        None if counter is None else _touch(ball, ring, counter.slot, _contact_with(ball, ring, counter), touch),
    )


def _touch(ball: Ball, ring: Ring, slot: int, found: Contact, touch: float) -> Impact | None:
    """The impact of a contact, at time 0, if its gap is closed and the ball approaches."""
    return Impact(0.0, slot, found) if found.gap <= touch and approaches(ball, ring, found) else None


def _is_before(one: Impact, other: Impact) -> bool:
    """Whether an impact is answered before another one: the earlier, and of equally early ones the lower slot."""
    return one.slot < other.slot if one.time == other.time else one.time < other.time


def _meets(ball: Ball, ring: Ring, found: Contact, heading: int) -> bool:
    """Whether a ball above a sector meets it: a face by its heading, an end, from inside, by the rate of the gap."""
    if found.feature == Feature.OUTER_FACE:
        return heading < 0
    if found.feature == Feature.INNER_FACE:
        return heading > 0
    return approaches(ball, ring, found)


def _leaves(ball: Ball, ring: Ring, found: Contact, heading: int) -> bool:
    """Whether a ball above a sector flies away from its face. Then it touches no end: all of the ring lies behind the face.

    A ball that overlaps the face by more than TOUCH may still touch an end.
    """
    if found.gap < -TOUCH * (ring.radius + ring.half_width + ball.radius):
        return False
    return (heading > 0 and found.feature == Feature.OUTER_FACE) or (heading < 0 and found.feature == Feature.INNER_FACE)


def approaches(ball: Ball, ring: Ring, found: Contact) -> bool:
    """Whether the ball moves towards the surface at a contact: (v - v_p) . n < 0."""
    return dot(found.normal, ball.velocity - ring.surface_velocity(found.point)) < 0.0


def _touch_of_end(ball: Ball, ring: Ring, end: End, span: float) -> Impact | None:
    """The first touch with one end within `span` seconds, and what is touched at that moment."""
    time = time_to_end(ball, ring, end, span)
    if time is None:
        return None
    return Impact(time, end.slot, _contact_with(ball.moved(time), ring.turned(time), end))


def time_to_end(ball: Ball, ring: Ring, end: End, span: float) -> float | None:
    """Seconds until the first touch with one end, within `span` seconds, or None."""
    if ring.spin == 0.0:
        return touch_of_resting_end(ball, ring, end, span)
    return touch_of_turning_end(ball, ring, end, span)


def gap_of_end(ball: Ball, ring: Ring, end: End) -> float:
    """World units between the ball and one end, < 0 where they overlap."""
    angle = ring.angle(end.slot)
    nearest = nearest_end(ball.position, angle_of_end(ring, end), ring.radius, angle, ring.half_width, ring.half_angle)
    return length(ball.position - nearest.q) - ball.radius


def _contact_with(ball: Ball, ring: Ring, end: End) -> Contact:
    """Contact with one end of a gap, wherever the ring has turned since the gap was found."""
    return end_contact(ball, ring, end.slot, angle_of_end(ring, end))


def angular_reach(ball: Ball, ring: Ring, span: float) -> float:
    """Angle beyond which no end can be touched within `span` seconds; infinite for a ball that may cover the centre.

    A disc of radius s at distance d > s from the centre is seen under asin(s / d) <= s pi / (2 d) to each side.
    """
    distance = length(ball.position)
    travel = length(ball.velocity) * span + ball.radius + TOUCH * (ring.radius + ring.half_width + ball.radius)
    if distance <= travel:
        return math.inf
    return travel * math.pi / (2.0 * distance) + abs(ring.spin) * span
