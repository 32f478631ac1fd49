"""How every slot of a ring looks: what stands in it, and whether it was just hit."""

import math

from game.effects import Flash
from game.rules import PADDLES
from game.scene import Scene
from game.skins import GLOW, Kind, Look
from physics import PERMANENT

_EMPTY = Look(Kind.EMPTY)
_STEEL = Look(Kind.STEEL)


def paddle_looks(scene: Scene, flashes: list[Flash]) -> tuple[Look, ...]:
    """Looks of the paddles."""
    looks = [Look(Kind.PADDLE)] * scene.rings[PADDLES].count
    for flash in flashes:
        looks[flash.slot] = Look(Kind.PADDLE, 0, _glow(flash))
    return tuple(looks)


def wall_looks(layers: tuple[int, ...], flashes: list[Flash]) -> tuple[Look, ...]:
    """Looks of a ring of bricks. layers: per slot; flashes: of this ring."""
    looks = [_look(count) for count in layers]
    for flash in flashes:
        kind, count, _ = looks[flash.slot]
        looks[flash.slot] = Look(Kind.GHOST if kind is Kind.EMPTY else kind, count, _glow(flash))
    return tuple(looks)


def _look(layers: int) -> Look:
    """A slot's look when nothing happens."""
    if layers == PERMANENT:
        return _STEEL
    return Look(Kind.BRICKS, layers) if layers else _EMPTY


def _glow(flash: Flash) -> int:
    """How strongly a slot glows."""
    return math.ceil((1.0 - flash.age) * GLOW)
