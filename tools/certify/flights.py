"""The straight flights of a tick, rebuilt from its start, its hits' times and velocities, and nothing else."""

from collections.abc import Iterator
from typing import NamedTuple

from physics import Arena, Ball, Hit, Step, advance

_NO_TIME = 5e-324
"""Seconds: the shortest tick there is. It moves no ball, but frees those that overlap."""


class ClaimedTick(NamedTuple):
    """One tick: the arena that the physics advanced, and what it says became of it.

    number: counted from 0 within its game or arena. dt: seconds. speed: of every ball after a bounce.
    """

    number: int
    arena: Arena
    dt: float
    speed: float
    step: Step


class StraightFlight(NamedTuple):
    """One straight flight of one ball within a tick: from its start or a bounce to the next bounce or the tick's end.

    position, velocity: of the ball at `start`; with them and the radius as exact numbers a proof begins. start, stop:
    seconds after the tick's start. hit: the bounce that ends it, None at the tick's end. layers: per ring and slot,
    the bricks there at `start`. gone: when a sector vanishes during the flight, hit by another ball.
    """

    ball: int
    position: complex
    velocity: complex
    radius: float
    start: float
    stop: float
    hit: Hit | None
    layers: tuple[tuple[int, ...], ...]
    gone: dict[tuple[int, int], float]

    def end(self) -> complex:
        """The centre at `stop`, in floats."""
        return self.position + self.velocity * (self.stop - self.start)


class _FlightStart(NamedTuple):
    """Where a flight begins."""

    position: complex
    velocity: complex
    time: float
    hits_before: int


def flights_of(tick: ClaimedTick) -> Iterator[StraightFlight]:
    """Every flight of every ball, in the order of their ends.

    A ball that used up its impacts rests for what is left of the tick: its last flight ends with its last hit.
    """
    hits = tick.step.hits
    layers = _layers_after_each_hit(tick)
    begun = [_FlightStart(ball.position, ball.velocity, 0.0, 0) for ball in starts(tick)]

    def flight(index: int, stop: float, hit: Hit | None, hits_after: int) -> StraightFlight:
        start = begun[index]
        radius = tick.arena.balls[index].radius
        between = hits[start.hits_before : hits_after]
        gone = {(other.ring, other.slot): other.time for other in between if other.layers == 0}
        return StraightFlight(
            index, start.position, start.velocity, radius, start.time, stop, hit, layers[start.hits_before], gone
        )

    for number, hit in enumerate(hits):
        done = flight(hit.ball, hit.time, hit, number)
        yield done
        begun[hit.ball] = _FlightStart(done.end(), hit.after, hit.time, number + 1)
    resting = _resting(tick)
    for index in range(len(begun)):
        if index not in resting:
            yield flight(index, tick.dt, None, len(hits))


def starts(tick: ClaimedTick) -> tuple[Ball, ...]:
    """The balls as their flights begin: those that overlapped are where the physics puts them before anything moves."""
    balls = tick.arena.balls
    if not tick.step.freed:
        return balls
    freed = advance(tick.arena, _NO_TIME, tick.speed).arena.balls
    return tuple([ball._replace(position=moved.position) for ball, moved in zip(balls, freed, strict=True)])


def _layers_after_each_hit(tick: ClaimedTick) -> list[tuple[tuple[int, ...], ...]]:
    """The layers of every ring at the tick's start, and after each hit."""
    layers = [tick.arena.layers]
    for hit in tick.step.hits:
        rows = list(layers[-1])
        row = rows[hit.ring]
        rows[hit.ring] = (*row[: hit.slot], hit.layers, *row[hit.slot + 1 :])
        layers.append(tuple(rows))
    return layers


def _resting(tick: ClaimedTick) -> set[int]:
    """The balls that used up their impacts: as many as the physics says, those with the most hits."""
    counts = [sum([hit.ball == index for hit in tick.step.hits]) for index in range(len(tick.arena.balls))]
    return set(sorted(range(len(counts)), key=lambda index: -counts[index])[: tick.step.dropped])
