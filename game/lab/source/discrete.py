"""The source's own loop, taken literally: the ball moves by a whole frame, then its overlap is tested once."""

from collections.abc import Sequence
from typing import NamedTuple

from game.lab.source import functions
from game.lab.source.response_steps import response_steps
from physics import Ring, in_band, length, min_difference, narrow_phase_case_1, to_polar
from physics.tolerances import STOPPED


class Flight(NamedTuple):
    """A ball between two frames.

    velocity: None once the response has divided 0 by 0.
    """

    position: complex
    velocity: complex | None


def frame(flight: Flight, ball_radius: float, rings: Sequence[Ring], dt: float, speed: float) -> Flight:
    """The ball one frame later. rings: as they stand at the end of the frame. dt: seconds. speed: the ball's fixed speed."""
    if flight.velocity is None:
        return flight
    p, v = flight.position + flight.velocity * dt, flight.velocity
    for ring in rings:
        n = normal_at(p, ball_radius, ring)
        if n is not None:
            steps = response_steps(v, n, ring.surface_velocity(p), ring.friction, speed)
            return Flight(p, reset(v, steps.before_reset, speed))
    return Flight(p, v)


def normal_at(p: complex, ball_radius: float, ring: Ring) -> complex | None:
    """The normal that the source finds for a ball at p: band, nearest sector, then case 1 or case 2; None without a contact."""
    if p == 0.0 or not in_band(p, ball_radius, ring):
        return None
    theta = to_polar(p)[1]
    angle = min([ring.angle(slot) for slot in range(ring.count)], key=lambda middle: min_difference(theta, middle))
    if min_difference(theta, angle) <= ring.half_angle:
        return narrow_phase_case_1(p, ring.radius)
    end = angle + functions.end_sign(theta, angle, ring.half_angle) * ring.half_angle
    return functions.end_normal(p, ball_radius, *functions.end_points(ring.radius, ring.half_width, end))


def reset(v: complex, before_reset: complex, speed: float) -> complex | None:
    """v := v_0 v_res / |v_res|, the source's last equation; v itself where there was no bounce.

    None for 0 / 0, also where v_res is 0 but for rounding.
    """
    if before_reset == v:
        return v
    size = length(before_reset)
    return None if size <= STOPPED * speed else before_reset * (speed / size)
