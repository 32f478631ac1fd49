"""When does a moving ball reach into a ring's band? The broad phase's question, asked of a whole flight.

The ball flies straight, p + v t. It can touch a ring only while its distance from the centre lies between the inner radius
less its own and the outer radius plus its own (`physics.broad_phase.in_band`). The moments at which it enters and leaves are
roots of quadratics; on one stretch between them it flies inward, on another outward.

Each quadratic is v^2 t^2 + 2 (p . v) t + (p^2 - R^2). A quarter of its discriminant is (p . v)^2 - v^2 (p^2 - R^2), which
cancels where R is far smaller than p; it is the same as v^2 R^2 - (p x v)^2, which does not.
"""

import math
from typing import NamedTuple

from physics.shapes import Ball, Ring
from physics.vectors import cross, dot, length


class Stretch(NamedTuple):
    """A part of the flight on which the ball reaches into the band.

    Attributes:
        start: seconds from now.
        stop: seconds from now.
        heading: -1 where the ball flies inward, +1 outward, 0 where it rests.
    """

    start: float
    stop: float
    heading: int


def band_stretches(ball: Ball, ring: Ring, dt: float) -> tuple[Stretch | None, Stretch | None]:
    """The stretches of [0, dt] on which the ball reaches into the ring's band: the one inward, then the one outward.

    dt: seconds, >= 0. Each is None where there is none; a ball at rest in the band has one, with heading 0.
    """
    p, v, ball_radius = ball
    outer = ring.radius + ring.half_width + ball_radius
    inner = ring.radius - ring.half_width - ball_radius
    distance = length(p)
    square = dot(v, v)
    if square == 0.0:
        return (Stretch(0.0, dt, 0) if inner <= distance <= outer else None), None
    outward = dot(p, v)
    aside = cross(p, v)
    above = (distance - outer) * (distance + outer)
    root = square * outer * outer - aside * aside
    if root < 0.0 or (above > 0.0 and outward >= 0.0):
        return None, None
    begin = above / (math.sqrt(root) - outward) if above > 0.0 else 0.0
    if begin > dt:
        return None, None
    end = min(_later_root(square, outward, above, root), dt)
    turn_in = turn_out = -outward / square  # the ball is nearest to the centre; or it enters the hole and leaves it
    if inner > 0.0:
        above = (distance - inner) * (distance + inner)
        root = square * inner * inner - aside * aside
        if root > 0.0 and (above <= 0.0 or outward < 0.0):
            turn_in = above / (math.sqrt(root) - outward) if above > 0.0 else 0.0
            turn_out = _later_root(square, outward, above, root)
    inward = Stretch(begin, min(turn_in, end), -1) if begin < turn_in else None
    begin = max(begin, turn_out)
    return inward, (Stretch(begin, max(begin, end), 1) if begin <= dt else None)


def _later_root(square: float, outward: float, above: float, root: float) -> float:
    """The later root of square t^2 + 2 outward t + above = 0, without cancellation; root: its quarter discriminant."""
    if outward > 0.0:
        return -above / (outward + math.sqrt(root))
    return (math.sqrt(root) - outward) / square
