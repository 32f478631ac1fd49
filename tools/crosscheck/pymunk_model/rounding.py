"""By how much two correct computations of one contact may differ: rounding, and the game's documented accuracy."""

ANGLE_NOISE = 2.0**-47
"""Radians, or a fraction of a radius: 7.1e-15. The rounding between two correct computations of one position on a ring.

An angle in [4, 8) is rounded by at most 2^-51. The game rounds five times on the way to the angle of a sector's end (slot times
pitch, plus phase, the phase's grid, the turning, the half angle) and once more, by at most 2e-15, in its own sine and cosine;
pymunk's side rounds three times and uses the C library's, good to 2^-53. Eight times 2^-51 and 2e-15 and the rounding of both
coordinates on both sides, 4 times 2^-53, make 6.0e-15.
"""

TOUCH = 1e-14
"""Fraction of the ring's outer radius and the ball's together: the game's search stops at a gap this small, as it documents."""

PHASE_GRID = 2.0**-50
"""Radians. The game rounds a ring's turning in one tick to a grid with this spacing, so by at most half of it."""


def position_noise(outer: float) -> float:
    """World units: the rounding of one position on a ring with this outer radius."""
    return outer * ANGLE_NOISE


def normal_noise(outer: float, ball_radius: float) -> float:
    """Radians: the rounding of a normal, which is a difference of positions divided by the ball's radius.

    Above 2 pi / 2^53 times the lever outer / ball_radius, and far below the 1e-9 that the harness promises.
    """
    return (outer + ball_radius) / ball_radius * ANGLE_NOISE


def contact_noise(outer: float, ball_radius: float) -> float:
    """World units: how far from exact touch a ball may be at the moment the game says that it touches."""
    return position_noise(outer) + TOUCH * (outer + ball_radius)


def phase_noise(ticks: int, turned: float) -> float:
    """Radians: how far a ring's phase may drift in this many ticks, in which it turned by `turned` radians in all.

    Half a grid step a tick by the game's rounding; on the other side each product of spin and time is rounded by 2^-53 of
    itself, its sum by as much, and the folding to one turn by 2^-51.
    """
    return 0.5 * PHASE_GRID * ticks + 2.0**-51 * (1.0 + turned)
