"""What replacing an arc by N chords costs: every bound of the harness, derived."""

import cmath
import math

ANGLE_NOISE = 2.0**-47
"""Radians, or a fraction of a radius: 7.1e-15. The rounding between two honest computations of one place on a ring.

An angle in [4, 8) is rounded by at most 2^-51. The game rounds five times on the way to the angle of a sector's end (slot times
pitch, plus phase, the phase's grid, the turning, the half angle) and once more, by at most 2e-15, in its own sine and cosine;
pymunk's side rounds three times and uses the C library's, good to 2^-53. Eight times 2^-51 and 2e-15 and the rounding of both
coordinates on both sides, 4 times 2^-53, make 6.0e-15.
"""

TOUCH = 1e-13
"""World units. The game's search for a turning end stops at a gap this small (its documented accuracy)."""

FEWEST = 3
"""Facets of an arc: an arc may be a whole circle, and two chords enclose nothing."""

MOST = 4096
"""Facets of an arc. A ring of 60 bricks then has half a million segments, about all a laptop holds in memory."""


def arc_points(radius: float, middle: float, half_angle: float, facets: int) -> list[tuple[float, float]]:
    """The ends of the chords of an arc, clockwise end first, all on the arc."""
    step = 2.0 * half_angle / facets
    points = [cmath.rect(radius, middle - half_angle + k * step) for k in range(facets)]
    points.append(cmath.rect(radius, middle + half_angle))
    if half_angle >= math.pi:
        points[-1] = points[0]
    return [(p.real, p.imag) for p in points]


def half_facet(half_angle: float, facets: int) -> float:
    """Half the angle one facet spans: how far a chord's normal turns away from the arc's, at its ends.

    The bound for a ball inside a concave arc: the nearest chord is the one across its bearing, and touches with its inside.
    """
    return half_angle / facets


def outer_facet_bound(outer: float, ball_radius: float, half_angle: float, facets: int) -> float:
    """The bound for a ball outside a convex arc, whose centre is at outer + ball_radius: a little less than half a facet.

    It touches the inside of a chord up to the bearing asin(R sin(d/2) / (R + r)) from the chord's middle, where the normals
    differ by as much; beyond, it touches the vertex, and the difference falls again.
    """
    half = min(half_facet(half_angle, facets), math.pi / 2.0)
    return math.asin(outer / (outer + ball_radius) * math.sin(half))


def sagitta(radius: float, half_angle: float, facets: int) -> float:
    """How far a chord's middle lies inside its arc: what separates the polygon from the circle at most."""
    return radius * (1.0 - math.cos(half_facet(half_angle, facets)))


def place_noise(outer: float) -> float:
    """World units: the rounding of one place on a ring."""
    return outer * ANGLE_NOISE


def normal_noise(outer: float, ball_radius: float) -> float:
    """Radians: the rounding of a normal, which is a difference of places divided by the ball's radius.

    Above 2 pi / 2^53 times the lever outer / ball_radius, and far below the 1e-9 that the harness promises.
    """
    return (outer + ball_radius) / ball_radius * ANGLE_NOISE


def contact_noise(outer: float) -> float:
    """World units: how far from exact touch a ball may be at the moment the game says it touches."""
    return place_noise(outer) + TOUCH
