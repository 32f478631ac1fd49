"""The command's work, once the options are read and the machine is known to have pymunk."""

import signal
from contextlib import nullcontext
from pathlib import Path
from typing import NamedTuple

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from game.system.errors import BadInputError
from game.system.files import check_target, check_working_directory, write_whole
from game.system.wording import quoted_path
from tools.crosscheck.comparisons.convergence import converged
from tools.crosscheck.comparisons.free_run import free_run
from tools.crosscheck.games.sources import Source
from tools.crosscheck.report.json_file import json_text
from tools.crosscheck.report.terminal import print_findings
from tools.crosscheck.results.cases import Class
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.run import Job, Outcome, checked_games, chosen_sources

_RESTING = ("1", "2", "3")
_MORE_GAMES = 10
_MORE_TICKS = 30_000
"""Levels whose bricks rest, for the convergence, after the games of the run: enough contacts for every curve."""
_FREE_RUNS = 4


class Wishes(NamedTuple):
    """What the command line asks for."""

    replays: tuple[str, ...]
    games: int | None
    seed: int
    level: str | None
    ticks: int
    facets: int
    workers: int
    only: int | None
    listed: str | None
    sabotage: str | None
    report: Path | None
    json: Path | None
    convergence: bool
    free_run: bool


def crosscheck(wishes: Wishes) -> int:
    """Run the harness; the exit code."""
    check_working_directory()
    check_target(wishes.report, "--report")
    check_target(wishes.json, "--json")
    sources = chosen_sources(wishes.replays, wishes.games, wishes.seed, wishes.level, wishes.ticks)
    jobs = [Job(source, wishes.facets, wishes.only, wishes.sabotage) for source in sources]
    console = Console()
    outcome = _checked_with_progress(jobs, wishes.workers)
    findings = Findings(outcome)
    if not outcome.partial:
        findings = _with_extras(findings, sources, wishes)
    print_findings(console, findings, Class[wishes.listed.upper()] if wishes.listed else None)
    if outcome.partial:
        if wishes.report is not None or wishes.json is not None:
            console.print("no file was written")
        return 128 + signal.SIGINT
    if wishes.report is not None:
        from tools.crosscheck.report.html_page import html_text  # noqa: PLC0415  # matplotlib takes a second to load

        _write(wishes.report, html_text(findings))
    if wishes.json is not None:
        _write(wishes.json, json_text(findings))
    return 0 if findings.agrees else 1


def _write(path: Path, text: str) -> None:
    """Write a text file, whole or not at all; BadInputError where it cannot be written."""
    try:
        write_whole(path, text.encode())
    except OSError as error:
        raise BadInputError(f"{quoted_path(path)}: cannot be written; {error.strerror or error}") from None


def _with_extras(findings: Findings, sources: list[Source], wishes: Wishes) -> Findings:
    """The convergence and the free run, where they are asked for."""
    status = Console(stderr=True)
    if wishes.convergence:
        more = [Source(None, level, wishes.seed + number, _MORE_TICKS) for number in range(_MORE_GAMES) for level in _RESTING]
        with status.status("more facets") if status.is_terminal else nullcontext():
            findings = findings._replace(curves=converged([*sources, *more], wishes.sabotage))
    if wishes.free_run:
        with status.status("left alone") if status.is_terminal else nullcontext():
            runs = [free_run(wishes.level, wishes.seed + number, wishes.facets) for number in range(_FREE_RUNS)]
            findings = findings._replace(free_runs=runs)
    return findings


def _checked_with_progress(jobs: list[Job], workers: int) -> Outcome:
    """Check all games; where somebody watches, a bar shows how many are done and how many contacts they had."""
    console = Console(stderr=True)
    columns = (
        TextColumn("checking"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("games, {task.fields[contacts]:,} contacts,"),
        TimeRemainingColumn(),
        TextColumn("left"),
    )
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("", total=len(jobs), contacts=0)

        def tell(outcome: Outcome) -> None:
            progress.update(task, completed=outcome.games + len(outcome.lost), contacts=outcome.rows.contacts)

        return checked_games(jobs, workers, tell)
