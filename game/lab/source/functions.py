"""The source's functions as its pages have them, where the physics goes beyond them."""

import math

from physics import dot, length, to_cartesian


def normalize_angle(angle: float) -> float:
    """The angle by a plain remainder, radians. For -1e-17 it is 2π itself, which is outside of [0, 2π)."""
    return angle % math.tau


def foot_on_line(a: complex, b: complex, p: complex) -> complex | None:
    """The foot of the perpendicular from p to the endless line through A and B; None where A = B leaves no line."""
    square = dot(b - a, b - a)
    return None if square == 0.0 else a + (b - a) * (dot(p - a, b - a) / square)


def on_left(a: float, b: float) -> bool:
    """Whether a is reached from b by turning counter-clockwise by less than half a turn."""
    return 0.0 < (a - b) % math.tau < math.pi


def end_sign(theta: float, angle: float, half_angle: float) -> int:
    """Which end the source looks at: 1 for the counter-clockwise end if on_left(θ, θ_p + φ_p), else -1."""
    return 1 if on_left(theta, angle + half_angle) else -1


def end_points(radius: float, half_width: float, end: float) -> tuple[complex, complex]:
    """A and B, the inner and the outer corner of the end at the angle `end`."""
    return to_cartesian(radius - half_width, end), to_cartesian(radius + half_width, end)


def end_normal(p: complex, ball_radius: float, a: complex, b: complex) -> complex | None:
    """(p - q) / |p - q| where |p - q| is in (0, r), else None; q is the foot on the endless line AB."""
    q = foot_on_line(a, b, p)
    distance = 0.0 if q is None else length(p - q)
    return (p - q) / distance if q is not None and 0.0 < distance < ball_radius else None
