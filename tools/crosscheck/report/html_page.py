"""The result as one HTML page that needs nothing else: opens from disk, on a phone, in the dark, and on paper."""

import math
from collections.abc import Iterator
from html import escape

from tools.crosscheck.comparisons.convergence import Curve
from tools.crosscheck.report.page_style import STYLE
from tools.crosscheck.report.plots import convergence_plot, error_histogram, situation_picture
from tools.crosscheck.report.words import (
    BOUNDS,
    COMPARISON_NAMES,
    NOT_COMPARED,
    TERMS,
    UNITS,
    bound_source,
    number,
    repeat_command,
    share,
    summaries,
    verdict,
)
from tools.crosscheck.results.coverage import ALL_CELLS, NAMES, Margin, empty_cells, margins
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.results.measurements import (
    FEATURES,
    VERDICT_MEANINGS,
    VERDICT_NAMES,
    Comparison,
    ContactVerdict,
    Measurement,
)
from tools.crosscheck.run import RunResult, versions

_DRAWN = 4
"""Measurements drawn of each verdict; all are in the JSON file."""
_LISTED = 200
_CATCHERS = 3
"""Comparisons named beside a mistake: those that noticed it most often."""


def html_text(findings: Findings) -> str:
    """The page."""
    body = "\n".join(part for section in _SECTIONS for part in section(findings))
    title = "Crosscheck: the polar module against pymunk"
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{title}</title>\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n{body}\n</main>\n</body>\n</html>\n"
    )


def _verdict(findings: Findings) -> Iterator[str]:
    """Do they agree, and over how much?"""
    result = findings.result
    yield f'<p class="verdict {"good" if findings.agrees else "bad"}">{escape(verdict(findings))}</p>'
    yield (
        "<p>The game flew its balls with its own collision code, in polar coordinates. pymunk (Chipmunk2D) was shown the same "
        "flights among circles and segments built from the level's numbers alone, and asked: <em>what</em> was hit, and how "
        "many layers are left; which <em>normal</em> has this contact; does the ball <em>touch</em> anything at this tick; "
        "<em>when</em> does it first touch; with what <em>velocity</em> does it leave? Every face, end and corner has an exact "
        f"shape in pymunk; beside them stands a chain of {result.jobs[0].facets} chords for each arc.</p>"
    )
    yield f'<p class="note">{escape(NOT_COMPARED)}</p>'
    for source, why in result.lost:
        yield f'<p class="bad">Lost: {escape(source.name)}: {escape(why)}</p>'


def _measured(findings: Findings) -> Iterator[str]:
    """The table."""
    yield '<h2>Measured</h2>\n<div class="wide"><table class="numbers">'
    yield (
        "<thead><tr><th>feature</th><th>count</th><th>median</th><th>p99</th><th>maximum</th><th>bound</th><th>% of bound</th>"
        "<th>bound from</th></tr></thead>"
    )
    last = None
    for key, summary in summaries(findings.result):
        if key[0] != last:
            yield "</tbody>" if last is not None else ""
            title = f"{COMPARISON_NAMES[key[0]]}, in {_UNIT_WORDS[UNITS[key[0]]]}"
            yield f'<tbody><tr class="group"><th colspan="8">{title}</th></tr>'
            last = key[0]
        cells = [f"{summary.count:,}"]
        cells += [number(value) for value in (summary.median, summary.p99, summary.maximum, summary.bound)] + [
            share(summary.share)
        ]
        style = ' class="bad"' if summary.share > 1.0 else ""
        numbers = "".join(f"<td>{cell}</td>" for cell in cells)
        yield f'<tr{style}><th>{key[1]}</th>{numbers}<td class="word">{bound_source(key)}</td></tr>'
    yield "</tbody></table></div>"
    yield '<p class="note"><b>bound</b>: the one that the largest error is held to; <b>% of bound</b>: the largest share that '
    yield "any error takes of its own bound; <b>bound from</b>: what the bound is derived from.</p>"
    yield "<dl>" + "".join(f"<dt>{word}</dt><dd>{escape(meaning)}</dd>" for word, meaning in (BOUNDS | TERMS).items()) + "</dl>"


_UNIT_WORDS = {
    "wrong": "wrong answers",
    "rad": "radians",
    "length": "world units",
    "s": "seconds",
    "speed": "world units per second",
}


def _by_verdict(findings: Findings) -> Iterator[str]:
    """How many contacts of each verdict."""
    rows = findings.result.rows
    yield "<h2>Why they differ</h2>\n<table><thead><tr><th>verdict</th><th>contacts</th><th>meaning</th></tr></thead><tbody>"
    for kind, count in rows.verdicts.items():
        style = ' class="bad"' if kind == ContactVerdict.UNEXPLAINED and count else ""
        meaning = VERDICT_MEANINGS[kind]
        yield f'<tr{style}><th>{VERDICT_NAMES[kind]}</th><td>{count:,}</td><td class="word">{meaning}</td></tr>'
    yield "</tbody></table>"
    if rows.elsewhere:
        yield f'<p class="bad">Unexplained away from contacts: {rows.elsewhere:,}</p>'


def _coverage(findings: Findings) -> Iterator[str]:
    """Which kinds of contact were compared."""
    cells = findings.result.rows.cells
    empty = empty_cells(cells)
    yield f"<h2>Coverage</h2><p>{len(ALL_CELLS) - len(empty):,} of {len(ALL_CELLS):,} kinds of contact were met: every "
    yield "feature, the surface at rest, moving with the ball or against it, in every fifth of the width, head-on to glancing, "
    yield "with friction 0, between and 1, on narrow and wide sectors, with one ball and several.</p>"
    yield from _coverage_chart(list(margins(cells)))
    if empty:
        yield f"<details><summary>{len(empty):,} kinds without a contact</summary><ol>"
        yield from [f"<li>{escape(cell.words)}</li>" for cell in empty[:_LISTED]]
        yield f"</ol>{'' if len(empty) <= _LISTED else f'<p>and {len(empty) - _LISTED:,} more</p>'}</details>"


def _coverage_chart(found: list[Margin]) -> Iterator[str]:
    """Contacts by feature and by the value of every other dimension: numbers on bars, the longest for the most contacts."""
    counts = {(margin.dimension, margin.value, margin.feature): margin.contacts for margin in found}
    most = max([*counts.values(), 1])
    heads = "".join([f"<th>{feature}</th>" for feature in FEATURES])
    yield f'<table class="chart"><thead><tr><th>contacts</th>{heads}</tr></thead>'
    for dimension, values in list(NAMES.items())[1:]:
        yield f'<tbody><tr class="group"><th colspan="{len(FEATURES) + 1}">{dimension}</th></tr>'
        for value in values:
            numbers = [counts[dimension, value, feature] for feature in FEATURES]
            cells = [f'<td style="--share: {100.0 * count / most:.1f}%">{count:,}</td>' for count in numbers]
            yield f"<tr><th>{value}</th>{''.join(cells)}</tr>"
        yield "</tbody>"
    yield "</table>"


def _sabotage(findings: Findings) -> Iterator[str]:
    """The mistakes, and what caught them."""
    if findings.sabotage is None:
        return
    yield "<h2>Mistakes made on purpose</h2><p>Each was put into the game's own code, and the game went on with it.</p>"
    yield '<table class="mistakes"><thead><tr><th class="word">mistake</th><th class="word">caught by</th>'
    yield "<th>contacts before</th><th>unexplained</th></tr></thead><tbody>"
    for one in findings.sabotage:
        names = [COMPARISON_NAMES[comparison] for comparison in one.unexplained]
        by = ", ".join(names[:_CATCHERS]) + (f" and {len(names) - _CATCHERS} more" if len(names) > _CATCHERS else "")
        first = "-" if one.first is None else f"{one.first:,}"
        style = "" if one.holds else ' class="bad"'
        total = f"{sum(one.unexplained.values()):,} in {one.contacts:,} contacts"
        yield f'<tr{style}><th class="word"><b>{one.mistake.name}</b> {escape(one.mistake.sentence)}</th>'
        label = "caught by" if one.caught else "not caught"
        words = one.lost or by or one.mistake.invisible or "no comparison noticed it"
        yield f'<td class="word" data-label="{label}">{escape(words)}</td>'
        yield f'<td data-label="contacts before">{first}</td><td data-label="unexplained">{total}</td></tr>'
    yield "</tbody></table>"


def _histograms(findings: Findings) -> Iterator[str]:
    """The distribution of every feature's errors."""
    samples = findings.result.rows.samples
    yield '<h2>Errors of the normals</h2>\n<div class="grid">'
    for feature in FEATURES:
        exact, faceted = samples.get((Comparison.NORMAL_EXACT, feature)), samples.get((Comparison.NORMAL_FACETS, feature))
        if feature == "end":
            faceted = None  # one segment in either model
        if exact or faceted:
            yield f"<figure><figcaption>{feature}</figcaption>{error_histogram(f'errors {feature}', exact, faceted)}</figure>"
    yield '</div><p class="note">Errors of 0 are shown at 1e-17. Shaded: the range of the bounds; they depend on ring and ball.'
    yield "</p>"


def _convergence(findings: Findings) -> Iterator[str]:
    """More facets, smaller difference."""
    if findings.curves:
        yield f"<h2>More facets, smaller difference</h2>\n<figure class='narrow'>{convergence_plot(findings.curves)}</figure>"
        yield (
            "<p>If our arcs were wrong, these lines would level off. Normals must fall as 1/N, times as 1/N² (dotted), and at "
            "every N the error must be the one that the contacts' positions on their chords give. "
            "</p><ul>" + "".join(f"<li>{_curve_words(curve)}</li>" for curve in findings.curves) + "</ul>"
        )


def _curve_words(curve: Curve) -> str:
    verb = "as it must" if curve.holds else "<b class='bad'>not as it must</b>"
    return (
        f"{curve.name}: slope {curve.slope:.3f} within {curve.slack:.3f} over {curve.contacts} contacts; "
        f"{number(curve.errors[-1])} at {curve.facets[-1]} facets where {number(curve.derived[-1])} is derived, {verb}"
    )


def _free_runs(findings: Findings) -> Iterator[str]:
    """Left alone."""
    if findings.free_runs:
        yield "<h2>Left alone</h2><p>Both engines start from one state and run on their own. Between round obstacles any "
        yield "difference grows by a factor with every bounce, whoever computes it: chaos, not error, and no verdict.</p>"
        yield "<table><thead><tr><th>start</th><th>bounces together</th><th>seconds</th><th>growth per bounce</th></tr></thead>"
        yield "<tbody>"
        for run in findings.free_runs:
            growth = "too short to tell" if math.isnan(run.growth) else f"x {run.growth:.1f}"
            yield f"<tr><th>{run.seed}</th><td>{run.together}</td><td>{run.seconds:.2f}</td><td>{growth}</td></tr>"
        yield "</tbody></table>"


def _worst(findings: Findings) -> Iterator[str]:
    """The largest error of each feature's normal, drawn."""
    rows = findings.result.rows
    yield "<h2>The worst normals</h2>"
    yield '<p class="note"><b class="ours">Thick</b>: ours. <b class="theirs">Thin</b>: pymunk\'s. Dotted: an empty slot.</p>'
    yield '<div class="grid">'
    for key, _ in summaries(findings.result):
        worst = rows.samples[key].worst
        arcs = key[0] == Comparison.NORMAL_FACETS and key[1] in FEATURES[:2]  # the rest is as in the exact model
        if (arcs or key[0] == Comparison.NORMAL_EXACT) and worst is not None:
            yield _drawn(f"worst {COMPARISON_NAMES[key[0]]} {key[1]}", worst, findings.result)
    yield "</div>"


def _disagreements(findings: Findings) -> Iterator[str]:
    """Measurements of the verdicts that need a word: some drawn, more listed."""
    for kind in (ContactVerdict.UNEXPLAINED, ContactVerdict.TIE, ContactVerdict.GRAZING, ContactVerdict.RULE):
        found = [one for one in findings.result.rows.measurements if one.compared.verdict == kind]
        if not found:
            continue
        yield f'<h2>{VERDICT_NAMES[kind].capitalize()}</h2><p>{VERDICT_MEANINGS[kind]}.</p>\n<div class="grid">'
        for index, one in enumerate(sorted(found, key=lambda one: -one.compared.error)[:_DRAWN]):
            yield _drawn(f"{VERDICT_NAMES[kind]} {index}", one, findings.result)
        yield f"</div><details><summary>{min(len(found), _LISTED):,} of {len(found):,} listed</summary><ol>"
        for one in found[:_LISTED]:
            line = f"{escape(one.situation.feature)}: {escape(one.compared.what)}; {number(one.compared.error)}"
            yield f"<li>{line}<br><code>{escape(repeat_command(one))}</code></li>"
        yield "</ol></details>"


def _drawn(name: str, measurement: Measurement, result: RunResult) -> str:
    """One measurement as a picture with its numbers and its command. name: unique on the page."""
    picture = situation_picture(name, measurement, result.jobs[0].facets)
    compared = measurement.compared
    caption = f"{COMPARISON_NAMES[compared.comparison]}, {measurement.situation.feature}: {compared.what}"
    numbers = f"{number(compared.error)} {UNITS[compared.comparison]}, bound {number(compared.bound)}"
    return (
        f"<figure><figcaption>{escape(caption)}<br><b>{numbers}</b></figcaption>{picture}"
        f"<code>{escape(repeat_command(measurement))}</code></figure>"
    )


def _repeat(findings: Findings) -> Iterator[str]:
    """How to get this page again, and what made it."""
    result = findings.result
    yield "<h2>To repeat it</h2>"
    yield f"<details><summary>{len(result.jobs):,} games and their commands</summary><ol>"
    for job in result.jobs:
        yield f"<li><code>python -m tools.crosscheck {escape(job.source.options())} --facets {job.facets}</code></li>"
    yield "</ol></details>"
    yield (
        f"<p>Seconds of the processor: {result.playing:.1f} playing, {result.checking:.1f} comparing, {result.building:.1f} "
        "building pymunk's models.</p>"
    )
    yield "<p>" + ", ".join(f"{escape(name)} {escape(version)}" for name, version in versions().items()) + "</p>"


_SECTIONS = (
    _verdict,
    _measured,
    _by_verdict,
    _coverage,
    _sabotage,
    _histograms,
    _convergence,
    _worst,
    _disagreements,
    _free_runs,
    _repeat,
)
