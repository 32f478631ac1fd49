"""Ticks with true and false claims, for the proofs to judge."""

import cmath
import math

import pytest

pytest.importorskip("flint", reason="the proofs need python-flint, the extra [proof]")

from physics import PERMANENT, Arena, Ball, Contact, Feature, Hit, Ring, advance
from tools.certify.certificate import certificates
from tools.certify.flights import ClaimedTick

SPEED = 8.0
TICK = 1.0 / 240.0
RADIUS = 0.2

RING = Ring(5.0, 0.4, 0.3, 3, 0.2, 0.0, 0.5)
"""Three sectors; slot 0 reaches from -0.1 to 0.5 rad."""


def flying_at(target, direction, *, spin=0.0, before=0.5, count=3, half_angle=0.3):
    """An arena whose ball reaches a point after half a tick, on a straight line, if nothing is in between."""
    ring = Ring(5.0, 0.4, half_angle, count, 0.2 - spin * TICK * before, spin, 0.5)
    v = SPEED * direction
    return Arena((Ball(target - v * (TICK * before), v, RADIUS),), (ring,), ((PERMANENT,) * count,))


def towards_feature(feature, spin=0.0):
    """An arena whose ball touches a feature of slot 0 in mid-tick, not head-on."""
    aslant = cmath.rect(1.0, 0.4)
    if feature == Feature.OUTER_FACE:
        n = cmath.rect(1.0, 0.3)
        return flying_at(n * (5.4 + RADIUS), -n * aslant, spin=spin)
    if feature == Feature.INNER_FACE:
        n = cmath.rect(1.0, 0.3)
        return flying_at(n * (4.6 - RADIUS), n * aslant, spin=spin)
    end = cmath.rect(1.0, 0.5)
    if feature == Feature.END:
        return flying_at(end * (5.1 + 1j * RADIUS), -1j * end * aslant, spin=spin)
    n = end * cmath.rect(1.0, 0.7)
    return flying_at(end * 5.4 + n * RADIUS, -n * aslant, spin=spin)


def past_a_corner(sign, outer, spin, miss):
    """An arena, and the length of a tick, whose ball passes one corner of slot 0 aslant, at a least distance `miss`.

    From 0.15 on it comes near nothing but the corner; it is nearest at a moment that no halving meets. sign: +1 the
    counter-clockwise end, -1 the clockwise one.
    """
    end = cmath.rect(1.0, 0.2 + sign * 0.3)
    away = end * (1.0 if outer else -1.0) + 1j * sign * end
    away /= abs(away)
    v = SPEED * away * 1j
    dt, nearest = 0.6 / SPEED, 0.37 * 0.6 / SPEED
    p = end * (5.4 if outer else 4.6) + away * miss - v * nearest
    ring = Ring(5.0, 0.4, 0.3, 3, 0.2 - spin * nearest, spin)
    return Arena((Ball(p, v, RADIUS),), (ring,), ((PERMANENT,) * 3,)), dt


def along_a_turning_end(sign, miss):
    """An arena, and the length of a tick, whose ball flies outward along an end of slot 0 that turns away from it.

    Seen from the end it comes down to a least height `miss` above the middle of the end, and rises again.
    """
    end, spin = cmath.rect(1.0, 0.2 + sign * 0.3), -0.9 * sign
    v = end * complex(SPEED, spin * 5.0)
    dt, nearest = 0.06, 0.37 * 0.06
    p = end * complex(5.0, sign * miss) - v * nearest
    ring = Ring(5.0, 0.4, 0.3, 3, 0.2 - spin * nearest, spin)
    return Arena((Ball(p, v, RADIUS),), (ring,), ((PERMANENT,) * 3,)), dt


def played(arena, dt=TICK):
    """The tick as the physics plays it."""
    return ClaimedTick(0, arena, dt, SPEED, advance(arena, dt, SPEED))


def claiming(tick, number=0, **changes):
    """The tick with another claim in one of its hits. turned: radians added to its normal; moved: added to its point."""
    hits = list(tick.step.hits)
    hit = hits[number]
    if "turned" in changes:
        normal = hit.contact.normal * cmath.rect(1.0, changes.pop("turned"))
        changes["contact"] = hit.contact._replace(normal=normal)
    if "moved" in changes:
        changes["contact"] = hit.contact._replace(point=hit.contact.point + changes.pop("moved"))
    hits[number] = hit._replace(**changes)
    return tick._replace(step=tick.step._replace(hits=tuple(hits)))


def flown_through(arena, dt=TICK):
    """The tick of a physics that sees no touch."""
    end = Arena(tuple([ball.moved(dt) for ball in arena.balls]), tuple([ring.turned(dt) for ring in arena.rings]), arena.layers)
    step = advance(arena._replace(balls=()), dt, SPEED)
    return ClaimedTick(0, arena, dt, SPEED, step._replace(arena=end))


def with_hit(tick, time, normal, slot=0):
    """The tick with one hit of ball 0 on ring 0, after which the ball rests."""
    ball = tick.arena.balls[0]
    contact = Contact(normal, ball.position - normal * ball.radius, 0.0, Feature.OUTER_FACE)
    hit = Hit(time, 0, 0, slot, contact, ball.velocity, ball.velocity, PERMANENT)
    return tick._replace(step=tick.step._replace(hits=(hit,), dropped=1))


def verdicts(tick):
    """(verdict, reason) of every flight of a tick, in words."""
    return [(one.verdict.name, one.reason.name) for one in certificates(tick)]


def first_impact(tick):
    """The first certificate of an impact."""
    return next(one for one in certificates(tick) if one.hit is not None)


def above_a_wall(gap):
    """A closed ring, and a ball that flies past it at a least distance `gap`, in the middle of the tick."""
    wall = Ring(5.0, 0.5, math.pi, 1)
    travel = SPEED * TICK
    ball = Ball(complex(-travel / 2.0, 5.75 + gap), complex(SPEED, 0.0), 0.25)
    return Arena((ball,), (wall,), ((PERMANENT,),))
