"""A whole run: many games, checked in worker processes, gathered into one result."""

import platform
from collections.abc import Callable, Sequence
from contextlib import closing, nullcontext
from typing import NamedTuple

import pymunk

from game import VERSION
from game.levels import Level, campaign, classic
from game.system.errors import BadInputError
from physics import PHYSICS_VERSION
from tools.crosscheck.comparisons.game import Checked, WantedChecks, checked_ticks
from tools.crosscheck.games.aimed import SPECIAL
from tools.crosscheck.games.sources import AIMED, AUTOPILOT, DIFFICULTIES, PLAYERS, RANDOM, Source, ticks_of
from tools.crosscheck.results.coverage import ALL_CELLS
from tools.crosscheck.results.rows import ContactRows
from tools.crosscheck.sabotage.catalogue import MISTAKES
from tools.crosscheck.workers import results_of
from tools.executor import Lost, Where

_ARENAS = 6
"""Random arenas of the default run."""
AIMED_TICKS = len(ALL_CELLS) * SPECIAL // (SPECIAL - 1)
"""One contact for every cell, and the arenas of the other kinds."""


class Job(NamedTuple):
    """One game to check, as a worker gets it.

    facets: of each arc in the chain. only: the one tick to compare. sabotage: a mistake's name. recorded: whether every
    contact gets a record of its own. enough: unexplained measurements after which the rest of the game says nothing new.
    """

    source: Source
    facets: int
    only: int | None = None
    sabotage: str | None = None
    recorded: bool = False
    enough: int | None = None


class RunResult:
    """What a run gave, complete or not.

    playing, checking, building: seconds of the processor for the games, the comparisons and pymunk's models. lost: games
    whose process died, with the reason. partial: whether the run was interrupted.
    """

    def __init__(self, jobs: Sequence[Job]) -> None:
        """Before the first game."""
        self.jobs = tuple(jobs)
        self.rows = ContactRows()
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
    if job.sabotage is not None:
        options += f" --sabotage {job.sabotage}"
    with nullcontext() if job.sabotage is None else MISTAKES[job.sabotage].change():
        return checked_ticks(ticks_of(job.source), WantedChecks(job.facets, options, job.only, job.recorded, job.enough))


def checked_games(jobs: Sequence[Job], workers: Where, on_progress: Callable[[RunResult], None]) -> RunResult:
    """All games, each by a worker process; after Ctrl-C what there is until then, marked as partial.

    on_progress: called after each game.
    """
    result = RunResult(jobs)
    try:
        with closing(results_of(check_game, jobs, workers)) as results:
            for number, checked in results:
                result.take(jobs[number].source, checked)
                on_progress(result)
    except KeyboardInterrupt:
        result.partial = True
    return result


def default_sources(seed: int, ticks: int) -> list[Source]:
    """What is checked where nothing is named.

    A game of each classic level by the autopilot, one by a player that meets the ball with any part of a paddle, one under the
    arcade rules of the last level of each chapter, some random arenas, and a contact of every kind. The longest games come
    first, so that processes which share them finish at about the same time.
    """
    levels = [level.name for level in classic()]
    ends = [level.name for level in campaign() if level is _last_of_chapter(level)]
    sources = [Source(None, AIMED, seed, min(ticks, AIMED_TICKS))]
    sources += [Source(None, level, seed + k, ticks, arcade=DIFFICULTIES[k % 3]) for k, level in enumerate(ends)]
    sources += [Source(None, level, seed + k, ticks) for k, level in enumerate(levels)]
    sources += [Source(None, level, seed + k, ticks, PLAYERS[1 + k % 2]) for k, level in enumerate(levels)]
    return [*sources, *[Source(None, RANDOM, seed + k, ticks // 4 + 1) for k in range(_ARENAS)]]


def _last_of_chapter(level: Level) -> Level:
    """The last level of a level's chapter: it has all that the chapter is about."""
    return [other for other in campaign() if other.chapter == level.chapter][-1]


class Choice(NamedTuple):
    """The games that the command line asks for. None: not said."""

    replays: tuple[str, ...] = ()
    games: int | None = None
    seed: int = 1
    level: str | None = None
    ticks: int = 14_400
    player: str | None = None
    arcade: str | None = None


def chosen_sources(choice: Choice) -> list[Source]:
    """The games of a run: the replay files, and as many games as asked for, in turn from each level where none is named."""
    sources = [Source(path, "", 0, 0) for path in choice.replays]
    if not sources and choice.games is None and choice.level is None and choice.player is None and choice.arcade is None:
        sources = default_sources(choice.seed, choice.ticks)
    else:
        every = [level.name for level in (classic() if choice.arcade is None else campaign())]
        levels = every if choice.level is None else [choice.level]
        count = choice.games if choice.games is not None else (0 if sources else len(levels))
        player = choice.player or AUTOPILOT
        named = [(levels[k % len(levels)], choice.seed + k) for k in range(count)]
        sources += [Source(None, level, seed, choice.ticks, player, choice.arcade) for level, seed in named]
    if not sources:
        raise BadInputError("nothing to check; name a replay or give --games")
    return [source.checked() for source in dict.fromkeys(sources)]


def versions() -> dict[str, str]:
    """What was run on what."""
    return {
        "game": VERSION,
        "physics": str(PHYSICS_VERSION),
        "pymunk": pymunk.version,
        "Chipmunk": pymunk.chipmunk_version,
        "Python": platform.python_version(),
        "machine": f"{platform.system()} {platform.machine()}",
    }
