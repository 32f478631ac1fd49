"""The source's pseudocode, transcribed line by line, faults included; it shares no code with `physics`.

Only what the pseudocode leaves open is filled in, as plainly as possible: the library's own sine, cosine and arc tangent,
and angles normalised "always before comparison".
"""

import math

TAU = 2.0 * math.pi


def normalize_angle(angle):
    """The angle between 0 and 2 pi."""
    return angle % TAU


def min_difference(a, b):
    """The angle between two directions."""
    difference = normalize_angle(a - b)
    return min(difference, TAU - difference)


def on_left(a, b):
    """Whether a is reached from b by turning counter-clockwise less than half a turn."""
    return 0.0 < normalize_angle(a - b) < math.pi


def to_polar(p):
    """(radius, angle) of a point."""
    return abs(p), normalize_angle(math.atan2(p.imag, p.real))


def to_cartesian(radius, angle):
    """The point at a radius and an angle."""
    return complex(radius * math.cos(angle), radius * math.sin(angle))


def closest_point_on_line(a, b, p):
    """The foot of the perpendicular from p to the line AB, endless on both sides."""
    direction = (b - a) / abs(b - a)
    return a + direction * ((p - a) * direction.conjugate()).real


def outcome(p, r, r_g, r_p, w_p, r_b, w_b):
    """The first page: what the ball's distance from the centre says."""
    if abs(p) - r > r_g:
        return "game over"
    if abs(p) + r >= r_p - w_p and abs(p) - r <= r_p + w_p:
        return "broad phase with paddles"
    if abs(p) + r >= r_b - w_b and abs(p) - r <= r_b + w_b:
        return "broad phase with bricks"
    return "no collision"


def broad_phase(p, r, theta, positions, w_p, phi_p):
    """The nearest paddle, by a search over the list."""
    r_p, theta_p = positions[0]
    for other_r, other_theta in positions[1:]:
        if min_difference(theta, other_theta) < min_difference(theta, theta_p):
            r_p, theta_p = other_r, other_theta
    if min_difference(theta, theta_p) <= phi_p:
        return narrow_phase_case_1(p, r_p)
    return narrow_phase_case_2(p, r, theta, r_p, theta_p, w_p, phi_p)


def narrow_phase_case_1(p, r_p):
    """The normal of a face."""
    n = p / abs(p)
    return -n if abs(p) < r_p else n


def narrow_phase_case_2(p, r, theta, r_p, theta_p, w_p, phi_p):
    """The normal of an end."""
    sign = 1 if on_left(theta, theta_p + phi_p) else -1
    a = to_cartesian(r_p - w_p, theta_p + sign * phi_p)
    b = to_cartesian(r_p + w_p, theta_p + sign * phi_p)
    q = closest_point_on_line(a, b, p)
    return (p - q) / abs(p - q) if 0 < abs(p - q) < r else None


def response_before_reset(v, n, v_p, mu_p):
    """v_res, the velocity before its length is set to v_0; v itself for a separating pair."""
    relative = v - v_p
    approach = (relative * n.conjugate()).real
    if approach >= 0:
        return v
    relative_n = approach * n
    relative_t = relative - relative_n
    change_n = -2 * relative_n
    change_t = 0
    if abs(relative_t) > 0:
        change_t = -mu_p * min(abs(relative_n), abs(relative_t)) * relative_t / abs(relative_t)
    return v + change_n + change_t


def collision_response(v, n, v_p, mu_p, v_0):
    """The final velocity."""
    v_res = response_before_reset(v, n, v_p, mu_p)
    return v_0 * v_res / abs(v_res)
