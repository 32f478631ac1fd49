"""What every answer of `time_of_impact` must satisfy, by dense sampling and with 50 digits; and the symmetries of a scene."""

import cmath
import math

import mpmath

from physics import Ball, Ring, time_of_impact

mpmath.mp.dps = 50

EXACT = 1e-12
SPINS = [0.0, 1.3, -1.3]
TURNS = [0.0, math.pi / 2.0, math.pi, -math.pi, 2.0 * math.pi / 7.0]


def gap(ball, ring, time, slots, math=math):
    """Gap to the nearest of some sectors at a time; with `math=mpmath`, to 50 digits."""
    number = float if math.__name__ == "math" else math.mpf
    t = number(time)
    x = number(ball.position.real) + number(ball.velocity.real) * t
    y = number(ball.position.imag) + number(ball.velocity.imag) * t
    inner = number(ring.radius) - number(ring.half_width)
    outer = number(ring.radius) + number(ring.half_width)
    distance, bearing = math.sqrt(x * x + y * y), math.atan2(y, x)
    best = number("inf")
    for slot in slots:
        offset = bearing - number(ring.phase) - 2 * math.pi * slot / ring.count - number(ring.spin) * t
        offset -= 2 * math.pi * math.floor(offset / (2 * math.pi) + number(0.5))
        beside = abs(offset) - number(ring.half_angle)
        if beside <= 0:
            best = min(best, max(inner - distance, distance - outer))
        else:
            along, across = distance * math.cos(beside), distance * math.sin(beside)
            foot = min(max(along, inner), outer)
            best = min(best, math.sqrt((along - foot) ** 2 + across**2))
    return best - number(ball.radius)


def checked_impact(ball, ring, dt, alive=None):
    """`time_of_impact`, after its answer was found right: the gap is closed at its time, and was not before."""
    found = time_of_impact(ball, ring, dt, alive)
    slots = [slot for slot in range(ring.count) if alive is None or alive[slot]]
    stop = dt
    if found is not None:
        stop = found.time
        assert 0.0 <= found.time <= dt
        assert found.slot in slots
        assert abs(gap(ball, ring, found.time, [found.slot], mpmath)) < EXACT
        there = ball.position + ball.velocity * found.time
        assert abs(abs(found.contact.normal) - 1.0) < 1e-15
        assert abs(there - found.contact.normal * ball.radius - found.contact.point) < 2e-12
    if slots:
        assert first_dip(ball, ring, stop, slots) is None, found
    return found


def first_dip(ball, ring, stop, slots):
    """The first moment up to `stop` at which the gap is below -EXACT, by steps that its rate of change bounds."""
    rate = abs(ball.velocity) + abs(ring.spin) * (ring.radius + ring.half_width)
    time = 0.0
    for _ in range(200_000):
        now = gap(ball, ring, time, slots)
        if now < -EXACT:
            return time
        if time >= stop or rate == 0.0:
            return None
        time = min(time + max(now / rate, 1e-6 * ball.radius / rate, stop * 1e-5), stop)
    raise AssertionError((ball, ring, stop))


def turned_scene(ball, ring, turn):
    """The scene seen by somebody who has turned."""
    by = cmath.rect(1.0, turn)
    return Ball(ball.position * by, ball.velocity * by, ball.radius), ring._replace(phase=(ring.phase + turn) % math.tau)


def mirrored_scene(ball, ring):
    """The scene in a mirror along the x axis; slot k becomes slot -k."""
    mirrored = Ball(ball.position.conjugate(), ball.velocity.conjugate(), ball.radius)
    return mirrored, Ring(ring.radius, ring.half_width, ring.half_angle, ring.count, -ring.phase, -ring.spin, ring.friction)
