"""The paths of a burst's pieces: they fly, slowed by drag and pulled down, bounce once, and shrink. Needs no numpy.

With drag k and gravity g, a piece that starts at p with velocity v, at height z and with upward speed u, is after t seconds at

    p + v (1 - e^(-k t)) / k        and the height    z + u t - g t^2 / 2,    after the bounce with a smaller upward speed.

The formulas of the flight take numbers or arrays: `game.maths`.
"""

import cmath
import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Generic, NamedTuple

from game.effects.bursts import Burst, Matter, lifetime
from game.maths import Maths, Values
from game.rules import TICK


class Throw(NamedTuple):
    """How pieces of one material fly; lengths in hundredths of the ground's radius, speeds in these per second.

    along: greatest speed in the burst's direction.
    apart: greatest speed in a random direction, added to it.
    up: greatest speed upwards.
    drag: of the air, per second.
    size: greatest half diagonal of a plate.
    """

    along: float
    apart: float
    up: float
    drag: float
    size: float


_THROWS = {
    Matter.BRICK: Throw(24.0, 52.0, 62.0, 2.2, 2.8),
    Matter.BALL: Throw(34.0, 95.0, 60.0, 2.6, 2.0),
    Matter.STEEL: Throw(26.0, 105.0, 55.0, 4.0, 1.6),
    Matter.PADDLE: Throw(22.0, 80.0, 30.0, 4.5, 1.4),
}
NUMBERS_OF_PIECES = {Matter.BRICK: 16, Matter.BALL: 20, Matter.STEEL: 14, Matter.PADDLE: 9}
CHANCES = 8
"""Number of random numbers for a piece."""
_GRAVITY = 150.0
"""Hundredths of the ground's radius per second, per second."""
_BOUNCE = 0.35
"""Share of its speed that a landing piece keeps."""
_HEIGHT = 4.5
"""Height of a bursting brick, in hundredths of the ground's radius: about a layer's."""
_SHRINKING = 0.55
"""From this share of its life on a piece grows smaller."""
_TUMBLING = 1.6
"""How much faster a piece turns about a horizontal axis than about the vertical."""
_BITS = (1 << 64) - 1
_STEP, _OF_SEED, _OF_NUMBER = 0x9E3779B97F4A7C15, 0xD1342543DE82EF95, 0x2545F4914F6CDD1D
_FIRST, _SECOND = 0xBF58476D1CE4E5B9, 0x94D049BB133111EB


class ThrownPiece(NamedTuple, Generic[Values]):
    """A piece at its beginning; lengths but those of its position in hundredths of the ground's radius.

    x, y: position, world units. velocity_x, velocity_y: along the ground, per second. drag: of the air, per second.
    height: above the ground. up: speed upwards, per second. size: half a plate's diagonal.
    turn, tumble: angles about the vertical and about a horizontal axis, radians; spin: radians per second.
    front, left, back, right: distances of a plate's corners from its middle, in half diagonals. life: seconds.
    """

    x: Values
    y: Values
    velocity_x: Values
    velocity_y: Values
    drag: Values
    height: Values
    up: Values
    size: Values
    turn: Values
    tumble: Values
    spin: Values
    front: Values
    left: Values
    back: Values
    right: Values
    life: Values


class FlyingPiece(NamedTuple, Generic[Values]):
    """A piece at a moment; lengths in world units.

    x, y: position on the ground, below the piece. height: above the ground.
    turn, tumble: angles about the vertical and about a horizontal axis, radians.
    size: half a plate's diagonal; 0 once the piece is gone. front, left, back, right: as of `ThrownPiece`, times the size.
    share: of its life that is over.
    """

    x: Values
    y: Values
    height: Values
    turn: Values
    tumble: Values
    size: Values
    front: Values
    left: Values
    back: Values
    right: Values
    share: Values


def thrown(burst: Burst) -> tuple[ThrownPiece[float], ...]:
    """All pieces of a burst at their beginning, whatever its age."""
    return _thrown(burst._replace(age=0))


@lru_cache(maxsize=64)
def _thrown(burst: Burst) -> tuple[ThrownPiece[float], ...]:
    """All pieces of a burst at their beginning."""
    return tuple([_piece(burst, chances(burst.seed, number)) for number in range(NUMBERS_OF_PIECES[burst.matter])])


def _piece(burst: Burst, chance: Sequence[float]) -> ThrownPiece[float]:
    """A piece of a burst at its beginning. chance: CHANCES numbers from -1 to 1."""
    throw, (radius, half_width, angle, half_angle) = _THROWS[burst.matter], burst.origin
    origin = cmath.rect(radius + half_width * chance[0], angle + half_angle * chance[1])
    along = burst.direction * (throw.along * (0.6 + 0.4 * chance[2]))
    velocity = along + cmath.rect(throw.apart * abs(chance[4]), math.pi * chance[3])
    front, left, back, right = [0.65 + 0.35 * math.cos(3.5 + 3.5 * chance[5] + 2.2 * corner) for corner in range(4)]
    return ThrownPiece(
        origin.real,
        origin.imag,
        velocity.real,
        velocity.imag,
        throw.drag,
        0.5 * _HEIGHT * (1.0 + chance[5]),
        throw.up * (0.65 + 0.35 * chance[6]),
        throw.size * (0.75 + 0.25 * chance[4]),
        math.pi * chance[2],
        math.pi * chance[3],
        14.0 * chance[1],
        front,
        left,
        back,
        right,
        lifetime(burst.matter) * TICK * (0.8 + 0.2 * chance[7]),
    )


def position(
    maths: Maths[Values], piece: ThrownPiece[Values], time: Values, ground_radius: float
) -> tuple[Values, Values, Values]:
    """Where a piece is some time after its beginning: x, y and height. time: seconds."""
    unit = 0.01 * ground_radius
    reach = -maths.expm1(-piece.drag * time) / piece.drag * unit  # distance over the first speed
    high = _height(maths, piece.height, piece.up, time) * unit
    return piece.x + piece.velocity_x * reach, piece.y + piece.velocity_y * reach, high


def flown(maths: Maths[Values], piece: ThrownPiece[Values], time: Values, ground_radius: float) -> FlyingPiece[Values]:
    """A piece some time after its beginning. time: seconds."""
    unit, share = 0.01 * ground_radius, time / piece.life
    size = piece.size * unit * maths.clip((1.0 - share) / (1.0 - _SHRINKING), 0.0, 1.0)
    return FlyingPiece(
        *position(maths, piece, time, ground_radius),
        piece.turn + piece.spin * time,
        piece.tumble + _TUMBLING * piece.spin * time,
        size,
        piece.front * size,
        piece.left * size,
        piece.back * size,
        piece.right * size,
        share,
    )


def _height(maths: Maths[Values], start: Values, up: Values, time: Values) -> Values:
    """Height above the ground; a piece that lands bounces once and then lies. start: its first height; up: its upward speed."""
    landing = (up + maths.sqrt(up * up + 2.0 * _GRAVITY * start)) / _GRAVITY
    again = _BOUNCE * (_GRAVITY * landing - up)
    before, later = maths.minimum(time, landing), maths.clip(time - landing, 0.0, math.inf)
    flying = maths.clip(start + (up - 0.5 * _GRAVITY * before) * before, 0.0, math.inf)
    return flying + maths.clip((again - 0.5 * _GRAVITY * later) * later, 0.0, math.inf)


def chances(seed: int, number: int) -> tuple[float, ...]:
    """CHANCES numbers from -1 to 1, a hash (SplitMix64) of the seed and the number of a piece."""
    found = []
    for row in range(1, CHANCES + 1):
        mixed = (seed * _OF_SEED + number * _OF_NUMBER + row * _STEP) & _BITS
        mixed = (mixed ^ mixed >> 30) * _FIRST & _BITS
        mixed = (mixed ^ mixed >> 27) * _SECOND & _BITS
        found.append((mixed >> 11) * 2.0**-52 - 1.0)
    return tuple(found)
