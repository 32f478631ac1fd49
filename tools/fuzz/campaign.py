"""A campaign: cases by the number, the tally of what happened in them, and the smallest arena that fails."""

from collections.abc import Callable, Iterator
from contextlib import closing
from itertools import chain
from typing import NamedTuple

from physics import Arena, FreeFlight, Step, advance
from tools.executor import Where, results, sure
from tools.fuzz.arenas import TICK, TICKS, random_case, steered, with_lost_balls_back
from tools.fuzz.checks import first_fault

SPARED = "a tick that was spared the search went another way than with it"
"""A fault that the tick alone does not show: it needs the one before."""

CASES_PER_TALLY = 10
_TALLIES_PER_FAR_JOB = 50
"""For a cluster: about a minute's work. Its scheduler needs about a millisecond for a job."""


class Failure(NamedTuple):
    """A tick that broke a promise."""

    seed: int
    number: int
    tick: int
    what: str
    arena: Arena  # at the start of that tick
    speed: float


class CampaignTally(NamedTuple):
    """What happened in a number of cases."""

    cases: int = 0
    steps: int = 0  # ticks, each counted once for every ball
    hits: int = 0
    dropped: int = 0
    freed: int = 0
    failures: tuple[Failure, ...] = ()

    def plus(self, other: "CampaignTally") -> "CampaignTally":
        """Both together."""
        return CampaignTally(
            self.cases + other.cases,
            self.steps + other.steps,
            self.hits + other.hits,
            self.dropped + other.dropped,
            self.freed + other.freed,
            self.failures + other.failures,
        )


def play(seed: int, index: int, ticks: int = TICKS) -> CampaignTally:
    """One case, up to its first fault."""
    arena, speed, chance = random_case(seed, index)
    tally = CampaignTally(cases=1)
    flight: FreeFlight | None = None
    for tick in range(ticks):
        what, step = checked_tick(arena, speed, flight)
        tally = tally.plus(CampaignTally(0, len(arena.balls), len(step.hits), step.dropped, step.freed))
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


def tallies(
    seed: int, steps: int, workers: Where, first: int = 0, one: Callable[[int, int], CampaignTally] | None = None
) -> Iterator[CampaignTally]:
    """Tallies as they come, until the ball-steps are done, a case has failed, or the caller has enough.

    first: the first case. one: plays a case of a seed and number, importable by its name; `play` unless given. The cases are
    the same ones in the same order, wherever they are played.
    """
    done, count = 0, _TALLIES_PER_FAR_JOB if isinstance(workers, str) else 1
    jobs = ((one or play, seed, start, count) for start in range(first, 10**15, count * CASES_PER_TALLY))
    with closing(sure(results(_tallies, jobs, workers))) as answers:
        for tally in chain.from_iterable(answers):
            yield tally
            done += tally.steps
            if done >= steps or tally.failures:
                return


def _tallies(job: tuple[Callable[[int, int], CampaignTally], int, int, int]) -> list[CampaignTally]:
    """So many tallies of cases, as far as none fails. job: what plays a case, the seed, the first case, how many tallies."""
    one, seed, start, count = job
    tallies = []
    for first in range(start, start + count * CASES_PER_TALLY, CASES_PER_TALLY):
        tally = CampaignTally()
        for index in range(first, first + CASES_PER_TALLY):
            tally = tally.plus(one(seed, index))
        tallies.append(tally)
        if tally.failures:
            break
    return tallies


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
