"""Case 2 of the source in pieces, for scenes that draw them: which end, its corners A and B, and its normal."""

from physics import length, to_cartesian
from physics.source_mode import slides_closest_point_on_line, slides_on_left


def end_sign(theta: float, angle: float, half_angle: float) -> int:
    """Which end the source looks at: 1 for the counter-clockwise end if on_left(θ, θ_p + φ_p), else -1."""
    return 1 if slides_on_left(theta, angle + half_angle) else -1


def end_points(radius: float, half_width: float, end: float) -> tuple[complex, complex]:
    """A and B, the inner and the outer corner of the end at the angle `end`."""
    return to_cartesian(radius - half_width, end), to_cartesian(radius + half_width, end)


def end_normal(p: complex, ball_radius: float, a: complex, b: complex) -> complex | None:
    """(p - q) / |p - q| where |p - q| is in (0, r), else None; q is the foot on the endless line AB."""
    q = slides_closest_point_on_line(a, b, p)
    distance = 0.0 if q is None else length(p - q)
    return (p - q) / distance if q is not None and 0.0 < distance < ball_radius else None
