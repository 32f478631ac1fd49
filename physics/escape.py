"""Where to put a ball that overlaps material: it was spawned there, or two closing ends squeeze it."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.broad_phase import nearest_slot
from physics.narrow_phase import contact
from physics.polar import signed_difference
from physics.shapes import Ball, Contact, Ring
from physics.tolerances import MAX_STEPS, OVERLAP
from physics.trig import angle_of, direction
from physics.vectors import length

_PUSHES = 8


class _Overlap(NamedTuple):
    """A sector that the ball overlaps."""

    ring: Ring
    slot: int
    contact: Contact


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
    """The sector that the ball overlaps most, if by more than what a bounce leaves."""
    distance = length(ball.position)
    deepest: _Overlap | None = None
    for ring, alive in zip(rings, layers, strict=True):
        if abs(distance - ring.radius) > ring.half_width + ball.radius:
            continue
        for slot in _slots_near(ball, ring):
            if alive[slot] == 0:
                continue
            found = contact(ball, ring, slot)
            limit = -OVERLAP * ball.radius if deepest is None else deepest.contact.gap
            if found.gap < limit:
                deepest = _Overlap(ring, slot, found)
    return deepest


def _slots_near(ball: Ball, ring: Ring) -> list[int]:
    """The slots whose sectors the ball can reach from where it is, in the order of their number."""
    distance = length(ball.position)
    if distance <= ball.radius:
        return list(range(ring.count))
    pitch = math.tau / ring.count
    reach = ball.radius * math.pi / (2.0 * distance) + ring.half_angle
    bearing = angle_of(ball.position)
    nearest = nearest_slot(ring, bearing)
    span = min(int(reach / pitch) + 1, ring.count // 2)
    near = {(nearest + k) % ring.count for k in range(-span, span + 1)}
    return sorted([slot for slot in near if abs(signed_difference(bearing, ring.angle(slot))) <= reach])


def _outward(ball: Ball, rings: Sequence[Ring], layers: Sequence[Sequence[int]]) -> Ball:
    """The ball at the nearest free place outward on its bearing."""
    bearing = angle_of(ball.position)
    along = direction(bearing)
    for _ in range(MAX_STEPS):
        overlap = _deepest_overlap(ball, rings, layers)
        if overlap is None:
            return ball
        distance = _exit_radius(ball.radius, bearing, overlap.ring, overlap.slot)
        ball = Ball(along * distance, ball.velocity, ball.radius)
    outside = max([ring.outer_radius for ring in rings]) + ball.radius
    return Ball(along * outside, ball.velocity, ball.radius)


def _exit_radius(ball_radius: float, bearing: float, ring: Ring, slot: int) -> float:
    """Distance from the centre at which a ball that moves outward on a bearing leaves a sector behind."""
    outside = abs(signed_difference(bearing, ring.angle(slot))) - ring.half_angle
    outer = ring.outer_radius
    if outside <= 0.0:
        return outer + ball_radius
    end = direction(outside)
    if ball_radius >= outer * end.imag:  # past the outer corner: |d e^(i outside) - outer| = r
        return outer * end.real + math.sqrt((ball_radius - outer * end.imag) * (ball_radius + outer * end.imag))
    return ball_radius / end.imag  # between the corners: at distance r from the straight end
