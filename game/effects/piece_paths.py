"""The paths of a burst's pieces: they fly, slowed by drag and pulled down, bounce once, and shrink. Needs no numpy.

With drag k and gravity g, a piece that starts at p with velocity v, at height z and with upward speed u, is after t seconds at

    p + v (1 - e^(-k t)) / k        and the height    z + u t - g t^2 / 2,    after the bounce with a smaller upward speed.

The formulas take numbers or arrays: `game.maths`.
"""

import math
from collections.abc import Sequence
from typing import Generic, NamedTuple

from game.effects.bursts import Matter
from game.maths import Maths, Values


class Throw(NamedTuple, Generic[Values]):
    """How pieces of one material fly; lengths in hundredths of the ground's radius, speeds in these per second.

    along: greatest speed in the burst's direction.
    apart: greatest speed in a random direction, added to it.
    up: greatest speed upwards.
    drag: of the air, per second.
    size: greatest half diagonal of a plate.
    """

    along: Values
    apart: Values
    up: Values
    drag: Values
    size: Values


THROWS = {
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
_BITS = (1 << 64) - 1
_STEP, _OF_SEED, _OF_NUMBER = 0x9E3779B97F4A7C15, 0xD1342543DE82EF95, 0x2545F4914F6CDD1D
_FIRST, _SECOND = 0xBF58476D1CE4E5B9, 0x94D049BB133111EB


class Scattered(NamedTuple, Generic[Values]):
    """A piece at its beginning; lengths in hundredths of the ground's radius.

    out, aside: position in the sector, in half widths and in half angles from its middle.
    along: speed in the burst's direction. apart: speed that is added in the direction of apart_angle, radians.
    height: above the ground. up: speed upwards. size: half a plate's diagonal.
    turn, tumble: angles about the vertical and about a horizontal axis, radians; spin: radians per second.
    shape: a number from 0 to 1 that decides the shape of a plate. life: as a share of the burst's.
    """

    out: Values
    aside: Values
    along: Values
    apart: Values
    apart_angle: Values
    height: Values
    up: Values
    size: Values
    turn: Values
    tumble: Values
    spin: Values
    shape: Values
    life: Values


def scattered(throw: Throw[Values], chance: Sequence[Values]) -> Scattered[Values]:
    """A piece at its beginning. chance: CHANCES numbers from -1 to 1."""
    return Scattered(
        chance[0],
        chance[1],
        throw.along * (0.6 + 0.4 * chance[2]),
        throw.apart * abs(chance[4]),
        math.pi * chance[3],
        0.5 * _HEIGHT * (1.0 + chance[5]),
        throw.up * (0.65 + 0.35 * chance[6]),
        throw.size * (0.75 + 0.25 * chance[4]),
        math.pi * chance[2],
        math.pi * chance[3],
        14.0 * chance[1],
        0.5 + 0.5 * chance[5],
        0.8 + 0.2 * chance[7],
    )


def reach(maths: Maths[Values], drag: Values, time: Values) -> Values:
    """Distance that a piece has flown, divided by its first speed. time: seconds."""
    return -maths.expm1(-drag * time) / drag


def height(maths: Maths[Values], start: Values, up: Values, time: Values) -> Values:
    """Height above the ground; a piece that lands bounces once and then lies. start: its first height; up: its upward speed."""
    landing = (up + maths.sqrt(up * up + 2.0 * _GRAVITY * start)) / _GRAVITY
    again = _BOUNCE * (_GRAVITY * landing - up)
    before, later = maths.minimum(time, landing), maths.clip(time - landing, 0.0, math.inf)
    flying = maths.clip(start + (up - 0.5 * _GRAVITY * before) * before, 0.0, math.inf)
    return flying + maths.clip((again - 0.5 * _GRAVITY * later) * later, 0.0, math.inf)


def shrunk(maths: Maths[Values], share: Values) -> Values:
    """Size of a piece as a share of its first size. share: of its life that is over."""
    return maths.clip((1.0 - share) / (1.0 - _SHRINKING), 0.0, 1.0)


def tumbled(piece_tumble: Values, spin: Values, time: Values) -> Values:
    """The angle of a piece about a horizontal axis after some time."""
    return piece_tumble + 1.6 * spin * time


def chances(seed: int, number: int) -> tuple[float, ...]:
    """CHANCES numbers from -1 to 1, a hash (SplitMix64) of the seed and the number of a piece."""
    found = []
    for row in range(1, CHANCES + 1):
        mixed = (seed * _OF_SEED + number * _OF_NUMBER + row * _STEP) & _BITS
        mixed = (mixed ^ mixed >> 30) * _FIRST & _BITS
        mixed = (mixed ^ mixed >> 27) * _SECOND & _BITS
        found.append((mixed >> 11) * 2.0**-52 - 1.0)
    return tuple(found)
