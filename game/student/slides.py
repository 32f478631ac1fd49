"""The source's functions, line by line from its slides, over floats or over numbers of any precision.

They share no code with `physics`. What the slides leave open is filled in as plainly as possible. Each decision is a
method of its own, so that `beyond` and the catalogue of mistakes can replace just that one.
"""

import math
from collections.abc import Sequence
from typing import Any

Scalar = Any
"""A float, or a number of a multiprecision library."""
Plane = Any
"""A complex number of the same kind: x + iy."""


class SlideFunctions:
    """The source's functions under its names; a division by zero raises ZeroDivisionError.

    Attributes:
        library: sin, cos, atan2, sqrt and pi.
        point: makes a point of its coordinates x and y.
        tau: a full turn, 2 pi.
    """

    def __init__(self, library: Any = math, point: Any = complex) -> None:
        self.maths = library
        self.point = point
        self.tau = 2 * library.pi

    def normalize_angle(self, angle: Scalar) -> Scalar:
        """The angle between 0 and 2 pi (slide 11)."""
        return angle % self.tau

    def add_angles(self, a: Scalar, b: Scalar) -> Scalar:
        """Their sum, normalised (slide 11)."""
        return self.normalize_angle(a + b)

    def subtract_angles(self, a: Scalar, b: Scalar) -> Scalar:
        """Their difference, normalised (slide 11)."""
        return self.normalize_angle(a - b)

    def to_polar(self, p: Plane) -> tuple[Scalar, Scalar]:
        """(radius, angle) of a point (slide 11)."""
        return abs(p), self.normalize_angle(self.maths.atan2(p.imag, p.real))

    def to_cartesian(self, radius: Scalar, angle: Scalar) -> Plane:
        """The point at a radius and an angle (slide 5)."""
        return self.point(radius * self.maths.cos(angle), radius * self.maths.sin(angle))

    def min_difference(self, a: Scalar, b: Scalar) -> Scalar:
        """The angle between two directions, the shorter way round (slide 3)."""
        difference = self.normalize_angle(a - b)
        return min(difference, self.tau - difference)

    def on_left(self, a: Scalar, b: Scalar) -> bool:
        """Whether a is reached from b by turning counter-clockwise less than half a turn (slide 5)."""
        return bool(0 < self.normalize_angle(a - b) < self.tau / 2)

    def closest_point_on_line(self, a: Plane, b: Plane, p: Plane) -> Plane:
        """The foot of the perpendicular from p to the line AB (slide 5)."""
        return a + (b - a) * self.share_of_line(_dot(p - a, b - a) / _dot(b - a, b - a))

    def share_of_line(self, share: Scalar) -> Scalar:
        """How far from A (0) to B (1) the closest point may lie: on a line, anywhere."""
        return share

    def broad_phase_outcome(self, p: Plane, r: Scalar, r_g: Scalar, r_p: Scalar, w_p: Scalar, r_b: Scalar, w_b: Scalar) -> str:
        """What the ball's distance from the centre says (slide 2)."""
        if abs(p) - r > r_g:
            return "game over"
        if abs(p) + r >= r_p - w_p and abs(p) - r <= r_p + w_p:
            return "paddles"
        if abs(p) + r >= r_b - w_b and abs(p) - r <= r_b + w_b:
            return "bricks"
        return "no collision"

    def broad_phase(
        self, p: Plane, r: Scalar, theta: Scalar, w_p: Scalar, phi_p: Scalar, positions: Sequence[tuple[Scalar, Scalar]]
    ) -> Plane | None:
        """The normal of the paddle nearest in angle, or None (slide 3)."""
        r_p, theta_p = self.nearest(theta, positions)
        if self.min_difference(theta, theta_p) <= phi_p:
            return self.narrow_phase_case_1(p, r_p)
        return self.narrow_phase_case_2(p, r, theta, r_p, theta_p, w_p, phi_p)

    def nearest(self, theta: Scalar, positions: Sequence[tuple[Scalar, Scalar]]) -> tuple[Scalar, Scalar]:
        """The paddle nearest in angle, the first of equals (slide 3)."""
        r_p, theta_p = positions[0]
        for other_r, other_theta in positions[1:]:
            if self.min_difference(theta, other_theta) < self.min_difference(theta, theta_p):
                r_p, theta_p = other_r, other_theta
        return r_p, theta_p

    def narrow_phase_case_1(self, p: Plane, r_p: Scalar) -> Plane:
        """The normal of a face (slide 4)."""
        n = p / abs(p)
        return -n if abs(p) < r_p else n

    def narrow_phase_case_2(
        self, p: Plane, r: Scalar, theta: Scalar, r_p: Scalar, theta_p: Scalar, w_p: Scalar, phi_p: Scalar
    ) -> Plane | None:
        """The normal of an end, or None (slide 5)."""
        end = theta_p + self.end_sign(theta, theta_p, phi_p) * phi_p
        a, b = self.to_cartesian(r_p - w_p, end), self.to_cartesian(r_p + w_p, end)
        q = self.closest_point_on_line(a, b, p)
        return self.end_normal(p, q, r)

    def end_sign(self, theta: Scalar, theta_p: Scalar, phi_p: Scalar) -> int:
        """1 for the counter-clockwise end, -1 for the clockwise one (slide 5)."""
        return 1 if self.on_left(theta, theta_p + phi_p) else -1

    def end_normal(self, p: Plane, q: Plane, r: Scalar) -> Plane | None:
        """(p - q) / |p - q| if |p - q| is in (0, r) (slide 5)."""
        return (p - q) / abs(p - q) if 0 < abs(p - q) < r else None

    def collision_response(self, v: Plane, n: Plane, v_p: Plane, mu_p: Scalar, v_0: Scalar) -> Plane:
        """The final velocity (slides 6 to 10)."""
        relative = self.relative_velocity(v, v_p)
        approach = _dot(relative, n)
        if self.separates(approach):
            return v
        relative_n = approach * n
        relative_t = relative - relative_n
        v_res = v + self.normal_change(relative_n) + self.tangential_change(relative_n, relative_t, mu_p)
        return self.final_velocity(v_res, v_0, n, v_p)

    def relative_velocity(self, v: Plane, v_p: Plane) -> Plane:
        """dv = v - v_p (slide 8)."""
        return v - v_p

    def separates(self, approach: Scalar) -> bool:
        """Whether dv . n is not below 0 (slide 9)."""
        return bool(approach >= 0)

    def normal_change(self, relative_n: Plane) -> Plane:
        """The bounce of the paddle, dv_n' = -2 dv_n (slide 10)."""
        return -2 * relative_n

    def tangential_change(self, relative_n: Plane, relative_t: Plane, mu_p: Scalar) -> Plane:
        """Match the paddle's velocity: dv_t' = -mu min(|dv_n|, |dv_t|) dv_t / |dv_t| (slide 10)."""
        if abs(relative_t) == 0:
            return 0
        return -mu_p * min(abs(relative_n), abs(relative_t)) * relative_t / abs(relative_t)

    def final_velocity(self, v_res: Plane, v_0: Scalar, n: Plane, v_p: Plane) -> Plane:  # noqa: ARG002  # `beyond` needs them
        """v_0 v_res / |v_res| (slide 10)."""
        return v_0 * v_res / abs(v_res)


def _dot(a: Plane, b: Plane) -> Scalar:
    """The scalar product of two vectors."""
    return a.real * b.real + a.imag * b.imag
