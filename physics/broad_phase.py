"""Which obstacle can the ball touch at all? (the source: "Broad phase")."""

import math
from collections.abc import Callable, Sequence
from enum import Enum

from physics.narrow_phase import narrow_phase_case_1, narrow_phase_case_2
from physics.polar import min_difference, signed_difference
from physics.shapes import Ring
from physics.vectors import length


class Outcome(Enum):
    """What the ball's distance from the centre says (the source's first page).

    Attributes:
        GAME_OVER: the whole ball is outside the ground.
        PADDLES: it reaches into the paddles' band.
        BRICKS: it reaches into the band of a ring of bricks.
        NO_COLLISION: none of these.
    """

    GAME_OVER = "game over"
    PADDLES = "broad phase with paddles"
    BRICKS = "broad phase with bricks"
    NO_COLLISION = "no collision"


GAME_OVER, PADDLES, BRICKS, NO_COLLISION = Outcome
"""The members as module constants: Python 3.11 calls a function for every `Outcome.X`, which is 1 % of a headless game."""


def broad_phase_outcome(p: complex, ball_radius: float, ground_radius: float, paddles: Ring, bricks: Sequence[Ring]) -> Outcome:
    """The first of the source's four outcomes that holds, in the source's order.

    p: the ball's centre, world units. ball_radius, ground_radius (the source's r_g): world units. bricks: the rings of the
    wall, any number.
    The engine asks the same questions of every ring: a fast ball can meet paddles and bricks in one tick.
    """
    distance = length(p)
    if distance - ball_radius > ground_radius:  # `has_left`, with the distance that the bands need, too
        return GAME_OVER
    if in_band(distance, ball_radius, paddles):
        return PADDLES
    for ring in bricks:
        if in_band(distance, ball_radius, ring):
            return BRICKS
    return NO_COLLISION


def has_left(p: complex, ball_radius: float, ground_radius: float) -> bool:
    """Whether the whole ball is outside the ground: |p| - r > r_g. p: the ball's centre; all in world units."""
    return length(p) - ball_radius > ground_radius


def in_band(distance: float, ball_radius: float, ring: Ring) -> bool:
    """Whether the ball reaches into a ring's band: |p| + r >= r_p - w_p and |p| - r <= r_p + w_p.

    distance: |p|, of the ball's centre from the origin; ball_radius: both in world units. A ball that flies some distance d
    reaches no band that a ball at rest, larger by d, does not reach: so the sweep asks the same question.
    """
    return distance + ball_radius >= ring.radius - ring.half_width and distance - ball_radius <= ring.radius + ring.half_width


def broad_phase(
    p: complex,
    ball_radius: float,
    theta: float,
    positions: Sequence[tuple[float, float]],
    half_width: float,
    half_angle: float,
    case_2: Callable[[complex, float, float, float, float, float, float], complex | None] = narrow_phase_case_2,
) -> complex | None:
    """Normal of the sector nearest in angle, by the source's search over a list.

    p, theta: the ball's centre, world units, and its angle, radians, normalised. positions: (radius, angle) of each sector's
    middle, at least one, the angles normalised. ball_radius, half_width: world units. half_angle: radians, in (0, pi].
    case_2: what answers for an end; the source mode hands in the slides' own. Of equally near sectors the first is taken.
    Returns what its narrow phase returns: a unit vector from the obstacle to the ball, or None.

    The swept engine finds the same sector by arithmetic (`nearest_slot`), which costs the same for any number of sectors;
    this search is what that arithmetic is tested against, and what `python -m game --physics source` flies on.

    >>> broad_phase(9.5 + 0j, 0.25, 0.0, [(10.0, 3.0), (10.0, 0.1)], 0.3, 0.2)
    (-1-0j)
    """
    radius, angle = positions[0]
    for other_radius, other_angle in positions[1:]:
        if min_difference(theta, other_angle) < min_difference(theta, angle):
            radius, angle = other_radius, other_angle
    if min_difference(theta, angle) <= half_angle:
        return narrow_phase_case_1(p, radius)
    return case_2(p, ball_radius, theta, radius, angle, half_width, half_angle)


def nearest_slot(ring: Ring, theta: float) -> int:
    """The slot whose middle is nearest to an angle: the source's search as arithmetic, at one price for any count.

    theta: radians, normalised. The result is from 0 to count - 1; of two equally near slots either may be taken.
    """
    pitch = math.tau / ring.count
    return round(signed_difference(theta, ring.phase) / pitch) % ring.count
