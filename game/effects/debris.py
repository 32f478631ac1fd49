"""The pieces of many bursts at once, in arrays: `game.effects.piece_paths` has the formulas."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.array_maths import ARRAYS, Arrays
from game.effects.bursts import Burst, lifetime
from game.effects.piece_paths import (
    NUMBERS_OF_PIECES,
    THROWS,
    Scattered,
    Throw,
    height,
    reach,
    scattered,
    shrunk,
    tumbled,
)
from game.rules import TICK

Reals = NDArray[np.float64]
Points = NDArray[np.complex128]


class Pieces(NamedTuple):
    """Every piece of some bursts, one a row; lengths in world units.

    position: on the ground, below the piece.
    height: above the ground.
    size: half a plate's diagonal; 0 once the piece is gone.
    turn: angle about the vertical, radians.
    tumble: angle about a horizontal axis, radians.
    shape: a number from 0 to 1 that tells how uneven a plate is.
    share: of its life that is over, 0 to 1.
    burst: index of the burst that it is of.
    """

    position: Points
    height: Reals
    size: Reals
    turn: Reals
    tumble: Reals
    shape: Reals
    share: Reals
    burst: NDArray[np.int64]


def pieces(bursts: Sequence[Burst], ground_radius: float) -> Pieces:
    """All pieces of some bursts."""
    start = _thrown(tuple([burst._replace(age=0) for burst in bursts]))
    time = np.array([burst.age * TICK for burst in bursts])[start.burst]
    unit = 0.01 * ground_radius
    share, piece = time / start.life, start.piece
    return Pieces(
        start.position + start.velocity * unit * reach(ARRAYS, start.drag, time),
        _reals(height(ARRAYS, piece.height, piece.up, time) * unit),
        _reals(piece.size * unit * shrunk(ARRAYS, share)),
        _reals(piece.turn + piece.spin * time),
        _reals(tumbled(piece.tumble, piece.spin, time)),
        _reals(piece.shape),
        share,
        start.burst,
    )


def _reals(values: Arrays) -> Reals:
    """The same numbers, typed as the 64-bit floats that they are."""
    return np.asarray(values, dtype=np.float64)


class _Thrown(NamedTuple):
    """Every piece of some bursts at its beginning, one a row.

    position: world units. velocity: along the ground, hundredths of the ground's radius per second.
    drag: of the air, per second. life: seconds. burst: as in `Pieces`.
    """

    position: Points
    velocity: Points
    drag: Reals
    life: Reals
    piece: Scattered[Arrays]
    burst: NDArray[np.int64]


@lru_cache(maxsize=8)
def _thrown(bursts: tuple[Burst, ...]) -> _Thrown:
    """The pieces of some bursts at their beginning: the same from frame to frame until another burst comes."""
    counts = [NUMBERS_OF_PIECES[burst.matter] for burst in bursts]
    whose = np.repeat(np.arange(len(bursts)), counts)
    number = np.concatenate([np.arange(count, dtype=np.uint64) for count in counts])  # of a piece in its burst
    chance = _chances(np.array([burst.seed for burst in bursts], dtype=np.uint64)[whose], number)
    radius, half_width, angle, half_angle = np.array([burst.origin for burst in bursts])[whose].T
    throw = Throw[Arrays](*np.array([THROWS[burst.matter] for burst in bursts])[whose].T)
    direction = np.array([burst.direction for burst in bursts], dtype=np.complex128)[whose]
    piece = scattered(throw, list(chance))
    return _Thrown(
        (radius + half_width * piece.out) * np.exp(1j * (angle + half_angle * piece.aside)),
        direction * piece.along + np.exp(1j * piece.apart_angle) * piece.apart,
        np.asarray(throw.drag),
        np.array([lifetime(burst.matter) * TICK for burst in bursts])[whose] * piece.life,
        piece,
        whose,
    )


def _chances(seeds: NDArray[np.uint64], numbers: NDArray[np.uint64]) -> Reals:
    """Eight rows of numbers from -1 to 1, the same for the same seeds and numbers: the mixing steps of SplitMix64."""
    row = np.arange(1, 9, dtype=np.uint64)[:, None] * np.uint64(0x9E3779B97F4A7C15)
    mixed = seeds * np.uint64(0xD1342543DE82EF95) + numbers * np.uint64(0x2545F4914F6CDD1D) + row
    mixed = (mixed ^ (mixed >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    mixed = (mixed ^ (mixed >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return np.asarray((mixed >> np.uint64(11)).astype(np.float64) * 2.0**-52 - 1.0)
