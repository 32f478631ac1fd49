"""A trajectory: what the game did, tick by tick, and the straight legs its balls flew."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

from physics import Arena, Hit, Step

Advance = Callable[[Arena, float, float], Step]
"""`physics.advance`, or a sabotaged copy of it."""

_PATH_NOISE = 2.0**-50
"""Fraction of a coordinate: places rebuilt from the hits agree with the recorded ones to a few roundings."""


class Tick(NamedTuple):
    """One tick: the arena that the physics advanced, and what became of it."""

    number: int
    arena: Arena
    dt: float
    speed: float
    step: Step


class Leg(NamedTuple):
    """One straight flight of one ball within a tick."""

    ball: int
    start: float  # seconds after the tick's start
    position: complex  # at `start`
    velocity: complex
    stop: float
    hit: Hit | None  # what ended it; None at the tick's end

    @property
    def end(self) -> complex:
        """The ball's centre at the leg's stop."""
        return self.position + self.velocity * (self.stop - self.start)


class Path(NamedTuple):
    """The flight of one ball through one tick."""

    legs: tuple[Leg, ...]
    fits: bool  # whether the legs lead from the recorded start to the recorded end


def paths(tick: Tick) -> Iterator[Path]:
    """The flight of every ball, rebuilt from its start, its hits' times and velocities, and nothing else.

    No hit's normal or point enters: the place of a contact follows from the flight.
    """
    hits: dict[int, list[Hit]] = {}
    for hit in tick.step.hits:
        hits.setdefault(hit.ball, []).append(hit)
    for index, (ball, end) in enumerate(zip(tick.arena.balls, tick.step.arena.balls, strict=True)):
        position, velocity, clock, fits = ball.position, ball.velocity, 0.0, True
        legs = []
        for hit in hits.get(index, ()):
            fits = fits and hit.before == velocity
            leg = Leg(index, clock, position, velocity, hit.time, hit)
            legs.append(leg)
            position, velocity, clock = leg.end, hit.after, hit.time
        last = Leg(index, clock, position, velocity, tick.dt, None)
        legs.append(last)
        size = abs(last.end) + abs(velocity) * tick.dt
        fits = fits and velocity == end.velocity and abs(last.end - end.position) <= size * _PATH_NOISE
        yield Path(tuple(legs), fits)


def layers_before(tick: Tick, hit: Hit | None) -> tuple[tuple[int, ...], ...]:
    """The layers of every ring just before a hit of the tick, or at the tick's end: what the hits until then have left."""
    if hit is None:
        return tick.step.arena.layers
    layers = list(tick.arena.layers)
    for earlier in tick.step.hits:
        if earlier is hit:
            break
        ring = layers[earlier.ring]
        layers[earlier.ring] = (*ring[: earlier.slot], earlier.layers, *ring[earlier.slot + 1 :])
    return tuple(layers)
