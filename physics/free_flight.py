"""For how long does no ball certainly touch anything, whatever the player does to the paddles meanwhile?

A ball outside a ring's band touches nothing of it before it enters the band. Inside the band of a ring that keeps its spin, the
same search says when it touches an end as in a tick, for a ball that is larger by far more than what rounding can do.
For a ring that may be steered, it touches nothing before its way around the centre, its own size and the ring's turning have
used up the angle to the next sector on either side: the ring's rim is taken to be as fast as the ball, or as it is where that
is more. If a ring is turned faster than that, or one is steered that was to keep its spin, what was known is dropped and
computed anew.

While a free flight lasts, a tick moves balls and rings and looks at nothing. That changes no bit of the result.
"""

import math
from collections.abc import Sequence

from physics.broad_phase import in_band, nearest_slot
from physics.narrow_phase import is_over
from physics.polar import signed_difference
from physics.shapes import Arena, Ball, Ring, unchecked
from physics.sweep.band import Stretch, band_stretches
from physics.sweep.gap import gap_end
from physics.time_of_impact import angular_reach, gap_of_end, time_to_end
from physics.tolerances import ANGLE_SLACK, CLEARANCE, LARGEST, TOUCH
from physics.vectors import cross, dot, length

_LONGEST_TURN = 1000.0
"""Radians. A ring that turns by more within the horizon is not followed exactly: rounding its turns tick by tick adds up."""

FreeFlight = tuple[Arena, float, tuple[int, ...]]
"""What one step knows of the ticks after it; opaque to callers, who hand it back to `advance`.

The arena of which it is known, no ball of which overlaps anything; the seconds for which no ball touches anything, however
a turning ring is steered, 0 where that is not known; the indices of the rings that turn. A plain tuple: one is made in
every tick, and a class of its own would cost a tenth of it.
"""


def free_flight(arena: Arena, horizon: float) -> FreeFlight:
    """The free flight of every ball of an arena, for at most `horizon` seconds. No ball may overlap anything."""
    seconds = horizon
    for ball in arena.balls:
        seconds = clear_time(ball, arena.rings, arena.layers, seconds)
    return arena, seconds, tuple([k for k in range(len(arena.rings)) if arena.rings[k].spin != 0.0])


def still_known(flight: FreeFlight, arena: Arena) -> FreeFlight | None:
    """The flight where an arena is the one it is of, but for the spin of rings that turn; else None."""
    balls, rings, layers = arena
    before, _, _ = flight
    if balls is not before.balls or layers is not before.layers or len(rings) != len(before.rings):
        return None
    for k in range(len(rings)):
        if rings[k] is not before.rings[k] and not may_be_steered(before.rings[k], rings[k], balls):
            return None
    return flight


def may_be_steered(old: Ring, new: Ring, balls: Sequence[Ball]) -> bool:
    """Whether clear times of these balls found for the old ring hold for the new one: it is the same, but for its spin.

    It turned, and turns no faster than before, or its rim is no faster than any of the balls.
    """
    if old.spin == 0.0 or new[:5] != old[:5]:
        return False
    if abs(new.spin) <= abs(old.spin):
        return True
    rim = abs(new.spin) * (new.radius + new.half_width)
    for ball in balls:  # noqa: SIM110  # half as fast with all()
        if rim > length(ball.velocity):
            return False
    return True


def clear_time(
    ball: Ball,
    rings: Sequence[Ring],
    layers: Sequence[Sequence[int]],
    horizon: float,
    steered: Sequence[int] | None = None,
    order: Sequence[int] | None = None,
) -> float:
    """Seconds, at most `horizon`, for which a ball certainly touches no living sector; 0 where it may touch one now.

    layers: per ring and slot, 0 where nothing is. horizon: seconds, >= 0, finite. steered: per ring, not 0 if its spin may
    change meanwhile; None for all that turn. The others are assumed to keep their spin. order: numbers of all rings, in which
    they are examined; None for 0, 1, 2, ... It only saves time: rings behind a touched ring need no search.
    """
    p, v, ball_radius = ball
    distance, speed, outward = length(p), length(v), dot(p, v) >= 0.0
    if not speed * horizon <= LARGEST:
        return 0.0
    slack = CLEARANCE * (distance + ball_radius + speed * horizon)
    clear = horizon
    for n in range(len(rings)):
        k = n if order is None else order[n]
        ring = rings[k]
        larger = ball_radius + slack + 2.0 * TOUCH * (ring.radius + ring.half_width + ball_radius)
        leaving = outward and distance > ring.radius  # it does not come back
        if in_band(distance, larger if leaving else larger + speed * clear, ring):
            may_turn = ring.spin != 0.0 if steered is None else steered[k] != 0 or abs(ring.spin) * horizon > _LONGEST_TURN
            clear = _clear_of_ring(unchecked(Ball, (p, v, larger)), speed, ring, layers[k], clear, may_turn)
            if clear == 0.0:
                return 0.0
    return clear


def _clear_of_ring(
    ball: Ball,
    speed: float,
    ring: Ring,
    alive: Sequence[int],
    horizon: float,
    steered: bool,  # noqa: FBT001
) -> float:
    """`clear_time` for one ring within reach; speed: of the ball."""
    turning = max(abs(ring.spin), speed / (ring.radius + ring.half_width)) if steered else 0.0
    for stretch in band_stretches(ball, ring, horizon):
        if stretch is not None:
            if steered:
                clear = _clear_of_sectors(ball, ring, alive, stretch, turning)
            else:
                clear = _time_to_touch(ball, ring, alive, stretch)
            if clear < stretch.stop:
                return clear
    return horizon


def _time_to_touch(ball: Ball, ring: Ring, alive: Sequence[int], stretch: Stretch) -> float:
    """Seconds from now until a ball touches a ring that keeps its spin, on a stretch of its flight; if never, to its end."""
    start, clear = stretch.start, stretch.stop
    entry, now = ball.moved(start), ring.turned(start)
    theta = entry.theta()
    slot = nearest_slot(now, theta)
    angle = now.angle(slot)
    if alive[slot] != 0 and is_over(now, theta, angle):
        return start
    reach, offset = angular_reach(entry, now, clear - start), signed_difference(theta, angle)
    for side in (-1, 1):
        end = gap_end(now, alive, slot, offset, side, 0, reach)
        if end is not None:
            if start == 0.0 and gap_of_end(entry, now, end) <= 0.0:
                return 0.0
            time = time_to_end(entry, now, end, clear - start)
            if time is not None and start + time < clear:
                clear = start + time
    return clear


def _clear_of_sectors(ball: Ball, ring: Ring, alive: Sequence[int], stretch: Stretch, turning: float) -> float:
    """Seconds from now for which a ball stays clear of the sectors beside it, on a stretch of its flight in the band.

    turning: rad/s at most. Seen from the centre, at distance d, the ball itself covers asin(r / d) to each side, which is
    at most x + (pi / 2 - 1) x^3 for x = r / d, and its centre moves by L / d^2 rad/s, L = p x v. On one stretch d is
    least at one of its ends and greatest at the other: the centre moves by at least |L| / greatest^2 and at most
    |L| / least^2, always in the direction of L's sign. On that side the distance to a sector's end shrinks at most at `turning`
    plus the larger rate; on the other side, which the ball leaves, at most at `turning` minus the smaller rate.
    """
    p, v, ball_radius = ball
    start, stop = stretch.start, stretch.stop
    entry = ball.moved(start)
    one, other = length(entry.position), length(p + v * stop)
    nearest, farthest = min(one, other), max(one, other)
    if nearest <= ball_radius:
        return start
    x = ball_radius / nearest
    covered = x + (math.pi / 2.0 - 1.0) * x * x * x + turning * start + ANGLE_SLACK
    momentum = cross(p, v)
    theta = entry.theta()
    slot = nearest_slot(ring, theta)
    offset = signed_difference(theta, ring.angle(slot))
    clear = stop
    for side in (-1, 1):
        ahead = side * momentum
        closing = turning + (ahead / (nearest * nearest) if ahead > 0.0 else ahead / (farthest * farthest))
        end = gap_end(ring, alive, slot, offset, side, 0, covered + max(closing, 0.0) * (clear - start))
        if end is not None:
            apart = end.away - covered
            if apart <= 0.0:
                return start
            if apart < closing * (clear - start):
                clear = start + apart / closing
    return clear
