"""The source's own loop, taken literally: the ball moves by a whole frame, then its overlap is tested once."""

from collections.abc import Sequence
from typing import NamedTuple

from game.lab.source import literal
from physics import Ring, in_band, length, min_difference, narrow_phase_case_1, to_polar
from physics.tolerances import STOPPED


class Flight(NamedTuple):
    """A ball between two frames."""

    position: complex
    velocity: complex | None  # None once the response has answered 0 / 0


def frame(flight: Flight, ball_radius: float, rings: Sequence[Ring], dt: float, speed: float) -> Flight:
    """The ball one frame later. rings: as they stand at the end of the frame."""
    if flight.velocity is None:
        return flight
    p, v = flight.position + flight.velocity * dt, flight.velocity
    for ring in rings:
        n = normal_at(p, ball_radius, ring)
        if n is not None:
            return Flight(p, reset(v, literal.bounced(v, n, ring.surface_velocity(p), ring.friction), speed))
    return Flight(p, v)


def normal_at(p: complex, ball_radius: float, ring: Ring) -> complex | None:
    """The source's three pages in a row: the band, the nearest sector, case 1 or case 2."""
    if p == 0.0 or not in_band(p, ball_radius, ring):
        return None
    theta = to_polar(p)[1]
    angle = min([ring.angle(slot) for slot in range(ring.count)], key=lambda middle: min_difference(theta, middle))
    if min_difference(theta, angle) <= ring.half_angle:
        return narrow_phase_case_1(p, ring.radius)
    end = angle + literal.end_sign(theta, angle, ring.half_angle) * ring.half_angle
    return literal.end_normal(p, ball_radius, *literal.end_points(ring.radius, ring.half_width, end))


def reset(v: complex, result: complex, speed: float) -> complex | None:
    """v := v_0 v_res / |v_res|; v itself where nothing happened; None for 0 / 0, also where v_res is 0 but for rounding."""
    if result == v:
        return v
    size = length(result)
    return None if size <= STOPPED * speed else result * (speed / size)
