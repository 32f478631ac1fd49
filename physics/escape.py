"""Where to put a ball that overlaps material: it was spawned there, or two closing ends squeeze it."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from physics.narrow_phase import contact
from physics.polar import signed_difference
from physics.shapes import Ball, Contact, Ring
from physics.tolerances import MAX_STEPS, OVERLAP
from physics.trig import angle_of, bearing_of, direction
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
    """The sector that the ball overlaps most, if by more than what a bounce leaves; of equals the first."""
    distance = length(ball.position)
    limit = -OVERLAP * ball.radius
    deepest: _Overlap | None = None
    for ring, alive in zip(rings, layers, strict=True):
        if abs(distance - ring.radius) > ring.half_width + ball.radius:
            continue
        bearing = bearing_of(ball.position)
        for slot in _slots_near(ball, distance, bearing, ring):
            if alive[slot] != 0:
                found = contact(ball, ring, slot)
                if found.gap < limit:
                    limit, deepest = found.gap, _Overlap(ring, slot, found)
    return deepest


def _slots_near(ball: Ball, distance: float, bearing: float, ring: Ring) -> range | list[int]:
    """The slots whose sectors a ball at a distance and a bearing can reach from where it is."""
    if distance <= ball.radius:
        return range(ring.count)
    pitch = math.tau / ring.count
    reach = ball.radius * math.pi / (2.0 * distance) + ring.half_angle
    place = (bearing - ring.phase) / pitch
    first, last = math.ceil(place - reach / pitch), math.floor(place + reach / pitch)
    return [slot % ring.count for slot in range(first, min(last + 1, first + ring.count))]


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
    inner, outer = ring.inner_radius, ring.outer_radius
    outside = abs(signed_difference(bearing, ring.angle(slot))) - ring.half_angle
    if outside <= 0.0:
        return outer + ball_radius
    end = direction(outside)
    foot = ball_radius * end.real / end.imag if end.imag > 0.0 else math.inf
    if end.real > 0.0 and inner <= foot <= outer:
        return ball_radius / end.imag  # beside the straight end
    corner = outer if end.real > 0.0 and foot > outer else inner
    away = corner * end.imag
    return corner * end.real + math.sqrt(max(ball_radius - away, 0.0) * (ball_radius + away))  # |d - corner e^(i outside)| = r
