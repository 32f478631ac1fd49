"""The engine's own functions under the source's names and with the slides' parameters, to be compared with a student's."""

from collections.abc import Sequence

import physics
from game.student.slides import SlideFunctions
from physics import Ring

_HALF_ANGLE = 0.5
"""Radians. The outcome of the broad phase does not ask for it."""


class EngineFunctions(SlideFunctions):
    """The functions of `physics` that move the game's balls. They assert normalised angles, so angles are normalised first."""

    def normalize_angle(self, angle: float) -> float:
        """`physics.normalize_angle`."""
        return physics.normalize_angle(angle)

    def add_angles(self, a: float, b: float) -> float:
        """`physics.add_angles`."""
        return physics.add_angles(physics.normalize_angle(a), physics.normalize_angle(b))

    def subtract_angles(self, a: float, b: float) -> float:
        """`physics.subtract_angles`."""
        return physics.subtract_angles(physics.normalize_angle(a), physics.normalize_angle(b))

    def to_polar(self, p: complex) -> tuple[float, float]:
        """`physics.to_polar`."""
        return physics.to_polar(p)

    def to_cartesian(self, radius: float, angle: float) -> complex:
        """`physics.to_cartesian`."""
        return physics.to_cartesian(radius, angle)

    def min_difference(self, a: float, b: float) -> float:
        """`physics.min_difference`."""
        return physics.min_difference(physics.normalize_angle(a), physics.normalize_angle(b))

    def on_left(self, a: float, b: float) -> bool:
        """`physics.on_left`."""
        return physics.on_left(physics.normalize_angle(a), physics.normalize_angle(b))

    def closest_point_on_line(self, a: complex, b: complex, p: complex) -> complex:
        """`physics.closest_point_on_line`."""
        return physics.closest_point_on_line(a, b, p)

    def broad_phase_outcome(self, p: complex, r: float, r_g: float, r_p: float, w_p: float, r_b: float, w_b: float) -> str:
        """`physics.broad_phase_outcome`."""
        paddles, bricks = Ring(r_p, w_p, _HALF_ANGLE, 1), Ring(r_b, w_b, _HALF_ANGLE, 1)
        outcome = physics.broad_phase_outcome(p, r, r_g, paddles, [bricks])
        return outcome.value.removeprefix("broad phase with ")

    def broad_phase(
        self, p: complex, r: float, theta: float, w_p: float, phi_p: float, positions: Sequence[tuple[float, float]]
    ) -> complex | None:
        """`physics.broad_phase`."""
        return physics.broad_phase(p, r, theta, positions, w_p, phi_p)

    def narrow_phase_case_1(self, p: complex, r_p: float) -> complex:
        """`physics.narrow_phase_case_1`."""
        return physics.narrow_phase_case_1(p, r_p)

    def narrow_phase_case_2(
        self, p: complex, r: float, theta: float, r_p: float, theta_p: float, w_p: float, phi_p: float
    ) -> complex | None:
        """`physics.narrow_phase_case_2`."""
        return physics.narrow_phase_case_2(p, r, theta, r_p, theta_p, w_p, phi_p)

    def collision_response(self, v: complex, n: complex, v_p: complex, mu_p: float, v_0: float) -> complex:
        """`physics.collision_response`."""
        return physics.collision_response(v, n, v_p, mu_p, v_0)
