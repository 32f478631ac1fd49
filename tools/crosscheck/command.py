"""The command's work, once the options are read and the machine is known to have pymunk."""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import NamedTuple

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from game.system.files import check_target, check_working_directory, write_text
from tools.crosscheck.comparisons.convergence import converged
from tools.crosscheck.comparisons.free_run import free_run
from tools.crosscheck.corpus.build import built_corpus, corpus_sources
from tools.crosscheck.games.sources import Source
from tools.crosscheck.report.json_file import json_text
from tools.crosscheck.report.terminal import print_corpus, print_findings
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.results.measurements import ContactVerdict
from tools.crosscheck.run import Choice, Job, checked_games, chosen_sources
from tools.crosscheck.sabotage.catalogue import MISTAKES
from tools.crosscheck.sabotage.suite import sabotage_results, suite_jobs
from tools.executor import Where

_RESTING = ("1", "2", "3")
_MORE_GAMES = 10
_MORE_TICKS = 30_000
"""Levels whose bricks rest, for the convergence, after the games of the run: enough contacts for every curve."""
_FREE_RUNS = 4
_ALL = "all"


class Options(NamedTuple):
    """What the command line asks for.

    choice: the games. only: the one tick to compare. listed: the verdict to list. sabotage: a mistake, or "all". corpus: its
    folder.
    """

    choice: Choice
    facets: int
    workers: Where
    only: int | None
    listed: str | None
    sabotage: str | None
    report: Path | None
    json: Path | None
    convergence: bool
    free_run: bool
    corpus: Path | None


Tell = Callable[[int, int], None]
"""Called with the games done, and the contacts or mistakes so far."""


def crosscheck(options: Options) -> int:
    """Run the harness; the exit code."""
    check_working_directory()
    check_target(options.report, "--report")
    check_target(options.json, "--json")
    return _games(options) if options.corpus is None else _corpus(options, options.corpus)


def _games(options: Options) -> int:
    """Check the games of the run, and what else is asked for."""
    sources = chosen_sources(options.choice)
    recorded = options.json is not None
    mistake = None if options.sabotage == _ALL else options.sabotage
    jobs = [Job(source, options.facets, options.only, mistake, recorded) for source in sources]
    with _progress("games, {task.fields[count]:,} contacts,", len(jobs)) as on_progress:
        result = checked_games(jobs, options.workers, lambda done: on_progress(done.games + len(done.lost), done.rows.contacts))
    findings = Findings(result)
    if not result.partial:
        findings = _with_extras(findings, sources, options)
    console = Console()
    print_findings(console, findings, ContactVerdict[options.listed.upper()] if options.listed else None)
    for path in _written(findings, options):
        if result.partial:
            console.print(f"partial result: {path}", soft_wrap=True, highlight=False)
    if result.partial:
        return 128 + signal.SIGINT
    return 0 if findings.agrees else 1


def _corpus(options: Options, folder: Path) -> int:
    """The fixed list of games."""
    most = options.choice.games
    total = len(corpus_sources()[:most])
    with _progress("games of the corpus, {task.fields[count]:,} contacts,", total) as on_progress:
        corpus = built_corpus(folder, most, options.facets, options.workers, on_progress)
    print_corpus(Console(), corpus, folder)
    if not corpus.complete and not corpus.lost:
        return 128 + signal.SIGINT
    return 0 if corpus.agrees else 1


def _written(findings: Findings, options: Options) -> list[Path]:
    """The files that were asked for, written; those of an interrupted run get names of their own."""
    written = []
    if options.report is not None:
        from tools.crosscheck.report.html_page import html_text  # noqa: PLC0415  # matplotlib takes a second to load

        written.append(_named(options.report, findings))
        write_text(written[-1], html_text(findings))
    if options.json is not None:
        written.append(_named(options.json, findings))
        write_text(written[-1], json_text(findings))
    return written


def _named(path: Path, findings: Findings) -> Path:
    """The file itself, or beside it one for a part of the result: an earlier, whole result stays as it is."""
    return path.with_name(f"{path.stem}.partial{path.suffix}") if findings.result.partial else path


def _with_extras(findings: Findings, sources: list[Source], options: Options) -> Findings:
    """The mistakes, the convergence and the free run, where they are asked for."""
    status = Console(stderr=True)
    choice = options.choice
    if options.sabotage == _ALL:
        suite = suite_jobs(list(MISTAKES), choice.seed, options.facets)
        with _progress("games with mistakes,", len(suite)) as on_progress:
            findings = findings._replace(sabotage=sabotage_results(suite, options.workers, lambda done: on_progress(done, 0)))
    mistake = MISTAKES[options.sabotage].change() if options.sabotage in MISTAKES else nullcontext()
    if options.convergence:
        more = [Source(None, level, choice.seed + number, _MORE_TICKS) for number in range(_MORE_GAMES) for level in _RESTING]
        with mistake, status.status("more facets") if status.is_terminal else nullcontext():
            findings = findings._replace(curves=converged([*sources, *more]))
    if options.free_run:
        with status.status("left alone") if status.is_terminal else nullcontext():
            runs = [free_run(choice.level, choice.seed + number, options.facets) for number in range(_FREE_RUNS)]
            findings = findings._replace(free_runs=runs)
    return findings


@contextmanager
def _progress(what: str, total: int) -> Iterator[Tell]:
    """Where somebody watches, a bar that shows how many games are done."""
    console = Console(stderr=True)
    columns = (
        TextColumn("checking"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn(what),
        TimeRemainingColumn(),
        TextColumn("left"),
    )
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("", total=total, count=0)
        yield lambda done, count: progress.update(task, completed=done, count=count)
