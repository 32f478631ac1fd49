"""A student's file that is right: the slides' pseudocode in Python, nothing else."""

import math

TAU = 2.0 * math.pi


def normalize_angle(angle):
    return angle % TAU


def add_angles(a, b):
    return normalize_angle(a + b)


def subtract_angles(a, b):
    return normalize_angle(a - b)


def min_difference(a, b):
    d = subtract_angles(a, b)
    return min(d, TAU - d)


def on_left(a, b):
    return 0.0 < subtract_angles(a, b) < math.pi


def to_polar(p):
    return abs(p), normalize_angle(math.atan2(p.imag, p.real))


def to_cartesian(radius, angle):
    return complex(radius * math.cos(angle), radius * math.sin(angle))


def dot(a, b):
    return a.real * b.real + a.imag * b.imag


def closest_point_on_line(a, b, p):
    ab = b - a
    return a + ab * (dot(p - a, ab) / dot(ab, ab))


def broad_phase_outcome(p, r, r_g, r_p, w_p, r_b, w_b):
    if abs(p) - r > r_g:
        return "game over"
    if abs(p) + r >= r_p - w_p and abs(p) - r <= r_p + w_p:
        return "paddles"
    if abs(p) + r >= r_b - w_b and abs(p) - r <= r_b + w_b:
        return "bricks"
    return "no collision"


def broad_phase(p, r, theta, positions, w_p, phi_p):
    r_p, theta_p = min(positions, key=lambda position: min_difference(theta, position[1]))
    if min_difference(theta, theta_p) <= phi_p:
        return narrow_phase_case_1(p, r_p)
    return narrow_phase_case_2(p, r, theta, r_p, theta_p, w_p, phi_p)


def narrow_phase_case_1(p, r_p):
    n = p / abs(p)
    return -n if abs(p) < r_p else n


def narrow_phase_case_2(p, r, theta, r_p, theta_p, w_p, phi_p):
    sign = 1 if on_left(theta, theta_p + phi_p) else -1
    a = to_cartesian(r_p - w_p, theta_p + sign * phi_p)
    b = to_cartesian(r_p + w_p, theta_p + sign * phi_p)
    q = closest_point_on_line(a, b, p)
    return (p - q) / abs(p - q) if 0 < abs(p - q) < r else None


def collision_response(v, n, v_p, mu_p, v_0):
    dv = v - v_p
    if dot(dv, n) >= 0:
        return v
    dv_n = dot(dv, n) * n
    dv_t = dv - dv_n
    change_n = -2 * dv_n
    change_t = 0
    if abs(dv_t) > 0:
        change_t = -mu_p * min(abs(dv_n), abs(dv_t)) * dv_t / abs(dv_t)
    v_res = v + change_n + change_t
    return v_0 * v_res / abs(v_res)
