"""The template for students: every function of the source with its slide and arguments, still to be written."""

_TEXT = '''"""The functions of the lecture "Collision detection and response", to be written.

COMMANDS
A function that still raises NotImplementedError counts as not written: ours answers in its place. Write them in any order, in
any number. Points and vectors are complex numbers x + iy; if you prefer your own, define make_point(x, y) in this file.
Angles are radians, counter-clockwise. abs(p) is |p|. A normal is a unit vector from the obstacle to the ball.
"""

import math


def dot(a, b):
    """The scalar product of two vectors: a help, not graded."""
    return a.real * b.real + a.imag * b.imag


# Slide 11: implementation notes. Every other page needs these.


def normalize_angle(angle):
    """The same angle in the range from 0 to 2 pi; any angle, also many turns or below 0."""
    raise NotImplementedError


def add_angles(a, b):
    """a + b, normalised."""
    raise NotImplementedError


def subtract_angles(a, b):
    """a - b, normalised."""
    raise NotImplementedError


def to_polar(p):
    """The radius and the normalised angle of a point: two numbers."""
    raise NotImplementedError


# Slide 5: what case 2 needs.


def to_cartesian(radius, angle):
    """The point at a radius and an angle."""
    raise NotImplementedError


def on_left(a, b):
    """Whether the angle a is reached from b counter-clockwise by less than half a turn, also across the polar axis."""
    raise NotImplementedError


def closest_point_on_line(a, b, p):
    """The point of the line AB nearest to p: the foot of the perpendicular from p.

    Going further: nearest on the segment AB, so that an end has corners. Both are right.
    """
    raise NotImplementedError


# Slide 2: broad phase.


def broad_phase_outcome(p, r, r_g, r_p, w_p, r_b, w_b):
    """What the ball, centre p and radius r, can touch. The first that holds of:

    |p| - r > r_g                                        "game over"
    |p| + r >= r_p - w_p  and  |p| - r <= r_p + w_p      "paddles"
    |p| + r >= r_b - w_b  and  |p| - r <= r_b + w_b      "bricks"
    otherwise                                            "no collision"
    """
    raise NotImplementedError


# Slide 3: broad phase with the paddles. Bricks are alike.


def min_difference(a, b):
    """The angle between two directions, the shorter way round, from 0 to pi."""
    raise NotImplementedError


def broad_phase(p, r, theta, positions, w_p, phi_p):
    """The normal of the paddle nearest in angle, by case 1 or case 2, or None.

    theta: the ball's angle. positions: a list of pairs (r_p, theta_p), at least one.
    Case 1 where min_difference(theta, theta_p) <= phi_p for the nearest of them, else case 2.
    """
    raise NotImplementedError


# Slide 4: narrow phase, case 1: the ball is over the paddle's face.


def narrow_phase_case_1(p, r_p):
    """The normal n = p / |p|, or -n where |p| < r_p."""
    raise NotImplementedError


# Slide 5: narrow phase, case 2: the ball is beside the paddle, at one of its ends.


def narrow_phase_case_2(p, r, theta, r_p, theta_p, w_p, phi_p):
    """The normal (p - q) / |p - q| where |p - q| lies in (0, r), else None.

    sign = 1 if on_left(theta, theta_p + phi_p) else -1. The end's corners: A at the radius r_p - w_p, B at r_p + w_p,
    both at the angle theta_p + sign * phi_p. q is the closest point on the line AB.
    """
    raise NotImplementedError


# Slides 6 to 10: collision response.


def collision_response(v, n, v_p, mu_p, v_0):
    """The ball's velocity after the bounce; v itself where the two do not approach.

    Relative velocity dv = v - v_p, split into dv_n = (dv . n) n and dv_t = dv - dv_n. Only if dv . n < 0:
    dv_n' = -2 dv_n,  dv_t' = -mu_p min(|dv_n|, |dv_t|) dv_t / |dv_t| if |dv_t| > 0,
    v_res = v + dv_n' + dv_t',  v := v_0 v_res / |v_res|.
    """
    raise NotImplementedError


# Beyond the slides, not graded: a whole tick of your own (docs/student.md). Uncomment it, and the game asks nothing else.
#
# def advance(balls, rings, layers, dt, v_0):
#     """dt seconds later: the list of (p, v) of every ball, and the list of hits (ball, ring, slot, n).
#
#     balls: (p, v, r) each. rings: radius, half_width, half_angle, sectors, phase, spin, friction.
#     layers[ring][slot]: the bricks stacked there, 0 is empty.
#     """
#     return [(p + v * dt, v) for p, v, r in balls], []
'''
_COMMANDS = """    python -m tools.grade mine.py                 are they right? (docs/grading.md)
    python -m game lab case-1 --with mine.py      see one: your answer beside ours, red where it differs
    python -m game --with mine.py                 fly on them; whenever you save this file it is read again
    python -m tools.crosscheck --with mine.py     compare them with pymunk (docs/student.md)

"""
TEMPLATE = _TEXT.replace("COMMANDS\n", _COMMANDS)
"""As a file, with the commands that take it."""
PAGE_TEMPLATE = _TEXT.replace("COMMANDS\n", "")
"""In the browser's editor."""
