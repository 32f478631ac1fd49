"""A student's file with one mistake in it, the sign of the normal of a face: a figure shows what the lab makes of it."""


def narrow_phase_case_1(p: complex, r_p: float) -> complex:
    """The normal of a face."""
    return p / abs(p) if abs(p) < r_p else -p / abs(p)
