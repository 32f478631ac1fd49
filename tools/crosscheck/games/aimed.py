"""Contacts of every kind: for each cell of the coverage table a ball is aimed so that its contact falls into it.

A game played well meets the paddles with their middles and at moderate angles. Here the feature, the position on it, the
surface's motion, the incidence, the friction, the sector's width and the number of balls are chosen; the rest is drawn.
"""

import cmath
import math
import random
from collections.abc import Iterator
from typing import NamedTuple

from physics import Arena, Ball, Ring, contact, time_of_impact
from tools.crosscheck.games.level_numbers import UNBREAKABLE, numbers_of_arena
from tools.crosscheck.games.trajectory import Advance, Tick
from tools.crosscheck.results.coverage import ALL_CELLS, WIDTHS, CoverageCell

TICK = 1.0 / 240.0
_SPEED = 8.0
_SIZES = 4
"""Rings of different size for each width of sector: pymunk's models of them are built once."""
_MARGIN = 0.03
"""Of a cell's range on either side: contacts stay clear of its borders."""
_INCIDENCES = ((1.0, 29.0), (31.0, 59.0), (61.0, 88.0))
"""Degrees between the relative velocity and the normal, by the cell's incidence."""
_ROLLING = (89.95, 89.99)
"""Degrees: so nearly along the surface that the least speed of leaving it counts. One glancing contact in four."""
_HALF_ANGLES = ((5.0, 19.0), (22.0, 85.0), (95.0, 165.0))
"""Degrees, by the cell's sector."""
_STRIDE = 1009
"""Prime to the number of cells: any few cells in a row are of all kinds."""
_TRIES = 200
"""Arenas to draw for a cell. A ball that rolls along a face may meet its corner first; it is aimed anew."""
_AS_AIMED = 1e-9
"""Seconds."""
SPECIAL = 41
"""One arena in so many is of another kind. In turn, its first ball lies inside material, for the physics to put it outside; a
ball is squeezed between two ends that close in on it, until it has used up its bounces; a ball flies into a notch and touches a
face and an end at the same moment."""


class _Aim(NamedTuple):
    """A contact in the ring's frame: the point, the normal there, and the direction of the ball's flight relative to it."""

    point: complex
    normal: complex
    heading: complex


def aimed_ticks(seed: int, ticks: int, physics: Advance) -> Iterator[Tick]:
    """One arena and one tick for each cell, in turn. seed: of everything that the cells leave open."""
    chance = random.Random(seed)
    sizes = [[_ring_sizes(chance, sector) for _ in range(_SIZES)] for sector in range(len(_HALF_ANGLES))]
    for number in range(ticks):
        special, rest = divmod(number, SPECIAL)
        cell = ALL_CELLS[(number - special) * _STRIDE % len(ALL_CELLS)]
        arena = _aimed_arena(chance, cell, chance.choice(sizes[cell.sector]))
        if rest == SPECIAL - 1:
            arena = (_with_first_ball_inside(arena), _squeezing_arena(chance), _notch_arena(chance))[special % 3]
        yield Tick(number, arena, TICK, physics(arena, TICK, _SPEED), numbers_of_arena(arena, _SPEED))


def _ring_sizes(chance: random.Random, sector: int) -> Ring:
    """A ring with sectors of that width, and gaps that a ball fits through."""
    half_angle = math.radians(chance.uniform(*_HALF_ANGLES[sector]))
    count = chance.choice((2, 3, 5)) if sector == 0 else 1
    radius = chance.uniform(3.5, 9.0)
    return Ring(radius, chance.uniform(0.2, 1.0), half_angle, count)


def _aimed_arena(chance: random.Random, cell: CoverageCell, sizes: Ring) -> Arena:
    """A ring, and balls that touch it within a tick; the first of them as the cell says, and outside material until then."""
    friction = (0.0, chance.uniform(0.1, 0.9), 1.0)[cell.friction]
    ball_radius = chance.uniform(0.1, 0.35)
    for _ in range(_TRIES):
        aim = _aim(chance, sizes, cell.feature, cell.width, cell.incidence)
        spin = 0.0 if cell.motion == 0 else chance.choice((-1.0, 1.0)) * chance.uniform(0.02, 0.3) * _SPEED / abs(aim.point)
        velocity = _velocity(aim, spin)
        along = (velocity.conjugate() * 1j * spin * aim.point).real
        if cell.motion != 0 and (along > 0.0) != (cell.motion == 1):
            continue
        moment, angle = chance.uniform(0.1, 0.9) * TICK, chance.uniform(0.0, math.tau)
        ring = Ring(*sizes[:4], angle - spin * moment, spin, friction)
        first = _ball(aim, velocity, ball_radius, (angle, moment))
        met = time_of_impact(first, ring, TICK)
        if met is not None and abs(met.time - moment) < _AS_AIMED and _is_free(first, ring):
            break
    balls = [first]
    if cell.balls:
        for _ in range(2):
            aim = _aim(chance, sizes, chance.randrange(4), chance.randrange(5), chance.randrange(3))
            balls.append(_ball(aim, _velocity(aim, spin), ball_radius, (angle, moment)))
    lasting = len(balls) - 1  # no other ball breaks the brick that the first is aimed at
    layers = tuple([chance.choice((UNBREAKABLE, lasting + 1, lasting + 2, lasting + 3)) for _ in range(ring.count)])
    return Arena(tuple(balls), (ring,), (layers,))


def _is_free(ball: Ball, ring: Ring) -> bool:
    """Whether a ball overlaps no sector."""
    return all([contact(ball, ring, slot).gap > 0.0 for slot in range(ring.count)])


def _aim(chance: random.Random, ring: Ring, feature: int, width: int, incidence: int) -> _Aim:
    """A contact on a feature of a random slot."""
    share = chance.uniform(width + _MARGIN, width + 1.0 - _MARGIN) / len(WIDTHS)
    side = chance.choice((-1.0, 1.0))
    if feature < 2:
        outward = cmath.rect(1.0, (2.0 * share - 1.0) * ring.half_angle)
        point, normal = (outward * ring.outer_radius, outward) if feature == 0 else (outward * ring.inner_radius, -outward)
    else:
        outward = cmath.rect(1.0, side * ring.half_angle)
        own = side * 1j * outward
        if feature == 2:
            point, normal = outward * (ring.inner_radius + share * 2.0 * ring.half_width), own
        else:
            outer = chance.random() < 0.5
            point = outward * (ring.outer_radius if outer else ring.inner_radius)
            quarter = share * math.pi / 2.0
            normal = own * math.cos(quarter) + (outward if outer else -outward) * math.sin(quarter)
    rolling = incidence == len(_INCIDENCES) - 1 and chance.random() < 0.25
    slant = math.radians(chance.uniform(*(_ROLLING if rolling else _INCIDENCES[incidence])))
    heading = -normal * cmath.rect(1.0, chance.choice((-1.0, 1.0)) * slant)
    turn = cmath.rect(1.0, chance.randrange(ring.count) * math.tau / ring.count)
    return _Aim(point * turn, normal * turn, heading * turn)


def _velocity(aim: _Aim, spin: float) -> complex:
    """The velocity of the balls' speed that, less the surface's, has the heading: |s d + u| = speed, s > 0."""
    pushed = 1j * spin * aim.point
    along = (aim.heading.conjugate() * pushed).real
    size = -along + math.sqrt(along * along + _SPEED * _SPEED - abs(pushed) ** 2)
    velocity = aim.heading * size + pushed
    return velocity * (_SPEED / abs(velocity))


def _ball(aim: _Aim, velocity: complex, ball_radius: float, stand: tuple[float, float]) -> Ball:
    """The ball before its flight to a contact. stand: the ring's angle at the contact, and the seconds until then."""
    turn = cmath.rect(1.0, stand[0])
    position = (aim.point + aim.normal * ball_radius) * turn
    return Ball(position - velocity * turn * stand[1], velocity * turn, ball_radius)


def _with_first_ball_inside(arena: Arena) -> Arena:
    """The first ball moved on along its flight, by most of its radius, into the material."""
    first = arena.balls[0]
    moved = Ball(first.position + first.velocity * (TICK + 0.6 * first.radius / _SPEED), first.velocity, first.radius)
    return arena._replace(balls=(moved, *arena.balls[1:]))


def _squeezing_arena(chance: random.Random) -> Arena:
    """A ball between the ends of two rings that turn towards each other, with hardly any room on either side."""
    radius, ball_radius = chance.uniform(4.0, 8.0), chance.uniform(0.1, 0.3)
    angle, spin = chance.uniform(0.0, math.tau), chance.uniform(0.3, 0.6) * _SPEED / radius
    half_angle = chance.uniform(0.5, 1.5)
    away = half_angle + math.asin(ball_radius * (1.0 + 1e-3) / radius)
    rings = [Ring(radius, 0.4, half_angle, 1, angle + side * away, -side * spin) for side in (-1.0, 1.0)]
    outward = cmath.rect(1.0, angle)
    ball = Ball(outward * radius, outward * 1j * chance.choice((-_SPEED, _SPEED)), ball_radius)
    return Arena((ball,), tuple(rings), ((UNBREAKABLE,), (UNBREAKABLE,)))


def _notch_arena(chance: random.Random) -> Arena:
    """A ball that meets the outer face of one ring and the end of another, which stands on it, in one moment."""
    moment, ball_radius = chance.uniform(0.1, 0.9) * TICK, chance.uniform(0.1, 0.3)
    below, outer = 0.4, chance.uniform(3.0, 7.0)
    distance = outer + ball_radius
    end = cmath.rect(1.0, chance.uniform(0.0, math.tau))
    outward = end * cmath.rect(1.0, math.asin(ball_radius / distance))
    slant = math.radians(chance.uniform(15.0, 75.0))
    velocity = -(outward * math.cos(slant) + 1j * end * math.sin(slant)) * _SPEED
    spins = [chance.choice((0.0, 1.0)) * chance.uniform(-0.2, 0.2) * _SPEED / distance for _ in range(2)]
    frictions = [chance.choice((0.0, chance.random(), 1.0)) for _ in range(2)]
    half_angle = chance.uniform(0.3, 1.0)
    floor = Ring(outer - below, below, 1.5, 1, cmath.phase(outward) - spins[0] * moment, spins[0], frictions[0])
    wall = Ring(outer + 0.65, 0.6, half_angle, 1, cmath.phase(end) - half_angle - spins[1] * moment, spins[1], frictions[1])
    ball = Ball(outward * distance - velocity * moment, velocity, ball_radius)
    return Arena((ball,), (floor, wall), ((UNBREAKABLE,), (chance.choice((1, 2, UNBREAKABLE)),)))
