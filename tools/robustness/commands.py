"""The options of the campaign: `python -m tools.robustness`."""

import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Annotated, TypeVar

import typer
from rich.console import Console
from rich.progress import Progress

from game.system.errors import CheckFailedError, EnvironmentMissingError
from game.system.output import print_line
from tools.robustness import inputs, processes, saving

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

Found = TypeVar("Found")

_MOST_SHOWN = 20


@app.command()
def robustness(
    files: Annotated[
        int, typer.Option(min=0, max=10**7, help="Hostile inputs of each kind: levels, replays, share lines, settings.")
    ] = 500,
    surroundings: Annotated[
        bool, typer.Option(help="Start every command with closed streams, a full disk, no home and so on.")
    ] = True,
    signals: Annotated[int, typer.Option(min=0, max=10**6, help="Signals at random moments, over all commands in turn.")] = 120,
    kills: Annotated[int, typer.Option(min=0, max=10**6, help="SIGKILLs during saving.")] = 1000,
    seed: Annotated[int, typer.Option(min=0, max=2**63 - 1, help="Seed of the cases.")] = 1,
    keep: Annotated[Path | None, typer.Option(help="A folder for the inputs that fail.", exists=True, file_okay=False)] = None,
) -> None:
    """Treat the program badly in every way that is known, and count what it does not survive.

    Exit code 0: every exit code as documented, at most one line a problem, no traceback, nothing torn. 1: something was found.
    """
    if not Path("/proc/self/status").exists():
        raise EnvironmentMissingError("signals and kills are watched through /proc; run it on Linux")
    found: list[str] = []
    with tempfile.TemporaryDirectory() as name:
        for kind in inputs.kinds() if files else ():
            found += _counted(f"hostile {kind.name}", files, inputs.faults(kind, seed, files, keep or Path(name)))
        if surroundings:
            pairs = [(command, there) for command in processes.COMMANDS if command.ends for there in processes.SURROUNDINGS]
            found += _counted("commands in surroundings", len(pairs), (processes.fault(*pair) for pair in pairs))
        if signals:
            ended = processes.ended_by_all(signals, seed)
            found += _counted("signals", signals, (one.fault for one in ended))
        if kills:
            found += _killed(kills, seed, Path(name) / "saving")
    for fault in found[:_MOST_SHOWN]:
        print_line(f"  {fault}")
    if found:
        raise CheckFailedError(f"{len(found)} faults")


def _counted(name: str, count: int, faults: Iterable[str | None]) -> list[str]:
    """The faults among so many cases, after a line that counts them."""
    found = [fault for fault in _with_bar(name, count, faults) if fault is not None]
    print_line(f"{name}: {count}, {len(found)} faults")
    return found


def _killed(count: int, seed: int, folder: Path) -> list[str]:
    """The kills that left something torn or behind, after a line that counts them."""
    folder.mkdir()
    done = list(_with_bar("kills", count, saving.kills(count, seed, folder)))
    torn, left, behind = (sum(column) for column in zip(*done, strict=True))
    print_line(f"kills while saving: {count}, {torn} files torn; {left} left by a kill, {behind} after the next start")
    return [f"kill {number}: {kill}" for number, kill in enumerate(done) if kill.torn or kill.behind]


def _with_bar(name: str, count: int, cases: Iterable[Found]) -> Iterator[Found]:
    """The cases, with a progress bar on stderr where somebody can see it."""
    console = Console(stderr=True)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task(name, total=count)
        for case in cases:
            bar.advance(task)
            yield case
