"""The command's work, once the options are read and the machine is known to have python-flint."""

import signal
from contextlib import nullcontext
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from game.system.files import check_target, check_working_directory, write_text
from game.system.output import print_line
from tools.certify.boxes.catalogue import boxes
from tools.certify.boxes.subdivision import proof_of
from tools.certify.exact_geometry import use_precision
from tools.certify.report import functions_json_text, functions_lines, json_text, lines
from tools.certify.run import CertificationRun, outcome
from tools.certify.sources import ClaimSource, SourcePlan
from tools.certify.totals import Totals
from tools.executor import Where


def certify(names: tuple[str, ...], impacts: int, seed: int, workers: Where, json: Path | None, *, every_case: bool) -> int:
    """Certify what is named, or a plan of games and arenas; the exit code."""
    check_working_directory()
    check_target(json, "--json")
    named = [ClaimSource(name).checked() for name in names]
    done = _with_progress(named or SourcePlan(seed, impacts), None if named else impacts, workers)
    for line in lines(done, every_case=every_case):
        print_line(line)
    if json is not None:
        options = {"sources": list(names), "impacts": impacts, "seed": seed}
        write_text(json, json_text(done, options))
    if done.tally.refuted or done.lost:
        return 1
    if done.partial:
        return 128 + signal.SIGINT
    return 0 if done.tally.impacts else 1


def certify_functions(pieces: int, json: Path | None) -> int:
    """Prove the source's functions over boxes of inputs; the exit code."""
    check_target(json, "--json")
    use_precision()
    console = Console(stderr=True)
    with console.status("subdividing") if console.is_terminal else nullcontext():
        proofs = [proof_of(box, pieces) for box in boxes()]
    for line in functions_lines(proofs):
        print_line(line)
    if json is not None:
        write_text(json, functions_json_text(proofs, pieces))
    return 0 if all([proof.wrong is None and proof.proved > 0.0 for proof in proofs]) else 1


def _with_progress(sources: "list[ClaimSource] | SourcePlan", impacts: int | None, workers: Where) -> CertificationRun:
    """Run; where somebody watches, a bar shows how far it is."""
    console = Console(stderr=True)
    columns = (
        TextColumn("certifying"),
        BarColumn(),
        TextColumn("{task.fields[impacts]:,} impacts, {task.fields[refuted]} refuted,"),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("", total=len(sources) if impacts is None else impacts, impacts=0, refuted=0)

        def show(number: int, tally: Totals) -> None:
            completed = number if impacts is None else tally.impacts
            progress.update(task, completed=completed, impacts=tally.impacts, refuted=tally.refuted)

        return outcome(sources, impacts, workers, show)
