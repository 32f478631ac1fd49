"""Mistakes in what the game makes of a level file."""

from collections.abc import Callable
from contextlib import AbstractContextManager

from game.levels import Level
from physics import Arena, Ring
from tools.crosscheck.sabotage.replacing import method

_right = Level.arena


def slippery_paddles() -> AbstractContextManager[None]:
    """The paddles have a tenth less friction than their level says."""
    return _other_rings(lambda index, ring: ring if index else ring._replace(friction=0.9 * ring.friction))


def thicker_bricks() -> AbstractContextManager[None]:
    """Bricks are thicker by a millionth than their level says."""
    return _other_rings(lambda index, ring: ring._replace(half_width=ring.half_width * (1.0 + 1e-6)) if index else ring)


def slower_bricks() -> AbstractContextManager[None]:
    """Bricks turn slower by a thousandth than their level says."""
    return _other_rings(lambda index, ring: ring._replace(spin=0.999 * ring.spin) if index else ring)


def one_layer_more() -> AbstractContextManager[None]:
    """Every brick has a layer more than its level says."""

    def arena(level: Level) -> Arena:
        right = _right(level)
        return right._replace(layers=tuple([tuple([one + (one > 0) for one in ring]) for ring in right.layers]))

    return method(Level, "arena", arena)


def _other_rings(change: Callable[[int, Ring], Ring]) -> AbstractContextManager[None]:
    """The arena of a level with its rings changed; ring 0 is the paddles."""

    def arena(level: Level) -> Arena:
        right = _right(level)
        return right._replace(rings=tuple([change(index, ring) for index, ring in enumerate(right.rings)]))

    return method(Level, "arena", arena)
