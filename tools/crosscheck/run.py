"""A whole run: many games, checked in worker processes, gathered into one result."""

import platform
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

import pymunk

from game import VERSION
from game.levels import built_in
from game.system.errors import BadInputError
from tools.crosscheck.comparisons.game import Checked, checked_ticks
from tools.crosscheck.games.sabotage import SABOTAGES
from tools.crosscheck.games.sources import Source, ticks_of
from tools.crosscheck.results.rows import Rows
from tools.crosscheck.workers import Lost, results_of


class Job(NamedTuple):
    """One game to check, as a worker gets it."""

    source: Source
    facets: int
    only: int | None = None  # the one tick to compare
    sabotage: str | None = None


class Outcome:
    """What a run gave, complete or not."""

    def __init__(self, jobs: Sequence[Job]) -> None:
        """Before the first game."""
        self.jobs = tuple(jobs)
        self.rows = Rows()
        self.games = 0
        self.ticks = 0
        self.playing = 0.0
        self.checking = 0.0
        self.building = 0.0
        self.lost: list[tuple[Source, str]] = []
        self.partial = False

    def take(self, source: Source, result: Checked | Lost) -> None:
        """Add one game."""
        if isinstance(result, Lost):
            self.lost.append((source, result.why))
            return
        self.games += 1
        self.rows.merge(result.rows)
        self.ticks += result.ticks
        self.playing += result.playing
        self.checking += result.checking
        self.building += result.building

    @property
    def agrees(self) -> bool:
        """Whether nothing is unexplained, no game is lost, and there was something to compare."""
        return self.rows.unexplained == 0 and not self.lost and self.rows.contacts > 0


def check_game(job: Job) -> Checked:
    """One game, checked in this process."""
    options = f"{job.source.options()} --facets {job.facets}"
    ticks = ticks_of(job.source)
    if job.sabotage is not None:
        options += f" --sabotage {job.sabotage}"
        ticks = ticks_of(job.source, SABOTAGES[job.sabotage]())
    return checked_ticks(ticks, job.facets, options, job.only)


def checked_games(jobs: Sequence[Job], workers: int, tell: Callable[[Outcome], None]) -> Outcome:
    """All games, each by a worker process; after Ctrl-C what there is until then, marked as partial.

    tell: called after each game.
    """
    outcome = Outcome(jobs)
    try:
        for number, result in results_of(check_game, jobs, workers):
            outcome.take(jobs[number].source, result)
            tell(outcome)
    except KeyboardInterrupt:
        outcome.partial = True
    return outcome


def chosen_sources(replays: Iterable[str], games: int | None, seed: int, level: str | None, ticks: int) -> list[Source]:
    """The games of a run: the replay files, and as many games as asked for, in turn from each level where none is named."""
    sources = [Source(path, "", 0, 0) for path in replays]
    every = [str(number + 1) for number in range(len(built_in()))]
    levels = every if level is None else [level]
    count = games if games is not None else (0 if sources else len(levels))
    sources += [Source(None, levels[number % len(levels)], seed + number, ticks) for number in range(count)]
    if not sources:
        raise BadInputError("nothing to check; name a replay or give --games")
    return [source.checked() for source in dict.fromkeys(sources)]


def versions() -> dict[str, str]:
    """What was run on what."""
    return {
        "game": VERSION,
        "pymunk": pymunk.version,
        "Chipmunk": pymunk.chipmunk_version,
        "Python": platform.python_version(),
        "machine": f"{platform.system()} {platform.machine()}",
    }
