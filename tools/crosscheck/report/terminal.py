"""The result on the terminal."""

import math
from collections.abc import Iterator

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from tools.crosscheck.results.cases import CLASS_NAMES, Case, Class, Comparison, Key, Summary
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.run import Outcome

COMPARISON_NAMES = {
    Comparison.NORMAL_EXACT: "normal, exact shape",
    Comparison.NORMAL_FACETS: "normal, facets",
    Comparison.PRESENCE_TICK: "presence every tick",
    Comparison.PRESENCE_HIT: "presence at contact",
    Comparison.TIME: "time of first touch",
    Comparison.BOUNCE: "bounce, no friction",
    Comparison.VELOCITY: "velocity after",
}
UNITS = {
    Comparison.NORMAL_EXACT: "rad",
    Comparison.NORMAL_FACETS: "rad",
    Comparison.PRESENCE_TICK: "length",
    Comparison.PRESENCE_HIT: "length",
    Comparison.TIME: "s",
    Comparison.BOUNCE: "speed",
    Comparison.VELOCITY: "speed",
}
BOUNDS = {
    "noise": "rounding: 7e-15 R, for normals 7e-15 (R + r)/r (derived in facets.py)",
    "facet": "half a facet's angle, d/2; outside asin(R/(R + r) sin d/2)",
    "sagitta": "how far a chord lies inside its arc, R (1 - cos d/2)",
    "window": "touch of a ball larger and of one smaller by noise or sagitta",
    "mirror": "2 |w| e: a mirror turned by e turns the relative velocity w by 2e",
}
"""Where bounds come from, by the word in the table."""


def bound_source(key: Key) -> str:
    """Where the bound of a row comes from: a word of BOUNDS."""
    comparison, feature = key
    if comparison == Comparison.TIME:
        return "window"
    if comparison in {Comparison.BOUNCE, Comparison.VELOCITY}:
        return "mirror"
    if comparison == Comparison.PRESENCE_TICK:
        return "sagitta"
    if comparison == Comparison.NORMAL_FACETS and feature != "end":
        return "facet"
    return "sagitta" if feature == "inner face" else "noise"


def print_findings(console: Console, findings: Findings, listed: Class | None) -> None:
    """The table, the classes, the disagreements and the verdict. listed: the class whose cases are listed one by one."""
    outcome = findings.outcome
    console.print(_table(outcome))
    for word, meaning in BOUNDS.items():
        console.print(Text(f"{word:>8}  {meaning}", style="dim"))
    console.print()
    console.print(_classes(outcome))
    for source, why in outcome.lost:
        console.print(Text(f"lost: {source.name}: {why}", style="bold red"))
    if outcome.rows.set_free:
        console.print(f"not compared: {outcome.rows.set_free} hits of balls that the physics had put outside material")
    _print_cases(console, outcome, listed)
    _print_extras(console, findings)
    console.print(_pace(outcome), style="dim", highlight=False)
    console.print(Text(verdict(findings), style="bold green" if findings.agrees else "bold red"), soft_wrap=True)


def verdict(findings: Findings) -> str:
    """One line: do the two engines agree?"""
    outcome = findings.outcome
    rows = outcome.rows
    games = _counted(outcome.games, "game")
    what = f"{rows.contacts:,} contacts, {rows_ticks(outcome):,} poses in {games}"
    partial = f"PARTIAL ({outcome.games} of {len(outcome.jobs)} games): " if outcome.partial else ""
    if rows.unexplained:
        return f"{partial}DISAGREE: {rows.unexplained:,} unexplained in {what}"
    if outcome.lost:
        return f"{partial}INCOMPLETE: {_counted(len(outcome.lost), 'game')} lost; 0 unexplained in {what}"
    if not rows.contacts:
        return f"{partial}NOTHING COMPARED: no contact in {games}"
    if not outcome.partial and not findings.agrees:
        return f"DISAGREE: an error does not fall with the facets as it must; 0 unexplained in {what}"
    return f"{partial}AGREE: 0 unexplained in {what}"


def rows_ticks(outcome: Outcome) -> int:
    """Poses whose presence was compared."""
    return sum(len(samples) for key, samples in outcome.rows.samples.items() if key[0] == Comparison.PRESENCE_TICK)


def repeat_command(case: Case) -> str:
    """The command that shows a case again, alone."""
    return f"python -m tools.crosscheck {case.options} --tick {case.tick}"


def _table(outcome: Outcome) -> Table:
    table = Table(box=box.SIMPLE_HEAD, padding=0, pad_edge=False)
    table.add_column("ours and pymunk", no_wrap=True)
    for heading in ("count", "median", "p99", "maximum", "bound", "of it"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("from", no_wrap=True)
    last = None
    for key, summary in summaries(outcome):
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


def summaries(outcome: Outcome) -> Iterator[tuple[Key, Summary]]:
    """The table's rows that have anything in them, in order."""
    for key in sorted(outcome.rows.samples, key=row_order):
        summary = outcome.rows.samples[key].summary()
        if summary is not None:
            yield key, summary


def row_order(key: Key) -> tuple[int, int]:
    """The order of the table's rows."""
    return key[0], ("outer face", "inner face", "end", "corner", "anywhere").index(key[1])


def number(value: float) -> str:
    """Two digits of a measured value."""
    if math.isnan(value):
        return "-"
    return "0" if value == 0.0 else f"{value:.1e}"


def share(value: float) -> str:
    """How much of its bound an error takes, in percent."""
    if value > 10.0:
        return ">10x"
    return f"{100.0 * value:.1f}%" if value < 0.9995 or value > 1.0 else "99.9%"


def _classes(outcome: Outcome) -> Table:
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("contacts by class")
    table.add_column("count", justify="right")
    for kind, count in outcome.rows.classes.items():
        style = "bold red" if kind == Class.UNEXPLAINED and count else None
        table.add_row(CLASS_NAMES[kind], f"{count:,}", style=style)
    if outcome.rows.elsewhere:
        table.add_row("unexplained, away from contacts", f"{outcome.rows.elsewhere:,}", style="bold red")
    return table


def _print_extras(console: Console, findings: Findings) -> None:
    """How the errors fall with the facets, and how long the engines stay together."""
    for curve in findings.curves or ():
        line = f"{curve.name}: falls as N^{curve.slope:.3f}, expected N^{curve.expected:g}, over {curve.contacts} contacts; "
        line += f"{number(curve.errors[0])} at {curve.facets[0]} facets, {number(curve.errors[-1])} at {curve.facets[-1]}"
        console.print(Text(line, style="" if curve.holds else "bold red"))
    for run in findings.free_runs or ():
        words = f"free run {run.seed}: together for {run.together} bounces, {run.seconds:.2f} s;"
        growth = "" if math.isnan(run.growth) else f" their difference grows {run.growth:.1f}-fold a bounce"
        console.print(words + growth, highlight=False)


_SHOWN = 12


def _print_cases(console: Console, outcome: Outcome, listed: Class | None) -> None:
    """The unexplained cases, the commonest kinds first; and all of a class, if asked for."""
    names: dict[str, list[Case]] = {}
    for case in outcome.rows.cases:
        if case.kind == Class.UNEXPLAINED:
            names.setdefault(f"{COMPARISON_NAMES[case.comparison]}, {case.feature}: {case.what}", []).append(case)
    for name, cases in sorted(names.items(), key=lambda pair: -len(pair[1]))[:_SHOWN]:
        console.print(Text(f"{len(cases):,} x {name}", style="red"), soft_wrap=True)
        console.print(f"    {repeat_command(cases[0])}", soft_wrap=True, highlight=False)
    if listed is not None:
        for case in outcome.rows.cases:
            if case.kind == listed:
                console.print(case_line(case), soft_wrap=True, highlight=False)


def case_line(case: Case) -> str:
    """A case in one line."""
    place = f"tick {case.tick}, ball {case.ball}, ring {case.ring}" + (f", slot {case.slot}" if case.slot >= 0 else "")
    return (
        f"{CLASS_NAMES[case.kind]}: {COMPARISON_NAMES[case.comparison]}, {case.feature}, {place}: {case.what}; "
        f"{number(case.error)} ({UNITS[case.comparison]}) where the bound is {number(case.bound)}; {repeat_command(case)}"
    )


def _pace(outcome: Outcome) -> str:
    rate = outcome.rows.contacts / outcome.checking if outcome.checking else 0.0
    return (
        f"{outcome.ticks:,} ticks; {rate:,.0f} contacts compared per second of a core, presence at every tick included; "
        f"pymunk's models took {outcome.building:.1f} s, the games themselves {outcome.playing:.1f} s"
    )


def _counted(count: int, noun: str) -> str:
    return f"{count:,} {noun}{'' if count == 1 else 's'}"
