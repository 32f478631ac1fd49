"""What can be dragged: a position in the world, and the values that a drag of it to another point asks for."""

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from game.lab.kit.parameters import Clamped, Given, Parameter, clamped, snapped

_HALF_TURN = 180.0


class Handle(NamedTuple):
    """Something that can be dragged.

    label: what a drag changes, in a few words.
    position: where it is, world units.
    values_at: the values that put it at a point of the world.
    reach: world units around its position within which it can be taken hold of, too; None for the drawn ring alone.
    step: of a reveal, from which on it is there: that which draws what it moves.
    """

    label: str
    position: Callable[[Given], complex]
    values_at: Callable[[Given, complex], Mapping[str, complex]]
    reach: Callable[[Given], float] | None = None
    step: int = 1


def dragged(parameters: Sequence[Parameter], given: Given, handle: Handle, target: complex) -> Clamped:
    """The values after a handle was dragged to a point of the world: rounded to their steps, inside their ranges."""
    return clamped(parameters, given, snapped(parameters, handle.values_at(given, target)))


def point(name: str, label: str, radius: str | None = None) -> Handle:
    """A point parameter itself. radius: the number that is the radius of the ball there, all of which can be dragged."""
    reach = None if radius is None else lambda given: given.number(radius)
    return Handle(label, lambda given: given.point(name), lambda _given, target: {name: target}, reach)


def vector(name: str, start: Callable[[Given], complex], scale: float, label: str) -> Handle:
    """The tip of a vector drawn from `start`. scale: world units drawn per unit of the vector."""
    return Handle(
        label,
        lambda given: start(given) + given.point(name) * scale,
        lambda given, target: {name: (target - start(given)) / scale},
    )


def polar_vector(length: str, angle: str, start: Callable[[Given], complex], scale: float, label: str) -> Handle:
    """The tip of a vector given by its length and its angle in degrees. start, scale: as of `vector`."""
    return Handle(
        label,
        lambda given: start(given) + cmath.rect(given.number(length) * scale, given.angle(angle)),
        lambda given, target: _length_and_angle(length, angle, given, (target - start(given)) / scale),
    )


def on_circle(angle: str, radius: Callable[[Given], float], label: str) -> Handle:
    """An angle in degrees, dragged along a circle around the origin."""
    return Handle(
        label,
        lambda given: cmath.rect(radius(given), given.angle(angle)),
        lambda given, target: {angle: _degrees(target, given.number(angle))},
    )


def half_angle(name: str, angle: str, radius: Callable[[Given], float], side: float) -> Handle:
    """A sector's half angle, dragged at an end. side: 1 the counter-clockwise end, -1 the other."""

    def values_at(given: Given, target: complex) -> dict[str, complex]:
        offset = math.degrees(cmath.phase(target * cmath.rect(1.0, -given.angle(angle)))) * side if target else 0.0
        wide = given.number(name) > _HALF_TURN / 2.0
        return {name: offset + 2.0 * _HALF_TURN if wide and offset < -_HALF_TURN / 2.0 else offset}

    return Handle(
        "end: half angle",
        lambda given: cmath.rect(radius(given), given.angle(angle) + side * given.angle(name)),
        values_at,
    )


def sector_handles(radius: str, half_width: str, angle: str, half: str) -> tuple[Handle, ...]:
    """A sector's middle (its radius and angle), its two ends (its half angle) and its outer face (its half width)."""

    def radius_at(given: Given, share: float) -> float:
        """The radius at a share of the half width outwards from the middle."""
        return given.number(radius) + share * given.number(half_width)

    return (
        Handle(
            "sector: radius and angle",
            lambda given: cmath.rect(given.number(radius), given.angle(angle)),
            lambda given, target: {radius: abs(target), angle: _degrees(target, given.number(angle))},
        ),
        half_angle(half, angle, lambda given: radius_at(given, 0.6), 1.0),
        half_angle(half, angle, lambda given: radius_at(given, 0.6), -1.0),
        Handle(
            "outer face: half width",
            lambda given: cmath.rect(radius_at(given, 1.0), given.angle(angle)),
            lambda given, target: {half_width: abs(target) - given.number(radius)},
        ),
    )


def _length_and_angle(length: str, angle: str, given: Given, tip: complex) -> dict[str, complex]:
    """Polar coordinates of a vector; the vector 0, which has no angle, leaves the angle as it was."""
    return {length: abs(tip), angle: _degrees(tip, given.number(angle))}


def _degrees(target: complex, before: float) -> float:
    """The angle of a point in [0, 360); for the origin, which has none, the angle before."""
    return math.degrees(cmath.phase(target)) % 360.0 if target else before
