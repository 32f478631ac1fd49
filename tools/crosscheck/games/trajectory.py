"""A trajectory: what the game did, tick by tick, and the straight legs its balls flew."""

from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import NamedTuple

from physics import Arena, Hit, Step
from tools.crosscheck.games.level_numbers import LevelNumbers

Advance = Callable[..., Step]
"""`physics.advance`, or a sabotaged copy of it: called with an arena, seconds, and the balls' speed."""

_PATH_NOISE = 2.0**-50
"""Fraction of a coordinate: positions rebuilt from the hits agree with the recorded ones to a few roundings."""


class Answer(NamedTuple):
    """What the arcade rules made of a ball that a paddle returned.

    velocity: the ball's at the tick's end, after the rules. aimed: whether they aimed it at a brick as well.
    """

    hit: Hit
    velocity: complex
    aimed: bool


class Tick(NamedTuple):
    """One tick: the arena that the physics advanced, and what became of it.

    dt: seconds. level: what was known before the game; another object whenever a level starts anew. answers: of the arcade
    rules, to hits of paddles.
    """

    number: int
    arena: Arena
    dt: float
    step: Step
    level: LevelNumbers
    answers: tuple[Answer, ...] = ()


class Leg(NamedTuple):
    """One straight flight of one ball within a tick.

    start, stop: seconds after the tick's start. position: of the centre at `start`. hit: what ended it; None at the tick's end.
    """

    ball: int
    start: float
    position: complex
    velocity: complex
    stop: float
    hit: Hit | None

    @property
    def end(self) -> complex:
        """The ball's centre at the leg's stop."""
        return self.position + self.velocity * (self.stop - self.start)

    def without(self, seconds: float) -> "Leg":
        """What is left of the leg from some moment of the tick on."""
        return self._replace(start=seconds, position=self.position + self.velocity * (seconds - self.start))


class FlightPath(NamedTuple):
    """The flight of one ball through one tick.

    legs: those that end with a hit, then the last. fits: whether they lead from the recorded start to the recorded end.
    freed: the position from which they lead there, where the physics has put the ball elsewhere before its flight. dropped:
    whether the ball used up its bounces and rested for what was left of the tick. freed_after: whether it was then put
    elsewhere.
    """

    legs: tuple[Leg, ...]
    fits: bool
    freed: complex | None = None
    dropped: bool = False
    freed_after: bool = False


def one_bounce(hit: Hit, other: Hit) -> bool:
    """Whether two hits are one bounce off two sectors at once."""
    return (hit.ball, hit.time, hit.before, hit.after) == (other.ball, other.time, other.before, other.after)


def flight_paths(tick: Tick, most_bounces: int) -> Iterator[FlightPath]:
    """The flight of every ball, rebuilt from its start, its hits' times and velocities, and nothing else.

    No hit's normal or point enters: the position of a contact follows from the flight. most_bounces: after which a ball rests
    until the tick's end. A ball that the physics put outside material first is followed from its end backwards.
    """
    hits: dict[int, list[Hit]] = {}
    for hit in tick.step.hits:
        hits.setdefault(hit.ball, []).append(hit)
    for index, (ball, end) in enumerate(zip(tick.arena.balls, tick.step.arena.balls, strict=True)):
        own = hits.get(index, [])
        bounces = len(own) - sum([one_bounce(hit, later) for hit, later in pairwise(own)])
        dropped = bounces >= most_bounces
        path = _followed(tick, index, own, ball.position, dropped=dropped)
        if not path.fits and tick.step.freed:
            start = _backwards(tick, own, end.position, end.velocity, dropped=dropped)
            back = _followed(tick, index, own, start, dropped=dropped)
            if back.fits:
                path = back._replace(freed=start)
        yield path


def _followed(tick: Tick, index: int, hits: list[Hit], start: complex, *, dropped: bool) -> FlightPath:
    """A ball's flight from a position."""
    ball, end = tick.arena.balls[index], tick.step.arena.balls[index]
    position, velocity, clock, fits = start, ball.velocity, 0.0, True
    legs: list[Leg] = []
    for hit in hits:
        last_hit = legs[-1].hit if legs else None
        if last_hit is not None and one_bounce(last_hit, hit):
            legs.append(Leg(index, clock, position, hit.before, clock, hit))
            continue
        fits = fits and hit.before == velocity and clock <= hit.time <= tick.dt
        leg = Leg(index, clock, position, velocity, hit.time, hit)
        legs.append(leg)
        position, velocity, clock = leg.end, hit.after, hit.time
    last = Leg(index, clock, position, velocity, clock if dropped else tick.dt, None)
    legs.append(last)
    size = abs(last.end) + abs(velocity) * tick.dt
    arrives = abs(last.end - end.position) <= size * _PATH_NOISE
    freed_after = dropped and not arrives and tick.step.freed > 0
    fits = fits and velocity == end.velocity and (arrives or freed_after)
    return FlightPath(tuple(legs), fits, None, dropped, freed_after)


def _backwards(tick: Tick, hits: list[Hit], position: complex, velocity: complex, *, dropped: bool) -> complex:
    """The position from which a ball's hits lead to its end."""
    clock = hits[-1].time if dropped else tick.dt
    for hit in reversed(hits):
        position -= velocity * (clock - hit.time)  # no time lies between two hits that are one bounce
        velocity, clock = hit.before, hit.time
    return position - velocity * clock
