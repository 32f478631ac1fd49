"""What flies off: shards of a brick, sparks of steel and paddles.

A burst holds where it began and a seed from the hit and its tick: `debris` finds every piece's place at any age from that
alone, so a tick costs nothing and the same hit always scatters alike.
"""

import math
from enum import Enum, auto
from typing import NamedTuple

from game.effects.kinds import Kind, Shown
from game.rules import PADDLES, Event, EventKind, Ticked
from physics import PERMANENT, Hit, Ring, direction, to_polar

SHARD_TICKS, SPARK_TICKS = 170, 84
MOST = 10
"""Bursts at once; the oldest make room."""

_FIREWORKS = 6
"""Bursts for a cleared level."""


class Matter(Enum):
    """What flies."""

    BRICK = auto()
    STEEL = auto()
    PADDLE = auto()
    BALL = auto()


class Place(NamedTuple):
    """The sector that the pieces come from: a point where half_width and half_angle are 0."""

    radius: float
    half_width: float
    angle: float  # radians
    half_angle: float


class Burst(NamedTuple):
    """Pieces on their way."""

    matter: Matter
    place: Place
    way: complex  # that they are driven: unit, or 0
    layer: int  # of a brick, 1 the lowest: its colour
    seed: int
    age: int = 0  # ticks


def after_tick(bursts: tuple[Burst, ...], ticked: Ticked, shown: Shown) -> tuple[Burst, ...]:
    """The bursts a tick later. shown: of shards and sparks, those the player wants."""
    if bursts:
        older = [burst._replace(age=burst.age + 1) for burst in bursts]
        bursts = tuple([burst for burst in older if burst.age < lasting(burst.matter)])
    new = [burst for event in ticked.events for burst in _bursts(event, ticked) if _wanted(burst) in shown]
    return (*bursts, *new)[-MOST:] if new else bursts


def lasting(matter: Matter) -> int:
    """Ticks that pieces are to be seen."""
    return SHARD_TICKS if matter in {Matter.BRICK, Matter.BALL} else SPARK_TICKS


def _wanted(burst: Burst) -> Kind:
    """What the player must want, to see it."""
    return Kind.SHARDS if burst.matter is Matter.BRICK else Kind.SPARKS


def _bursts(event: Event, ticked: Ticked) -> tuple[Burst, ...]:
    """What an event sends flying; nothing, after some."""
    tick = ticked.game.tick
    if event.hit is not None:
        return (_struck(event.hit, tick, ticked.game.arena.rings[event.hit.ring]),)
    match event.kind:
        case EventKind.BALL_LOST:
            return (Burst(Matter.BALL, _point(event.position), -_unit(event.position), 0, tick),)
        case EventKind.SERVED:
            way = _unit(ticked.game.arena.balls[0].velocity)
            return (Burst(Matter.PADDLE, _point(event.position), way, 0, tick),)
        case EventKind.LEVEL_CLEARED:
            return _fireworks(tick, ticked.game.level.ground_radius)
    return ()


def _struck(hit: Hit, tick: int, ring: Ring) -> Burst:
    """What a hit sends flying."""
    seed = (tick * 64 + hit.ring) * 4096 + hit.slot  # another one for every hit
    point = _point(hit.contact.point)
    if hit.ring == PADDLES or hit.layers == PERMANENT:
        return Burst(Matter.PADDLE if hit.ring == PADDLES else Matter.STEEL, point, hit.contact.normal, 0, seed)
    around = point._replace(half_width=0.5 * ring.half_width, half_angle=0.5 * ring.half_angle)
    return Burst(Matter.BRICK, around, hit.contact.normal, hit.layers + 1, seed)


def _fireworks(tick: int, ground_radius: float) -> tuple[Burst, ...]:
    """Shards of every colour, from a ring around the centre."""
    ways = [direction(math.tau * k / _FIREWORKS) for k in range(_FIREWORKS)]
    return tuple([Burst(Matter.BRICK, _point(way * 0.3 * ground_radius), way, k + 1, tick + k) for k, way in enumerate(ways)])


def _point(position: complex) -> Place:
    """A single point."""
    radius, angle = to_polar(position)
    return Place(radius, 0.0, angle, 0.0)


def _unit(way: complex) -> complex:
    """The direction of a way; 0 of none."""
    size = abs(way)
    return way / size if size else 0j
