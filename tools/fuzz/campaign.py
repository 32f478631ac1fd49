"""A campaign: cases by the number, the tally of what happened in them, and the smallest arena that fails."""

from collections.abc import Iterator
from contextlib import closing
from typing import NamedTuple

from physics import Arena, FreeFlight, Step, advance
from tools.executor import Where, results, sure
from tools.fuzz.arenas import TICK, TICKS, random_case, steered, with_lost_balls_back
from tools.fuzz.checks import first_fault

SPARED = "a tick that was spared the search went another way than with it"
"""A fault that the tick alone does not show: it needs the one before."""

_CASES_PER_JOB = 10


class Failure(NamedTuple):
    """A tick that broke a promise."""

    seed: int
    number: int
    tick: int
    what: str
    arena: Arena  # at the start of that tick
    speed: float


class Tally(NamedTuple):
    """What happened in a number of cases."""

    cases: int = 0
    steps: int = 0  # ticks, each counted once for every ball
    hits: int = 0
    dropped: int = 0
    freed: int = 0
    failures: tuple[Failure, ...] = ()

    def plus(self, other: "Tally") -> "Tally":
        """Both together."""
        return Tally(
            self.cases + other.cases,
            self.steps + other.steps,
            self.hits + other.hits,
            self.dropped + other.dropped,
            self.freed + other.freed,
            self.failures + other.failures,
        )


def play(seed: int, index: int, ticks: int = TICKS) -> Tally:
    """One case, up to its first fault."""
    arena, speed, chance = random_case(seed, index)
    tally = Tally(cases=1)
    flight: FreeFlight | None = None
    for tick in range(ticks):
        what, step = checked_tick(arena, speed, flight)
        tally = tally.plus(Tally(0, len(arena.balls), len(step.hits), step.dropped, step.freed))
        if what is not None:
            return tally._replace(failures=(Failure(seed, index, tick, what, arena, speed),))
        arena, flight = steered(with_lost_balls_back(step.arena, speed, chance), speed, chance), step.flight
    return tally


def checked_tick(arena: Arena, speed: float, flight: FreeFlight | None = None) -> tuple[str | None, Step]:
    """What is wrong with the next tick, and the tick. flight: of the one before."""
    try:
        step = advance(arena, TICK, speed, flight)
        if flight is not None and step[:4] != advance(arena, TICK, speed)[:4]:
            return SPARED, step
    except Exception as error:  # noqa: BLE001  # whatever it is, it is a fault of the tick
        return f"{type(error).__name__}: {error}", Step(arena, (), 0, 0)
    return first_fault(arena, step, TICK, speed), step


def tallies(seed: int, steps: int, workers: Where) -> Iterator[Tally]:
    """Tallies as they come, until the ball-steps are done, a case has failed, or the caller has enough."""
    done = 0
    batches = ((seed, first) for first in range(0, 10**15, _CASES_PER_JOB))
    with closing(sure(results(_batch, batches, workers))) as done_batches:
        for tally in done_batches:
            yield tally
            done += tally.steps
            if done >= steps or tally.failures:
                return


def _batch(job: tuple[int, int]) -> Tally:
    """The cases of one job."""
    seed, first = job
    tally = Tally()
    for index in range(first, first + _CASES_PER_JOB):
        tally = tally.plus(play(seed, index))
    return tally


def smallest(failure: Failure) -> Failure:
    """The failing tick with every ball and ring left out that it fails without."""
    best = failure
    shrinking = True
    while shrinking:
        shrinking = False
        for arena in _with_one_less(best.arena):
            what, _ = checked_tick(arena, best.speed)
            if what is not None:
                best, shrinking = best._replace(arena=arena, what=what), True
                break
    return best


def _with_one_less(arena: Arena) -> Iterator[Arena]:
    """The arena without one of its balls or rings."""
    balls, rings, layers = arena
    if len(balls) > 1:
        for i in range(len(balls)):
            yield arena._replace(balls=balls[:i] + balls[i + 1 :])
    if len(rings) > 1:
        for k in range(len(rings)):
            yield Arena(balls, rings[:k] + rings[k + 1 :], layers[:k] + layers[k + 1 :])
