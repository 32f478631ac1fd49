"""What can be dragged: a place in the world, and the values that a drag of it to another place asks for."""

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from game.lab.kit.parameters import Given, Parameter, Settled, settled, snapped

_HALF_TURN = 180.0


class Handle(NamedTuple):
    """Something to take hold of."""

    label: str
    place: Callable[[Given], complex]  # world
    wishes: Callable[[Given, complex], Mapping[str, complex]]  # the values asked for by a drag to a place of the world
    reach: Callable[[Given], float] | None = None  # world units around its place that it can be taken hold of, too


def dragged(parameters: Sequence[Parameter], given: Given, handle: Handle, place: complex) -> Settled:
    """The values after a handle was dragged to a place: rounded to their steps, kept in their ranges."""
    return settled(parameters, given, snapped(parameters, handle.wishes(given, place)))


def point(name: str, label: str, radius: str | None = None) -> Handle:
    """A point parameter itself. radius: the number that is the radius of the ball there, all of which can be taken hold of."""
    reach = None if radius is None else lambda given: given.number(radius)
    return Handle(label, lambda given: given.point(name), lambda _given, place: {name: place}, reach)


def vector(name: str, start: Callable[[Given], complex], scale: float, label: str) -> Handle:
    """The tip of a vector drawn at `start`. scale: world units drawn per unit of the vector."""
    return Handle(
        label,
        lambda given: start(given) + given.point(name) * scale,
        lambda given, place: {name: (place - start(given)) / scale},
    )


def polar_vector(length: str, angle: str, start: Callable[[Given], complex], scale: float, label: str) -> Handle:
    """The tip of a vector given by its length and its angle in degrees."""
    return Handle(
        label,
        lambda given: start(given) + cmath.rect(given.number(length) * scale, given.angle(angle)),
        lambda given, place: _length_and_angle(length, angle, given, (place - start(given)) / scale),
    )


def on_circle(angle: str, radius: Callable[[Given], float], label: str) -> Handle:
    """An angle in degrees, taken hold of on a circle around the origin."""
    return Handle(
        label,
        lambda given: cmath.rect(radius(given), given.angle(angle)),
        lambda given, place: {angle: _degrees(place, given.number(angle))},
    )


def half_angle(name: str, angle: str, radius: Callable[[Given], float], side: float) -> Handle:
    """A sector's half angle, taken hold of at an end. side: 1 the counter-clockwise one, -1 the other."""

    def wishes(given: Given, place: complex) -> dict[str, complex]:
        away = math.degrees(cmath.phase(place * cmath.rect(1.0, -given.angle(angle)))) * side if place else 0.0
        wide = given.number(name) > _HALF_TURN / 2.0
        return {name: away + 2.0 * _HALF_TURN if wide and away < -_HALF_TURN / 2.0 else away}

    return Handle(
        "end: half angle",
        lambda given: cmath.rect(radius(given), given.angle(angle) + side * given.angle(name)),
        wishes,
    )


def sector_handles(radius: str, half_width: str, angle: str, half: str) -> tuple[Handle, ...]:
    """A sector's middle (its radius and angle), its two ends (its half angle) and its outer face (its half width)."""

    def at(given: Given, out: float) -> float:
        return given.number(radius) + out * given.number(half_width)

    return (
        Handle(
            "sector: radius and angle",
            lambda given: cmath.rect(at(given, 0.0), given.angle(angle)),
            lambda given, place: {radius: abs(place), angle: _degrees(place, given.number(angle))},
        ),
        half_angle(half, angle, lambda given: at(given, 0.6), 1.0),
        half_angle(half, angle, lambda given: at(given, 0.6), -1.0),
        Handle(
            "outer face: half width",
            lambda given: cmath.rect(at(given, 1.0), given.angle(angle)),
            lambda given, place: {half_width: abs(place) - given.number(radius)},
        ),
    )


def _length_and_angle(length: str, angle: str, given: Given, way: complex) -> dict[str, complex]:
    """Polar coordinates of a vector; the angle of none is the one before."""
    return {length: abs(way), angle: _degrees(way, given.number(angle))}


def _degrees(place: complex, before: float) -> float:
    """The angle of a place in [0, 360); that before for the origin, which has none."""
    return math.degrees(cmath.phase(place)) % 360.0 if place else before
