"""How every slot of a ring looks: what stands in it, and how brightly it glows after a hit."""

import math
from functools import lru_cache

from game.drawing.flat.sector_colours import GLOW, Kind, Look
from game.effects import Flash
from game.rules import PADDLES
from game.scene import Scene
from physics import PERMANENT

_EMPTY = Look(Kind.EMPTY)
_STEEL = Look(Kind.STEEL)
_ECHO = 2
"""How much a ring glows where the light of a hit just runs by."""


def paddle_looks(scene: Scene, flashes: list[Flash]) -> tuple[Look, ...]:
    """Looks of the paddles."""
    looks = [Look(Kind.PADDLE)] * scene.rings[PADDLES].count
    for flash in flashes:
        looks[flash.slot] = Look(Kind.PADDLE, 0, _glow(flash))
    return tuple(looks)


def wall_looks(layers: tuple[int, ...], flashes: list[Flash]) -> tuple[Look, ...]:
    """Looks of a ring of bricks. layers: per slot; flashes: of this ring."""
    resting = _resting(layers)
    if not flashes:
        return resting
    looks = list(resting)
    for flash in flashes:
        if flash.echoed:
            _echo(looks, flash)
    for flash in flashes:
        if flash.lit:
            kind, count, _ = looks[flash.slot]
            looks[flash.slot] = Look(Kind.GHOST if kind is Kind.EMPTY else kind, count, _glow(flash))
    return tuple(looks)


@lru_cache(maxsize=64)
def _resting(layers: tuple[int, ...]) -> tuple[Look, ...]:
    """The looks of a ring where nothing happens."""
    return tuple([_look(count) for count in layers])


def _look(layers: int) -> Look:
    """A slot's look when nothing happens."""
    if layers == PERMANENT:
        return _STEEL
    return Look(Kind.BRICKS, layers) if layers else _EMPTY


def _glow(flash: Flash) -> int:
    """How strongly a slot glows."""
    return math.ceil((1.0 - flash.age) * GLOW)


def _echo(looks: list[Look], flash: Flash) -> None:
    """Light that runs both ways around the ring and meets at the other side; it moves when the flash's own glow changes."""
    front = (GLOW - _glow(flash) + 1) / GLOW * (len(looks) / 2.0)
    width = len(looks) / (2.0 * GLOW)
    for slot, (kind, count, glow) in enumerate(looks):
        away = abs((slot - flash.slot + len(looks) // 2) % len(looks) - len(looks) // 2)
        if kind is not Kind.EMPTY and front - 2.0 * width < away <= front:
            looks[slot] = Look(kind, count, max(glow, _ECHO if away > front - width else 1))
