"""How the rest of a stack comes down after a hit took its lowest layer. A picture only: the rules have moved on at once.

Heights count layers. What is left of a stack falls as one piece; it bounces once or more, and then it is at rest.
"""

from typing import NamedTuple

from game.rules import TICK, EventKind, Ticked

GRAVITY = 26.0
"""Layers per second, per second."""
BOUNCE = 0.3
"""Share of its speed that a landing stack keeps."""
_REST = 0.9
"""Layers per second; a stack that lands more slowly stays."""


class Drop(NamedTuple):
    """A stack that is still above its slot.

    ring, slot: where.
    height: layers above where it will rest, >= 0.
    speed: layers per second, upwards.
    """

    ring: int
    slot: int
    height: float
    speed: float


def after_tick(drops: tuple[Drop, ...], ticked: Ticked) -> tuple[Drop, ...]:
    """The drops a tick later, with those that its hits began."""
    drops = fallen(drops)
    for event in ticked.events:
        if event.kind == EventKind.BRICK_HIT and event.hit is not None:
            drops = after_hit(drops, event.hit.ring, event.hit.slot, event.hit.layers)
    return drops


def after_hit(drops: tuple[Drop, ...], ring: int, slot: int, layers: int) -> tuple[Drop, ...]:
    """The drops after a slot lost its lowest layer. layers: left; with none left nothing falls."""
    others = tuple([drop for drop in drops if (drop.ring, drop.slot) != (ring, slot)])
    if layers <= 0:
        return others
    before = next((drop for drop in drops if (drop.ring, drop.slot) == (ring, slot)), Drop(ring, slot, 0.0, 0.0))
    return (*others, before._replace(height=before.height + 1.0))


def fallen(drops: tuple[Drop, ...]) -> tuple[Drop, ...]:
    """The drops a tick later; those that came to rest are gone."""
    moved = [_moved(drop) for drop in drops]
    return tuple([drop for drop in moved if drop.height > 0.0 or drop.speed > 0.0])


def _moved(drop: Drop) -> Drop:
    """One drop a tick later; where it would sink into the ground it lands, and bounces or rests."""
    speed = drop.speed - GRAVITY * TICK
    height = drop.height + speed * TICK
    if height > 0.0:
        return drop._replace(height=height, speed=speed)
    speed = -BOUNCE * speed
    return drop._replace(height=0.0, speed=speed if speed > _REST else 0.0)
