"""What replacing an arc by N chords costs: how far normals and positions may then differ, derived."""

import cmath
import math

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
