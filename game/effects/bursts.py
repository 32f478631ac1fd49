"""What flies off: shards of a brick, sparks of steel and paddles.

A burst holds where it began, and a seed made of the hit and its tick. From these alone `debris` finds the position of every
piece at any age, so a tick costs nothing and the same hit always scatters alike.
"""

import math
from enum import Enum, auto
from typing import NamedTuple

from game.effects.kinds import RETOLD, EffectKind, Shown
from game.rules import PADDLES, Event, EventKind, Phase, Ticked
from physics import PERMANENT, Hit, direction, to_polar

SHARD_TICKS, SPARK_TICKS = 170, 84
"""Ticks that shards and sparks are to be seen."""
MOST = 12
"""Bursts at once; the oldest make room."""

_FIREWORKS, _FIREWORK_RADIUS = 6, 0.3
"""Bursts for a cleared level, and how far from the centre they are, in shares of the ground's radius."""
_WON_TICKS, _WON_RADII = 90, (0.6, 0.3, 0.75, 0.45, 0.6)
"""From fireworks to fireworks when the last level is cleared, and how far from the centre those are."""


class Matter(Enum):
    """What flies."""

    BRICK = auto()
    STEEL = auto()
    PADDLE = auto()
    BALL = auto()


class BurstOrigin(NamedTuple):
    """The sector that the pieces come from: a point where half_width and half_angle are 0.

    radius, half_width: world units. angle, half_angle: radians.
    """

    radius: float
    half_width: float
    angle: float
    half_angle: float


class Burst(NamedTuple):
    """Pieces that fly off.

    matter: what they are of.
    origin: where they begin.
    direction: that they are driven in: unit, or 0 for none.
    layer: of a brick, 1 the lowest, its tint added, which tells its colour; 0 of all else.
    seed: of how they scatter.
    age: ticks.
    """

    matter: Matter
    origin: BurstOrigin
    direction: complex
    layer: int
    seed: int
    age: int = 0


def after_tick(bursts: tuple[Burst, ...], ticked: Ticked, shown: Shown) -> tuple[Burst, ...]:
    """The bursts a tick later. shown: of shards and sparks, those the player wants."""
    if bursts:
        older = [burst._replace(age=burst.age + 1) for burst in bursts]
        bursts = tuple([burst for burst in older if burst.age < lifetime(burst.matter)])
    new = [burst for event in ticked.events for burst in _bursts(event, ticked) if _effect(burst) in shown]
    if EffectKind.SHARDS in shown:
        new += _celebration(ticked)
    return (*bursts, *new)[-MOST:] if new else bursts


def _celebration(ticked: Ticked) -> tuple[Burst, ...]:
    """More fireworks, one after the other, once the game is won."""
    game = ticked.game
    number, rest = divmod(game.phase_tick, _WON_TICKS)
    if game.phase != Phase.WON or rest or not 0 < number <= len(_WON_RADII):
        return ()
    return _fireworks(game.tick, _WON_RADII[number - 1] * game.level.ground_radius)


def lifetime(matter: Matter) -> int:
    """Ticks that pieces are to be seen."""
    return SHARD_TICKS if matter in {Matter.BRICK, Matter.BALL} else SPARK_TICKS


def _effect(burst: Burst) -> EffectKind:
    """The effect that a burst belongs to."""
    return EffectKind.SHARDS if burst.matter is Matter.BRICK else EffectKind.SPARKS


def _bursts(event: Event, ticked: Ticked) -> tuple[Burst, ...]:
    """The bursts of an event; some have none."""
    tick = ticked.game.tick
    if event.kind in {EventKind.LEVEL_CLEARED, EventKind.CORE_BROKEN}:
        return _fireworks(tick, _FIREWORK_RADIUS * ticked.game.level.ground_radius)
    if event.kind in RETOLD:
        return ()
    if event.hit is not None and event.kind != EventKind.SHIELD_HIT:
        return (_burst_of_hit(event.hit, ticked),)
    if event.kind == EventKind.BRICK_CRUMBLED and event.sector is not None:
        return (_burst_of_stack(*event.sector, ticked),)
    thrown = _thrown(event, ticked)
    return () if thrown is None else (Burst(*thrown, 0, tick),)


def _thrown(event: Event, ticked: Ticked) -> tuple[Matter, BurstOrigin, complex] | None:
    """What flies off at the position of an event that is no hit of a sector, and where it is driven."""
    match event.kind:
        case EventKind.BALL_LOST:
            return Matter.BALL, _point(event.position), -_unit(event.position)
        case EventKind.SERVED:
            return Matter.PADDLE, _point(event.position), _unit(ticked.game.arena.balls[0].velocity)
        case EventKind.BALLS_MET:
            return Matter.STEEL, _point(event.position), 0j
        case EventKind.SHIELD_HIT | EventKind.DROP_CAUGHT | EventKind.BRICK_REGROWN | EventKind.BALL_RELEASED:
            return Matter.PADDLE, _point(event.position), -_unit(event.position)
    return None


def _burst_of_stack(ring: int, slot: int, ticked: Ticked) -> Burst:
    """The burst of a layer that has crumbled: from all of its sector, in no direction."""
    sectors, layers = ticked.game.arena.rings[ring], ticked.game.arena.layers[ring][slot]
    tint = ticked.game.level.rings[ring - PADDLES - 1].tint_at(slot)
    origin = BurstOrigin(sectors.radius, sectors.half_width, sectors.angle(slot), sectors.half_angle)
    return Burst(Matter.BRICK, origin, 0j, layers + 1 + tint, _seed(ticked.game.tick, ring, slot))


def _seed(tick: int, ring: int, slot: int) -> int:
    """Another one for every sector that breaks."""
    return (tick * 64 + ring) * 4096 + slot


def _burst_of_hit(hit: Hit, ticked: Ticked) -> Burst:
    """The burst of a hit."""
    seed = _seed(ticked.game.tick, hit.ring, hit.slot)
    point = _point(hit.contact.point)
    if hit.ring == PADDLES or hit.layers == PERMANENT:
        return Burst(Matter.PADDLE if hit.ring == PADDLES else Matter.STEEL, point, hit.contact.normal, 0, seed)
    ring, tint = ticked.game.arena.rings[hit.ring], ticked.game.level.rings[hit.ring - PADDLES - 1].tint_at(hit.slot)
    around = point._replace(half_width=0.5 * ring.half_width, half_angle=0.5 * ring.half_angle)
    return Burst(Matter.BRICK, around, hit.contact.normal, hit.layers + 1 + tint, seed)


def _fireworks(tick: int, radius: float) -> tuple[Burst, ...]:
    """Shards of every colour, from a circle around the centre. radius: of the circle, world units."""
    directions = [direction(math.tau * k / _FIREWORKS) for k in range(_FIREWORKS)]
    return tuple([Burst(Matter.BRICK, _point(out * radius), out, k + 1, tick + k) for k, out in enumerate(directions)])


def _point(position: complex) -> BurstOrigin:
    """A single point."""
    radius, angle = to_polar(position)
    return BurstOrigin(radius, 0.0, angle, 0.0)


def _unit(vector: complex) -> complex:
    """A vector of the same direction and length 1; 0 for the vector 0."""
    size = abs(vector)
    return vector / size if size else 0j
