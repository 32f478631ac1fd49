"""Sectors that light up for a moment after a hit; paddles light up only around the hit."""

from typing import NamedTuple

from game.effects.kinds import RETOLD, EffectKind, Shown
from game.rules import Event, EventKind, Ticked
from game.rules.turn import hit_offset
from physics import Hit

FLASH_TICKS = 40


class Flash(NamedTuple):
    """The light of a hit.

    ring, slot: of the sector that was hit.
    layers: left after the hit.
    age: 0 new to 1 gone.
    lit: whether the sector itself lights up, or the part of a paddle that was hit.
    echoed: whether light runs around the rest of its ring.
    offset: angle from a paddle's middle to the hit, radians, counter-clockwise.
    """

    ring: int
    slot: int
    layers: int
    age: float
    lit: bool = True
    echoed: bool = False
    offset: float = 0.0


def after_tick(flashes: tuple[Flash, ...], ticked: Ticked, shown: Shown) -> tuple[Flash, ...]:
    """The flashes a tick later. shown: of flashes and light around a ring, those the player wants."""
    if flashes:
        older = [flash._replace(age=flash.age + 1.0 / FLASH_TICKS) for flash in flashes]
        flashes = tuple([flash for flash in older if flash.age < 1.0])
    new = [
        _flash(event, event.hit, ticked, shown) for event in ticked.events if event.hit is not None and event.kind not in RETOLD
    ]
    new += [_changed(*event.sector, ticked, shown) for event in ticked.events if event.sector is not None]
    return (*flashes, *[flash for flash in new if flash.lit or flash.echoed]) if new else flashes


def _flash(event: Event, hit: Hit, ticked: Ticked, shown: Shown) -> Flash:
    """The light of a hit."""
    echoed = EffectKind.RING in shown and event.kind == EventKind.BRICK_HIT
    offset = hit_offset(hit, ticked.moving) if event.kind == EventKind.PADDLE_HIT else 0.0
    return Flash(hit.ring, hit.slot, hit.layers, 0.0, EffectKind.FLASH in shown, echoed, offset)


def _changed(ring: int, slot: int, ticked: Ticked, shown: Shown) -> Flash:
    """The light of a sector that crumbled or grew without a hit."""
    return Flash(ring, slot, ticked.game.arena.layers[ring][slot], 0.0, EffectKind.FLASH in shown)
