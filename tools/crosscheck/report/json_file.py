"""The result as JSON.

One object; a key may be added, none changes its meaning while `format` stays the same. Numbers that do not exist are null.

    format       "polar-breakout crosscheck 2"
    verdict      the line printed last
    agrees       true if nothing is unexplained, no game is lost, all games were checked and a contact was compared
    partial      true after Ctrl-C
    versions     of game, physics, pymunk, Chipmunk, Python, and the machine
    options      facets, sabotage (null or its name), only (null or the one tick compared)
    games        list of {options, lost}: the options of the command that repeats each game; lost: null or why
    totals       contacts, ticks, poses, freed and dropped (balls put outside material, or stopped; confirmed),
                 elsewhere (unexplained measurements away from contacts)
    seconds      of the processor: playing, checking, building (pymunk's models)
    verdicts     contacts by verdict: exact, grazing, tie, rule, unexplained
    rows         list of {comparison, feature, unit, count, median, p99, maximum, bound, share, bound_source, worst}; bound:
                 the one the largest error is held to; share: the largest fraction any error is of its own; worst: a measurement
    measurements every measurement of the verdicts grazing, tie, rule, unexplained
    contacts     list of {options, tick, time, ball, ring, slot, feature, layers, position, point, normal, before, after,
                 verdict, cell, errors}: one for each contact; errors: {comparison: [error, bound]}
    coverage     {names, cells, empty}: names of every dimension's values; cells: list of [indices of the values ..., contacts];
                 empty: the cells without a contact, in words
    convergence  null or list of {name, unit, expected, slope, slack, residual, holds, facets, errors, derived, bounds,
                 contacts}
    free_run     null or list of {seed, together, seconds, growth, differences}
    sabotage     null or list of {name, sentence, caught, holds, invisible, contacts, first, unexplained, named, lost}

A measurement is {verdict, comparison, feature, what, tick, time, ball, ring, slot, error, bound, ours, pymunks, position,
ball_radius, geometry, angle, alive, command}; ours and pymunks are normals or velocities as [x, y], geometry is [radius, half
width, half angle, count] of the ring, angle that of its slot 0, alive says which slots hold material, command shows it again.
"""

import json
import math
from typing import Any

from tools.crosscheck.comparisons.convergence import Curve
from tools.crosscheck.comparisons.free_run import FreeRun
from tools.crosscheck.report.words import UNITS, bound_source, repeat_command, summaries, verdict
from tools.crosscheck.results.coverage import NAMES, empty_cells
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.results.measurements import Measurement
from tools.crosscheck.results.rows import ContactRecord, ContactRows
from tools.crosscheck.run import RunResult, versions
from tools.crosscheck.sabotage.suite import SabotageResult

FORMAT = "polar-breakout crosscheck 2"


def json_text(findings: Findings) -> str:
    """The whole result as JSON text, each contact in a line of its own."""
    whole = as_dict(findings)
    contacts = whole.pop("contacts")
    text = json.dumps(_finite(whole), indent=1, allow_nan=False)
    lines = ",\n  ".join([json.dumps(_finite(contact), allow_nan=False) for contact in contacts])
    return f'{text[:-2]},\n "contacts": [\n  {lines}\n ]\n}}\n' if lines else f'{text[:-2]},\n "contacts": []\n}}\n'


def as_dict(findings: Findings) -> dict[str, Any]:
    """The whole result as nested dictionaries; numbers may be nan or infinite."""
    result = findings.result
    rows = result.rows
    lost = dict(result.lost)
    first = result.jobs[0]
    return {
        "format": FORMAT,
        "verdict": verdict(findings),
        "agrees": findings.agrees,
        "partial": result.partial,
        "versions": versions(),
        "options": {"facets": first.facets, "sabotage": first.sabotage, "only": first.only},
        "games": [{"options": job.source.options(), "lost": lost.get(job.source)} for job in result.jobs],
        "totals": _totals(result),
        "seconds": {"playing": result.playing, "checking": result.checking, "building": result.building},
        "verdicts": {kind.name.lower(): count for kind, count in rows.verdicts.items()},
        "rows": _rows(result),
        "measurements": [_measurement(one) for one in rows.measurements],
        "contacts": [_contact(record) for record in rows.records],
        "coverage": _coverage(rows),
        "convergence": None if findings.curves is None else [_curve(curve) for curve in findings.curves],
        "free_run": None if findings.free_runs is None else [_free_run(run) for run in findings.free_runs],
        "sabotage": None if findings.sabotage is None else [_sabotage(one) for one in findings.sabotage],
    }


def _totals(result: RunResult) -> dict[str, int]:
    """What was compared, and how often."""
    rows = result.rows
    return {
        "contacts": rows.contacts,
        "ticks": result.ticks,
        "poses": rows.poses,
        "freed": rows.freed,
        "dropped": rows.dropped,
        "elsewhere": rows.elsewhere,
    }


def _rows(result: RunResult) -> list[dict[str, Any]]:
    """The rows of the table."""
    rows = []
    for key, summary in summaries(result):
        worst = result.rows.samples[key].worst
        row = {"comparison": key[0].name.lower(), "feature": key[1], "unit": UNITS[key[0]], **summary._asdict()}
        rows.append(row | {"bound_source": bound_source(key), "worst": None if worst is None else _measurement(worst)})
    return rows


def _measurement(measurement: Measurement) -> dict[str, Any]:
    """A measurement with names for its enums and pairs for its points."""
    compared, situation = measurement
    fields = situation._asdict() | compared._asdict()
    fields.pop("options")
    names = {"verdict": compared.verdict.name.lower(), "comparison": compared.comparison.name.lower()}
    return fields | names | {"command": repeat_command(measurement)}


def _contact(record: ContactRecord) -> dict[str, Any]:
    """A contact with its errors."""
    where = record.situation
    return {
        "options": where.options,
        "tick": where.tick,
        "time": where.time,
        "ball": where.ball,
        "ring": where.ring,
        "slot": where.slot,
        "feature": where.feature,
        "layers": record.layers,
        "position": where.position,
        "point": record.point,
        "normal": record.normal,
        "before": record.before,
        "after": record.after,
        "verdict": record.verdict.name.lower(),
        "cell": list(record.cell),
        "errors": {one.comparison.name.lower(): [one.error, one.bound] for one in record.compared},
    }


def _coverage(rows: ContactRows) -> dict[str, Any]:
    """The cells with their contacts, and the names of the others."""
    cells = [[*cell, count] for cell, count in sorted(rows.cells.items())]
    return {"names": NAMES, "cells": cells, "empty": [cell.words for cell in empty_cells(rows.cells)]}


def _curve(curve: Curve) -> dict[str, Any]:
    """A curve of the convergence."""
    found = {"slope": curve.slope, "slack": curve.slack, "residual": curve.residual, "holds": curve.holds}
    return curve._asdict() | found


def _free_run(run: FreeRun) -> dict[str, Any]:
    """A free run."""
    return run._asdict() | {"growth": run.growth}


def _sabotage(one: SabotageResult) -> dict[str, Any]:
    """A mistake and what became of it."""
    mistake = one.mistake
    words = {"name": mistake.name, "sentence": mistake.sentence, "invisible": mistake.invisible}
    counts = {comparison.name.lower(): count for comparison, count in one.unexplained.items()}
    found = {"caught": one.caught, "holds": one.holds, "contacts": one.contacts, "first": one.first}
    return words | found | {"unexplained": counts, "named": one.named, "lost": one.lost}


def _finite(value: Any) -> Any:
    """The same with null for what JSON has no number for, and pairs for complex numbers."""
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    if isinstance(value, complex):
        return [value.real, value.imag]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
