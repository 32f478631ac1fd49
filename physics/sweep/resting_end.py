"""When does a moving ball first touch an end at rest? In closed form.

An end with its two corners is a segment. The ball touches it where its centre enters the rectangle of all points within its
radius beside the segment, or the disc of that radius around a corner.
"""

import math

from physics.narrow_phase import end_normal, nearest_end
from physics.polar import to_cartesian
from physics.shapes import Ball, Ring
from physics.sweep.gap import End, angle_of_end
from physics.tolerances import TOUCH
from physics.vectors import cross, dot, length


def touch_of_resting_end(ball: Ball, ring: Ring, end: End, span: float) -> float | None:
    """Seconds until the first touch with an end at rest, within `span` seconds, or None.

    Of its line, a linear equation; of its corners, a quadratic each.
    """
    p, v, ball_radius = ball
    angle = angle_of_end(ring, end)
    near = nearest_end(p, angle, ring.radius, ring.angle(end.slot), ring.half_width, ring.half_angle)
    distance = length(p - near.q)
    if dot(end_normal(p, near, distance), v) >= 0.0:
        return None  # the distance to a convex set, seen from a straight path, grows for good once it grows
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    if distance - ball_radius <= TOUCH * (outer + ball_radius):
        return 0.0
    along = to_cartesian(1.0, angle)
    height, climb = cross(along, p), cross(along, v)
    if height < 0.0:
        height, climb = -height, -climb
    first = math.inf
    if climb < 0.0 and height >= ball_radius:
        time = (height - ball_radius) / -climb
        if inner <= dot(along, p + v * time) <= outer:
            first = time
    first = min(first, _time_to_point(p - along * inner, v, ball_radius), _time_to_point(p - along * outer, v, ball_radius))
    return first if first <= span else None


def _time_to_point(p: complex, v: complex, ball_radius: float) -> float:
    """When a ball, its centre at p from a point, first touches that point; infinite if it never does."""
    distance = length(p)
    outward, aside = dot(p, v), cross(p, v)
    root = dot(v, v) * ball_radius * ball_radius - aside * aside
    if outward >= 0.0 or root <= 0.0:
        return math.inf
    return max((distance - ball_radius) * (distance + ball_radius), 0.0) / (math.sqrt(root) - outward)
