"""The result as one HTML page that needs nothing else: opens from disk, on a phone, in the dark, and on paper."""

import math
from collections.abc import Iterator
from html import escape

from tools.crosscheck.comparisons.convergence import Curve
from tools.crosscheck.report.page_style import STYLE
from tools.crosscheck.report.plots import case_picture, convergence_plot, error_histogram
from tools.crosscheck.report.terminal import (
    BOUNDS,
    COMPARISON_NAMES,
    UNITS,
    bound_source,
    number,
    repeat_command,
    share,
    summaries,
    verdict,
)
from tools.crosscheck.results.cases import CLASS_MEANINGS, CLASS_NAMES, FEATURES, Case, Class, Comparison
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.run import Outcome, versions

_DRAWN = 4
"""Cases drawn of each class; all are in the JSON file."""
_LISTED = 200


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
    outcome = findings.outcome
    yield f'<p class="verdict {"good" if findings.agrees else "bad"}">{escape(verdict(findings))}</p>'
    yield (
        "<p>The game flew its balls with its own collision code, in polar coordinates. pymunk (Chipmunk2D) was shown the same "
        "flights among circles and segments built from the level's numbers alone, and asked four questions: which "
        "<em>normal</em> has this contact, does the ball <em>touch</em> anything at this tick, <em>when</em> does it first "
        f"touch, and with what <em>velocity</em> does it leave? An arc is {outcome.jobs[0].facets} chords in pymunk, and an "
        "exact circle where that exists.</p>"
    )
    for source, why in outcome.lost:
        yield f'<p class="bad">Lost: {escape(source.name)}: {escape(why)}</p>'


def _measured(findings: Findings) -> Iterator[str]:
    """The table."""
    yield '<h2>Measured</h2>\n<div class="wide"><table class="numbers">'
    yield (
        "<thead><tr><th>feature</th><th>count</th><th>median</th><th>p99</th><th>maximum</th><th>bound</th><th>of it</th>"
        "<th>from</th></tr></thead>"
    )
    last = None
    for key, summary in summaries(findings.outcome):
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
    yield '<p class="note"><b>bound</b>: the one that the largest error is held to; <b>of it</b>: the largest share that any '
    yield "error takes of its own bound; <b>from</b>: what the bound is derived from.</p>"
    yield "<dl>" + "".join(f"<dt>{word}</dt><dd>{escape(meaning)}</dd>" for word, meaning in BOUNDS.items()) + "</dl>"


_UNIT_WORDS = {"rad": "radians", "length": "world units", "s": "seconds", "speed": "world units per second"}


def _by_class(findings: Findings) -> Iterator[str]:
    """How many contacts of each class."""
    rows = findings.outcome.rows
    yield "<h2>Why they differ</h2>\n<table><thead><tr><th>class</th><th>contacts</th><th>meaning</th></tr></thead><tbody>"
    for kind, count in rows.classes.items():
        style = ' class="bad"' if kind == Class.UNEXPLAINED and count else ""
        yield f'<tr{style}><th>{CLASS_NAMES[kind]}</th><td>{count:,}</td><td class="word">{CLASS_MEANINGS[kind]}</td></tr>'
    yield "</tbody></table>"
    if rows.elsewhere:
        yield f'<p class="bad">Unexplained away from contacts: {rows.elsewhere:,}</p>'
    if rows.set_free:
        yield f"<p>Not compared: {rows.set_free:,} hits of balls that the physics had put outside material.</p>"


def _histograms(findings: Findings) -> Iterator[str]:
    """The distribution of every feature's errors."""
    samples = findings.outcome.rows.samples
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
            "<p>If our arcs were wrong, these lines would level off. Normals must fall as 1/N, times as 1/N² (dotted). "
            + "; ".join(_curve_words(curve) for curve in findings.curves)
            + ".</p>"
        )


def _curve_words(curve: Curve) -> str:
    verb = "as it must" if curve.holds else "<b class='bad'>not as it must</b>"
    return f"{curve.name}: slope {curve.slope:.3f} over {curve.contacts} contacts, {verb}"


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
    rows = findings.outcome.rows
    yield "<h2>The worst normals</h2>"
    yield '<p class="note"><b class="ours">Thick</b>: ours. <b class="theirs">Thin</b>: pymunk\'s. Dotted: an empty slot.</p>'
    yield '<div class="grid">'
    for key, _ in summaries(findings.outcome):
        case = rows.samples[key].worst
        arcs = key[0] == Comparison.NORMAL_FACETS and key[1] in FEATURES[:2]  # the rest is as in the exact model
        if (arcs or key[0] == Comparison.NORMAL_EXACT) and case is not None:
            yield _drawn(f"worst {COMPARISON_NAMES[key[0]]} {key[1]}", case, findings.outcome)
    yield "</div>"


def _disagreements(findings: Findings) -> Iterator[str]:
    """Cases of the classes that need a word: some drawn, more listed."""
    for kind in (Class.UNEXPLAINED, Class.TIE, Class.GRAZING, Class.RULE):
        cases = [case for case in findings.outcome.rows.cases if case.kind == kind]
        if not cases:
            continue
        yield f'<h2>Cases: {CLASS_NAMES[kind]}</h2><p>{CLASS_MEANINGS[kind]}.</p>\n<div class="grid">'
        for index, case in enumerate(sorted(cases, key=lambda case: -case.error)[:_DRAWN]):
            yield _drawn(f"{CLASS_NAMES[kind]} {index}", case, findings.outcome)
        yield f"</div><details><summary>{min(len(cases), _LISTED):,} of {len(cases):,} listed</summary><ol>"
        for case in cases[:_LISTED]:
            line = f"{escape(case.feature)}: {escape(case.what)}; {number(case.error)}"
            yield f"<li>{line}<br><code>{escape(repeat_command(case))}</code></li>"
        yield "</ol></details>"


def _drawn(name: str, case: Case, outcome: Outcome) -> str:
    """One case as a picture with its numbers and its command. name: unique on the page."""
    picture = case_picture(name, case, outcome.jobs[0].facets)
    caption = f"{COMPARISON_NAMES[case.comparison]}, {case.feature}: {case.what}"
    numbers = f"{number(case.error)} {UNITS[case.comparison]}, bound {number(case.bound)}"
    return (
        f"<figure><figcaption>{escape(caption)}<br><b>{numbers}</b></figcaption>{picture}"
        f"<code>{escape(repeat_command(case))}</code></figure>"
    )


def _repeat(findings: Findings) -> Iterator[str]:
    """How to get this page again, and what made it."""
    outcome = findings.outcome
    yield "<h2>To repeat it</h2>"
    yield f"<details><summary>{len(outcome.jobs):,} games and their commands</summary><ol>"
    for job in outcome.jobs:
        yield f"<li><code>python -m tools.crosscheck {escape(job.source.options())} --facets {job.facets}</code></li>"
    yield "</ol></details>"
    seconds = (outcome.playing, outcome.checking, outcome.building)
    yield "<p>Seconds of the processor: {:.1f} playing, {:.1f} comparing, {:.1f} building pymunk's models.</p>".format(*seconds)
    yield "<p>" + ", ".join(f"{escape(name)} {escape(version)}" for name, version in versions().items()) + "</p>"


_SECTIONS = (_verdict, _measured, _by_class, _histograms, _convergence, _worst, _disagreements, _free_runs, _repeat)
