"""The pieces of many bursts at once, in arrays: `game.effects.piece_paths` says how they begin and fly."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.array_maths import ARRAYS, Arrays
from game.effects.bursts import Burst
from game.effects.piece_paths import FlyingPiece, ThrownPiece, flown, thrown
from game.rules import TICK


class Pieces(NamedTuple):
    """Every piece of some bursts, one a row.

    flying: the pieces. burst: index of the burst that each is of.
    """

    flying: FlyingPiece[Arrays]
    burst: NDArray[np.int64]


def pieces(bursts: Sequence[Burst], ground_radius: float) -> Pieces:
    """All pieces of some bursts."""
    start, whose = _thrown(tuple([burst._replace(age=0) for burst in bursts]))
    time = np.array([burst.age * TICK for burst in bursts])[whose]
    return Pieces(flown(ARRAYS, start, time, ground_radius), whose)


@lru_cache(maxsize=8)
def _thrown(bursts: tuple[Burst, ...]) -> tuple[ThrownPiece[Arrays], NDArray[np.int64]]:
    """The pieces of some bursts at their beginning, and of which each is: the same until another burst comes."""
    parts = [_columns(burst) for burst in bursts]
    whose = np.repeat(np.arange(len(bursts)), [part.shape[1] for part in parts])
    return ThrownPiece[Arrays](*np.concatenate(parts, axis=1)), whose


@lru_cache(maxsize=64)
def _columns(burst: Burst) -> Arrays:
    """The pieces of a burst at their beginning, one a column."""
    return np.array(thrown(burst)).T
