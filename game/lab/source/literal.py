"""The source taken literally where that gives another answer than ours: the subject of scenes, used for nothing else."""

import math

from physics import dot, length, to_cartesian


def normalize_angle(angle: float) -> float:
    """The angle folded by a plain remainder: 2 pi itself for -1e-17."""
    return angle % math.tau


def foot_on_line(a: complex, b: complex, p: complex) -> complex | None:
    """The foot of the perpendicular from p to the line AB, endless on both sides; None where A = B leaves no line."""
    square = dot(b - a, b - a)
    return None if square == 0.0 else a + (b - a) * (dot(p - a, b - a) / square)


def on_left(a: float, b: float) -> bool:
    """Whether a is reached from b by turning counter-clockwise less than half a turn."""
    return 0.0 < (a - b) % math.tau < math.pi


def end_sign(theta: float, angle: float, half_angle: float) -> int:
    """Which end the source looks at: sign = 1 if on_left(theta, theta_p + phi_p) else -1."""
    return 1 if on_left(theta, angle + half_angle) else -1


def end_points(radius: float, half_width: float, end: float) -> tuple[complex, complex]:
    """A and B, the corners of the end at an angle."""
    return to_cartesian(radius - half_width, end), to_cartesian(radius + half_width, end)


def end_normal(p: complex, ball_radius: float, a: complex, b: complex) -> complex | None:
    """(p - q) / |p - q| if |p - q| is in (0, r), else None, with q on the line AB."""
    q = foot_on_line(a, b, p)
    distance = 0.0 if q is None else length(p - q)
    return (p - q) / distance if q is not None and 0.0 < distance < ball_radius else None


def bounced(v: complex, normal: complex, surface_velocity: complex, friction: float) -> complex:
    """v_res, the velocity before it is brought to the ball's speed; v itself for a pair that separates."""
    relative = v - surface_velocity
    approach = dot(relative, normal)
    if approach >= 0.0:
        return v
    across = relative - normal * approach
    slip = length(across)
    grip = friction * min(-approach, slip) / slip if slip > 0.0 else 0.0
    return v - normal * (2.0 * approach) - across * grip
