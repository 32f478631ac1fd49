"""Which obstacle can the ball touch at all? (the source: "Broad phase")."""

import math
from collections.abc import Sequence
from enum import Enum

from physics.narrow_phase import narrow_phase_case_1, narrow_phase_case_2
from physics.polar import min_difference, signed_difference
from physics.shapes import Ring
from physics.vectors import length


class Outcome(Enum):
    """What the ball's distance from the centre says (the source's first page)."""

    GAME_OVER = "game over"
    PADDLES = "broad phase with paddles"
    BRICKS = "broad phase with bricks"
    NO_COLLISION = "no collision"


def broad_phase_outcome(p: complex, ball_radius: float, ground_radius: float, paddles: Ring, bricks: Ring) -> Outcome:
    """The first of the source's four outcomes that holds, in the source's order."""
    if has_left(p, ball_radius, ground_radius):
        return Outcome.GAME_OVER
    if in_band(p, ball_radius, paddles):
        return Outcome.PADDLES
    if in_band(p, ball_radius, bricks):
        return Outcome.BRICKS
    return Outcome.NO_COLLISION


def has_left(p: complex, ball_radius: float, ground_radius: float) -> bool:
    """Whether the whole ball is outside the ground: |p| - r > r_g."""
    return length(p) - ball_radius > ground_radius


def in_band(p: complex, ball_radius: float, ring: Ring) -> bool:
    """Whether the ball reaches into a ring's band: |p| + r >= r_p - w_p and |p| - r <= r_p + w_p."""
    distance = length(p)
    return distance + ball_radius >= ring.inner_radius and distance - ball_radius <= ring.outer_radius


def broad_phase(
    p: complex,
    ball_radius: float,
    theta: float,
    positions: Sequence[tuple[float, float]],
    half_width: float,
    half_angle: float,
) -> complex | None:
    """Normal of the sector nearest in angle, by the source's search over a list.

    p, theta: the ball's centre and its angle. positions: (radius, angle) of each sector's middle, at least one.
    Of equally near sectors the first is taken. Returns what the narrow phase of that sector returns.

    >>> broad_phase(9.5 + 0j, 0.25, 0.0, [(10.0, 3.0), (10.0, 0.1)], 0.3, 0.2)
    (-1-0j)
    """
    radius, angle = positions[0]
    for other_radius, other_angle in positions[1:]:
        if min_difference(theta, other_angle) < min_difference(theta, angle):
            radius, angle = other_radius, other_angle
    if min_difference(theta, angle) <= half_angle:
        return narrow_phase_case_1(p, radius)
    return narrow_phase_case_2(p, ball_radius, theta, radius, angle, half_width, half_angle)


def nearest_slot(ring: Ring, angle: float) -> int:
    """The slot whose middle is nearest to an angle: the source's search as arithmetic, at one price for any count."""
    pitch = math.tau / ring.count
    return round(signed_difference(angle, ring.phase) / pitch) % ring.count
