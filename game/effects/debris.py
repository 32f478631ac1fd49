"""The pieces of a burst: thrown, slowed by the air, pulled down, bounced once, and at last too small to see.

With k the air's drag and g the gravity, a piece thrown from p with velocity v is, after t seconds, over

    p + v (1 - e^(-k t)) / k        at the height    z + u t - g t^2 / 2,    mirrored and damped below the ground.
"""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.effects.bursts import Burst, Matter, lifetime
from game.rules import TICK

Reals = NDArray[np.float64]
Points = NDArray[np.complex128]


class Throw(NamedTuple):
    """How pieces of one matter fly; lengths in hundredths of the ground's radius, speeds in those per second.

    number: of pieces.
    along: speed in the burst's direction, at most.
    apart: speed in any direction that is added to it, at most.
    up: speed upwards, at most.
    drag: of the air, per second.
    size: half a plate's diagonal, at most.
    """

    number: int
    along: float
    apart: float
    up: float
    drag: float
    size: float


THROWS = {
    Matter.BRICK: Throw(16, 24.0, 52.0, 62.0, 2.2, 2.8),
    Matter.BALL: Throw(20, 34.0, 95.0, 60.0, 2.6, 2.0),
    Matter.STEEL: Throw(14, 26.0, 105.0, 55.0, 4.0, 1.6),
    Matter.PADDLE: Throw(9, 22.0, 80.0, 30.0, 4.5, 1.4),
}
_GRAVITY = 150.0
"""Hundredths of the ground's radius per second, per second."""
_BOUNCE = 0.35
"""Share of its speed that a landing piece keeps."""
_HEIGHT = 4.5
"""Height of what bursts, in hundredths of the ground's radius: about a layer's."""
_SHRINKING = 0.55
"""From this share of its life on a piece grows smaller."""


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
    share = time / start.life
    shrunk = np.clip((1.0 - share) / (1.0 - _SHRINKING), 0.0, 1.0)
    return Pieces(
        start.position + start.velocity * unit * (-np.expm1(-start.drag * time) / start.drag),
        _height(start.height, start.up, time) * unit,
        start.size * unit * shrunk,
        start.turn + start.spin * time,
        start.tumble + 1.6 * start.spin * time,
        start.shape,
        share,
        start.burst,
    )


class _Thrown(NamedTuple):
    """Every piece of some bursts as it begins, one a row; lengths but the position in hundredths of the ground's radius.

    position, height, size, turn, tumble, shape, burst: as in `Pieces`.
    velocity: along the ground, per second.
    up: speed upwards, per second.
    drag: of the air, per second.
    spin: radians per second.
    life: seconds.
    """

    position: Points
    velocity: Points
    drag: Reals
    height: Reals
    up: Reals
    size: Reals
    turn: Reals
    tumble: Reals
    spin: Reals
    shape: Reals
    life: Reals
    burst: NDArray[np.int64]


@lru_cache(maxsize=8)
def _thrown(bursts: tuple[Burst, ...]) -> _Thrown:
    """The pieces of some bursts at their beginning: the same from frame to frame until another burst comes."""
    throws = [THROWS[burst.matter] for burst in bursts]
    counts = [throw.number for throw in throws]
    whose = np.repeat(np.arange(len(bursts)), counts)
    number = np.concatenate([np.arange(count, dtype=np.uint64) for count in counts])  # of a piece in its burst
    chance = _chances(np.array([burst.seed for burst in bursts], dtype=np.uint64)[whose], number)
    radius, half_width, angle, half_angle = np.array([burst.origin for burst in bursts])[whose].T
    along, apart, up, drag, size = np.array([throw[1:] for throw in throws])[whose].T
    direction = np.array([burst.direction for burst in bursts], dtype=np.complex128)[whose]
    return _Thrown(
        (radius + half_width * chance[0]) * np.exp(1j * (angle + half_angle * chance[1])),
        direction * along * (0.6 + 0.4 * chance[2]) + np.exp(1j * np.pi * chance[3]) * apart * np.abs(chance[4]),
        drag,
        0.5 * _HEIGHT * (1.0 + chance[5]),
        up * (0.65 + 0.35 * chance[6]),
        size * (0.75 + 0.25 * chance[4]),
        np.pi * chance[2],
        np.pi * chance[3],
        14.0 * chance[1],
        0.5 + 0.5 * chance[5],
        np.array([lifetime(burst.matter) * TICK for burst in bursts])[whose] * (0.8 + 0.2 * chance[7]),
        whose,
    )


def _height(start: Reals, up: Reals, time: Reals) -> Reals:
    """Height above the ground; a piece that comes down bounces once and then lies."""
    landing = (up + np.sqrt(up * up + 2.0 * _GRAVITY * start)) / _GRAVITY
    again = _BOUNCE * (_GRAVITY * landing - up)
    later = time - landing
    flying = start + (up - 0.5 * _GRAVITY * time) * time
    bounced = np.maximum((again - 0.5 * _GRAVITY * later) * later, 0.0)
    return np.asarray(np.where(later < 0.0, np.maximum(flying, 0.0), bounced))


def _chances(seeds: NDArray[np.uint64], numbers: NDArray[np.uint64]) -> Reals:
    """Eight rows of numbers from -1 to 1, the same for the same seeds and numbers: the mixing steps of SplitMix64."""
    row = np.arange(1, 9, dtype=np.uint64)[:, None] * np.uint64(0x9E3779B97F4A7C15)
    mixed = seeds * np.uint64(0xD1342543DE82EF95) + numbers * np.uint64(0x2545F4914F6CDD1D) + row
    mixed = (mixed ^ (mixed >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    mixed = (mixed ^ (mixed >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return np.asarray((mixed >> np.uint64(11)).astype(np.float64) * 2.0**-52 - 1.0)
