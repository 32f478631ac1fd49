"""Where to put a ball that overlaps material: it was spawned there, or two closing ends squeeze it."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.broad_phase import in_band, nearest_slot
from physics.narrow_phase import contact
from physics.polar import min_difference
from physics.shapes import Arena, Ball, Contact, Ring
from physics.tolerances import MAX_STEPS, OVERLAP
from physics.trig import direction
from physics.vectors import length

_PUSHES = 8


class _Overlap(NamedTuple):
    """A sector that the ball overlaps."""

    ring: Ring
    slot: int
    contact: Contact


def all_freed(arena: Arena) -> Arena:
    """The arena itself where no ball overlaps anything; else with every such ball moved out of the material."""
    balls = tuple([freed(ball, arena.rings, arena.layers) for ball in arena.balls])
    for k in range(len(balls)):
        if balls[k] is not arena.balls[k]:
            return Arena(balls, arena.rings, arena.layers)
    return arena


def freed(ball: Ball, rings: Sequence[Ring], layers: Sequence[Sequence[int]]) -> Ball:
    """The ball itself where it overlaps nothing; else the ball moved out of the material, its velocity kept.

    It is pushed along the normal of its deepest overlap, by the least depth, up to eight times; if that does not free it
    (it is squeezed), it is put at the nearest free place outward on its own bearing.
    """
    pushed = ball
    for _ in range(_PUSHES):
        overlap = _deepest_overlap(pushed, rings, layers)
        if overlap is None:
            return pushed
        found = overlap.contact
        pushed = Ball(pushed.position - found.normal * found.gap, pushed.velocity, pushed.radius)
    return _outward(ball, rings, layers)


def _deepest_overlap(ball: Ball, rings: Sequence[Ring], layers: Sequence[Sequence[int]]) -> _Overlap | None:
    """The sector that the ball overlaps most, if by more than what a bounce leaves; of equals the first."""
    limit = -OVERLAP * ball.radius
    deepest: _Overlap | None = None
    for k in range(len(rings)):
        ring, alive = rings[k], layers[k]
        if in_band(length(ball.position), ball.radius, ring):
            nearest = nearest_slot(ring, ball.theta())
            for step in range(-_slots_aside(ball, ring), _slots_aside(ball, ring) + 1):
                slot = (nearest + step) % ring.count
                if alive[slot] != 0:
                    found = contact(ball, ring, slot)
                    if found.gap < limit:
                        limit, deepest = found.gap, _Overlap(ring, slot, found)
    return deepest


def _slots_aside(ball: Ball, ring: Ring) -> int:
    """How many slots to either side of the nearest one a ball may overlap where it is.

    At distance d a disc of radius r is seen under asin(r / d) <= r pi / (2 d) to each side.
    """
    every = ring.count // 2
    distance = length(ball.position)
    if distance <= ball.radius:
        return every
    pitch = math.tau / ring.count
    return min(int((ball.radius * math.pi / (2.0 * distance) + ring.half_angle) / pitch + 0.5) + 1, every)


def _outward(ball: Ball, rings: Sequence[Ring], layers: Sequence[Sequence[int]]) -> Ball:
    """The ball at the nearest free place outward on its bearing."""
    theta = ball.theta()
    along = direction(theta)
    for _ in range(MAX_STEPS):
        overlap = _deepest_overlap(ball, rings, layers)
        if overlap is None:
            return ball
        distance = _exit_radius(ball.radius, theta, overlap.ring, overlap.slot)
        ball = Ball(along * distance, ball.velocity, ball.radius)
    outside = max([ring.outer_radius for ring in rings]) + ball.radius
    return Ball(along * outside, ball.velocity, ball.radius)


def _exit_radius(ball_radius: float, theta: float, ring: Ring, slot: int) -> float:
    """Distance from the centre at which a ball that moves outward at an angle leaves a sector behind."""
    inner, outer = ring.inner_radius, ring.outer_radius
    outside = min_difference(theta, ring.angle(slot)) - ring.half_angle
    if outside <= 0.0:
        return outer + ball_radius
    end = direction(outside)
    foot = ball_radius * end.real / end.imag if end.imag > 0.0 else math.inf
    if end.real > 0.0 and inner <= foot <= outer:
        return ball_radius / end.imag  # beside the straight end
    corner = outer if end.real > 0.0 and foot > outer else inner
    away = corner * end.imag
    return corner * end.real + math.sqrt(max(ball_radius - away, 0.0) * (ball_radius + away))  # |d - corner e^(i outside)| = r
