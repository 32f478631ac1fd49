"""The result on the terminal."""

import math
from pathlib import Path

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from tools.crosscheck.corpus.build import MANIFEST, Corpus
from tools.crosscheck.games.sources import AIMED
from tools.crosscheck.report.words import (
    BOUNDS,
    COMPARISON_NAMES,
    NOT_COMPARED,
    TERMS,
    UNITS,
    bound_source,
    compared_games,
    counted,
    number,
    pace,
    repeat_command,
    share,
    summaries,
    verdict,
)
from tools.crosscheck.results.coverage import ALL_CELLS, NAMES, empty_cells, margins
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.results.measurements import FEATURES, VERDICT_MEANINGS, VERDICT_NAMES, ContactVerdict, Measurement
from tools.crosscheck.results.rows import ContactRows
from tools.crosscheck.run import RunResult
from tools.crosscheck.sabotage.suite import SabotageResult

_SHOWN = 12
_EMPTY_SHOWN = 5


def print_findings(console: Console, findings: Findings, listed: ContactVerdict | None) -> None:
    """The tables, the disagreements and the verdict. listed: the verdict whose measurements are listed one by one."""
    result = findings.result
    console.print(Text(compared_games(result)))
    console.print(_table(result))
    console.print(_legend(BOUNDS | TERMS))
    console.print()
    console.print(_verdicts(result))
    console.print(_coverage(result.rows))
    if any([job.source.level == AIMED for job in result.jobs]):  # no other games are meant to meet every kind
        _print_empty_cells(console, result.rows)
    console.print(Text(NOT_COMPARED, style="dim"))
    for source, why in result.lost:
        console.print(Text(f"lost: {source.name}: {why}", style="bold red"))
    _print_measurements(console, result, listed)
    _print_extras(console, findings)
    console.print(pace(result), style="dim", highlight=False)
    console.print(Text(verdict(findings), style="bold green" if findings.agrees else "bold red"), soft_wrap=True)


def print_corpus(console: Console, corpus: Corpus, folder: Path) -> None:
    """What the corpus has, and its hash."""
    manifest = corpus.manifest
    totals = manifest["totals"]
    table = Table(box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False)
    table.add_column("ours and pymunk")
    for heading in ("count", "maximum", "of its bound"):
        table.add_column(heading, justify="right")
    for row in manifest["rows"]:
        name = f"{row['comparison']}, {row['feature']}"
        table.add_row(name, f"{row['count']:,}", number(row["maximum"]), share(row["share"]))
    console.print(table)
    for line in corpus.lost:
        console.print(Text(f"lost: {line}", style="bold red"), soft_wrap=True)
    console.print(f"{folder / MANIFEST}: games {manifest['games_sha256']}", soft_wrap=True, highlight=False)
    words = "AGREE" if totals["unexplained"] == 0 else "DISAGREE"
    state = "" if corpus.complete else f"PARTIAL ({totals['games']} of {manifest['listed']} games; run it again to go on): "
    line = (
        f"{state}{words}: {totals['unexplained']:,} unexplained in {totals['contacts']:,} contacts, "
        f"{totals['poses']:,} poses in {counted(totals['games'], 'game')}; {totals['freed']:,} put outside material, "
        f"{totals['dropped']:,} stopped; {manifest['empty_cells']:,} of {len(ALL_CELLS):,} cells empty"
    )
    console.print(Text(line, style="bold green" if corpus.agrees else "bold red"), soft_wrap=True)


def measurement_line(measurement: Measurement) -> str:
    """A measurement in one line."""
    compared, where = measurement
    slot = f", slot {where.slot}" if where.slot >= 0 else ""
    found = f"{number(compared.error)} ({UNITS[compared.comparison]}) where the bound is {number(compared.bound)}"
    return (
        f"{VERDICT_NAMES[compared.verdict]}: {COMPARISON_NAMES[compared.comparison]}, {where.feature}, tick {where.tick}, "
        f"ball {where.ball}, ring {where.ring}{slot}: {compared.what}; {found}; {repeat_command(measurement)}"
    )


def _table(result: RunResult) -> Table:
    table = Table(box=box.SIMPLE_HEAD, padding=0, pad_edge=False)
    table.add_column("ours and pymunk", no_wrap=True)
    for heading in ("count", "median", "p99", "maximum", "bound", "% of\nbound"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("bound\nfrom", no_wrap=True)
    last = None
    for key, summary in summaries(result):
        if key[0] != last:
            if last is not None:
                table.add_section()
            table.add_row(Text(COMPARISON_NAMES[key[0]], style="bold"), "", *[Text(UNITS[key[0]], style="dim")] * 4)
            last = key[0]
        table.add_row(
            f" {key[1]}",
            f"{summary.count:,}",
            *[number(value) for value in (summary.median, summary.p99, summary.maximum, summary.bound)],
            share(summary.share),
            bound_source(key),
            style="bold red" if summary.share > 1.0 else None,
        )
    return table


def _legend(meanings: dict[str, str]) -> Table:
    """Words of the table and what they mean."""
    table = Table.grid(padding=(0, 2))
    for word, meaning in meanings.items():
        table.add_row(Text(word, style="dim"), Text(meaning, style="dim"))
    return table


def _verdicts(result: RunResult) -> Table:
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("contacts by verdict")
    table.add_column("count", justify="right")
    table.add_column("meaning")
    for kind, count in result.rows.verdicts.items():
        style = "bold red" if kind == ContactVerdict.UNEXPLAINED and count else None
        table.add_row(VERDICT_NAMES[kind], f"{count:,}", VERDICT_MEANINGS[kind], style=style)
    if result.rows.elsewhere:
        table.add_row("unexplained, away from contacts", f"{result.rows.elsewhere:,}", style="bold red")
    return table


def _coverage(rows: ContactRows) -> Table:
    """Contacts by feature and by the value of every other dimension of a cell."""
    table = Table(box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False)
    table.add_column("contacts by kind")
    for feature in FEATURES:
        table.add_column(feature, justify="right")
    counts = {(margin.dimension, margin.value, margin.feature): margin.contacts for margin in margins(rows.cells)}
    for dimension, values in list(NAMES.items())[1:]:
        table.add_section()
        for value in values:
            numbers = [f"{counts[dimension, value, feature]:,}" for feature in FEATURES]
            table.add_row(f"{dimension}: {value}", *numbers)
    return table


def _print_empty_cells(console: Console, rows: ContactRows) -> None:
    """How many cells no contact fell into, and the first of them."""
    empty = empty_cells(rows.cells)
    console.print(f"cells with a contact: {len(ALL_CELLS) - len(empty):,} of {len(ALL_CELLS):,}", highlight=False)
    for cell in empty[:_EMPTY_SHOWN]:
        console.print(Text(f"  empty: {cell.words}", style="dim"))
    if len(empty) > _EMPTY_SHOWN:
        console.print(Text(f"  and {len(empty) - _EMPTY_SHOWN:,} more; --json names all", style="dim"))


def _print_sabotage(console: Console, sabotage: list[SabotageResult]) -> None:
    """Every mistake: caught by what, and after how many contacts."""
    table = Table(box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False)
    table.add_column("mistake")
    table.add_column("caught by")
    table.add_column("contacts before", justify="right")
    for one in sabotage:
        by = ", ".join([COMPARISON_NAMES[comparison] for comparison in list(one.unexplained)[:2]])
        first = "-" if one.first is None else f"{one.first:,}"
        style = None if one.holds else "bold red"
        words = one.lost or by or ("invisible" if one.mistake.invisible else "nothing")
        table.add_row(one.mistake.name, words, first, style=style)
    console.print(table)
    for one in sabotage:
        if one.mistake.invisible:
            console.print(Text(f"{one.mistake.name}: {one.mistake.invisible}.", style="dim"))


def _print_extras(console: Console, findings: Findings) -> None:
    """The mistakes, how the errors fall with the facets, and how long the engines stay together."""
    if findings.sabotage is not None:
        _print_sabotage(console, findings.sabotage)
    for curve in findings.curves or ():
        line = f"{curve.name}: falls as N^{curve.slope:.3f}, expected N^{curve.expected:g} within {curve.slack:.3f}, over "
        line += f"{curve.contacts} contacts; {number(curve.errors[0])} at {curve.facets[0]} facets, {number(curve.errors[-1])} "
        line += (
            f"at {curve.facets[-1]} where {number(curve.derived[-1])} is derived; off by {share(curve.residual)} of the bound"
        )
        console.print(Text(line, style="" if curve.holds else "bold red"))
    for run in findings.free_runs or ():
        words = f"free run {run.seed}: together for {run.together} bounces, {run.seconds:.2f} s;"
        growth = "" if math.isnan(run.growth) else f" their difference grows {run.growth:.1f}-fold a bounce"
        console.print(words + growth, highlight=False)


def _print_measurements(console: Console, result: RunResult, listed: ContactVerdict | None) -> None:
    """The unexplained measurements, the commonest kinds first; and all of a verdict, if asked for."""
    names: dict[str, list[Measurement]] = {}
    for measurement in result.rows.measurements:
        compared, where = measurement
        if compared.verdict == ContactVerdict.UNEXPLAINED:
            name = f"{COMPARISON_NAMES[compared.comparison]}, {where.feature}: {compared.what}"
            names.setdefault(name, []).append(measurement)
    for name, found in sorted(names.items(), key=lambda pair: -len(pair[1]))[:_SHOWN]:
        console.print(Text(f"{len(found):,} x {name}", style="red"), soft_wrap=True)
        console.print(f"    {repeat_command(found[0])}", soft_wrap=True, highlight=False)
    if listed is not None:
        for measurement in result.rows.measurements:
            if measurement.compared.verdict == listed:
                console.print(measurement_line(measurement), soft_wrap=True, highlight=False)
