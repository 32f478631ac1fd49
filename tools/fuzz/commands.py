"""The options of the fuzzer: `python -m tools.fuzz`."""

from collections.abc import Callable
from contextlib import closing, nullcontext
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from game.system.command_line import refuse_ignored
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.output import print_line
from game.system.wording import quoted
from tools.executor import Where, results, sure
from tools.executor.options import ClusterOption, WorkersOption, where
from tools.fuzz.arenas import TICK
from tools.fuzz.campaign import CampaignTally, Failure, checked_tick, play, smallest, tallies
from tools.fuzz.impacts import checked_chunk, multiprecision

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_MOST = 10**12
_CHUNK = 200
_STOPPED = "stopped by a signal"


@app.command()
def fuzz(
    context: typer.Context,
    steps: Annotated[int, typer.Option(min=1, max=_MOST, help="Ball-steps: ticks, counted once for every ball.")] = 100_000,
    seed: Annotated[int, typer.Option(min=0, max=2**63 - 1, help="Seed of the cases.")] = 1,
    first: Annotated[
        int, typer.Option(min=0, max=_MOST, help="Number of the first case, to go on where a run was stopped.")
    ] = 0,
    workers: WorkersOption = 1,
    cluster: ClusterOption = None,
    compiled: Annotated[
        bool, typer.Option("--compiled", help="Play 64 games of every arena on the compiled engine, the checks compiled too.")
    ] = False,
    case: Annotated[str | None, typer.Option(metavar="SEED:INDEX", help="Play this one case again.")] = None,
    impacts: Annotated[
        int | None, typer.Option(min=1, max=_MOST, help="Check so many times of impact with 50 digits instead.")
    ] = None,
) -> int:
    """Play random arenas and check every tick against an independent geometry.

    Exit code 0: nothing found. 1: a promise was broken. 2: bad input. 3: no mpmath, for --impacts. 130: Ctrl-C.
    """
    if case is not None:
        refuse_ignored(context, "does nothing beside --case", "steps", "seed", "first", "workers", "cluster", "impacts")
        return _again(*_numbers(case), _played_by(compiled=compiled), compiled=compiled)
    if impacts is not None:
        refuse_ignored(context, "does nothing beside --impacts", "steps", "first", "compiled")
        return _impacts(impacts, seed, where(context, workers, cluster))
    return _campaign(steps, seed, first, where(context, workers, cluster), compiled=compiled)


def _numbers(case: str) -> tuple[int, int]:
    """The two numbers of SEED:INDEX."""
    seed, _, index = case.partition(":")
    if not (seed.isdecimal() and index.isdecimal() and seed.isascii() and index.isascii() and len(case) <= 40):
        raise BadInputError(f"--case {quoted(case)}: expected two whole numbers, SEED:INDEX")
    return int(seed), int(index)


def _played_by(*, compiled: bool) -> Callable[[int, int], CampaignTally]:
    """What plays a case. The compiled loops are compiled here, before other processes would, each for itself."""
    if not compiled:
        return play
    try:
        from tools.fuzz.compiled.campaign import compiled_fuzzer, play_compiled  # noqa: PLC0415  # an extra

        console = Console(stderr=True)
        with console.status("compiling") if console.is_terminal else nullcontext():
            done = compiled_fuzzer()
    except ImportError as error:
        raise EnvironmentMissingError(f"--compiled: {error}") from None
    if not done.cached:
        print_line(f"compiled in {done.seconds:.0f} s")
    return play_compiled


def _again(seed: int, index: int, one: Callable[[int, int], CampaignTally], *, compiled: bool) -> int:
    """Play one case."""
    tally = one(seed, index)
    _say(f"case {seed}:{index}", tally, "done")
    return _verdict(tally, compiled=compiled)


def _campaign(steps: int, seed: int, first: int, workers: Where, *, compiled: bool) -> int:
    """Play cases until the steps are done, one fails, or a signal ends it: then what was done until then is still told."""
    total, one = CampaignTally(), _played_by(compiled=compiled)
    try:
        with _bar() as bar:
            task = bar.add_task("ball-steps", total=steps)
            for tally in tallies(seed, steps, workers, first, one):
                total = total.plus(tally)
                bar.update(task, completed=min(total.steps, steps))
    except KeyboardInterrupt:
        _say(f"seed {seed}", total, f"{_STOPPED}; --first {first + total.cases} goes on")
        raise
    _say(f"seed {seed}", total, "done")
    return _verdict(total, compiled=compiled)


def _impacts(count: int, seed: int, workers: Where) -> int:
    """Check times of impact alone."""
    try:
        multiprecision()
    except ImportError:
        raise EnvironmentMissingError("--impacts needs mpmath: pip install mpmath") from None
    chunks = ((seed, range(first, min(first + _CHUNK, count))) for first in range(0, count, _CHUNK))
    done, touches, faults = 0, 0, list[tuple[int, str]]()
    try:
        with _bar() as bar, closing(sure(results(checked_chunk, chunks, workers))) as answers:
            task = bar.add_task("times of impact", total=count)
            for checked, more, found in answers:
                done, touches, faults = done + checked, touches + more, faults + found
                bar.update(task, completed=done)
                if faults:
                    break
    except KeyboardInterrupt:
        print_line(_impacts_line(seed, done, touches, len(faults), _STOPPED))
        raise
    print_line(_impacts_line(seed, done, touches, len(faults), "done"))
    for index, what in faults:
        print_line(f"  impact {seed}:{index}: {what}")
    return 1 if faults else 0


def _impacts_line(seed: int, done: int, touches: int, wrong: int, how: str) -> str:
    """The line that sums up the times of impact checked."""
    return f"seed {seed}: {done} times of impact, {touches} of them touches, {wrong} wrong; {how}"


def _verdict(tally: CampaignTally, *, compiled: bool) -> int:
    """The exit code, after the shortest failure and how to see it again."""
    if not tally.failures:
        return 0
    _show(min(tally.failures, key=lambda failure: (failure.tick, failure.number)), " --compiled" if compiled else "")
    return 1


def _show(failure: Failure, option: str) -> None:
    """The smallest arena that fails, and the commands that show it."""
    print_line(f"case {failure.seed}:{failure.number} fails at tick {failure.tick}: {failure.what}")
    print_line(f"again: python -m tools.fuzz --case {failure.seed}:{failure.number}{option}")
    if checked_tick(failure.arena, failure.speed)[0] is None:
        return  # it needs the ticks before, or the compiler
    least = smallest(failure)
    print_line(f"its smallest form fails in one tick, advance(arena, {TICK!r}, {least.speed!r}): {least.what}")
    print_line(f"arena = {least.arena!r}")


def _say(name: str, tally: CampaignTally, how: str) -> None:
    """The line that sums a run up."""
    print_line(
        f"{name}: {tally.cases} cases, {tally.steps} ball-steps, {tally.hits} hits, {tally.dropped} dropped at the bound, "
        f"{tally.freed} squeezed and freed, {len(tally.failures)} failed; {how}"
    )


def _bar() -> Progress:
    """A progress bar on stderr, where somebody can see it."""
    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    console = Console(stderr=True)
    return Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
