"""The result as JSON.

One object; a key may be added, none changes its meaning while `format` stays the same. Numbers that do not exist are null.

    format       "polar-breakout crosscheck 1"
    verdict      the line printed last
    agrees       true if nothing is unexplained, no game is lost, all games were checked and a contact was compared
    partial      true after Ctrl-C
    versions     of game, pymunk, Chipmunk, Python, and the machine
    options      facets, sabotage (null or its name), only (null or the one tick compared)
    games        list of {options, lost}: the options of the command that repeats each game; lost: null or why
    totals       contacts, ticks, poses, set_free (hits not compared), elsewhere (unexplained places that are no contacts)
    seconds      of the processor: playing, checking, building (pymunk's models)
    classes      contacts by class: exact, facets, grazing, tie, rule, unexplained
    rows         list of {comparison, feature, unit, count, median, p99, maximum, bound, share, bound_source, worst}; bound:
                 the one the largest error is held to; share: the largest fraction any error is of its own; worst: a case
    cases        every contact of the classes grazing, tie, rule, unexplained, and unexplained places elsewhere
    convergence  null or list of {name, unit, expected, slope, holds, facets, errors, contacts}
    free_run     null or list of {seed, together, seconds, growth, differences}

A case is {kind, comparison, feature, what, tick, time, ball, ring, slot, error, bound, ours, pymunks, position, ball_radius,
geometry, angle, alive, command}; ours and pymunks are normals or velocities as [x, y], geometry is [radius, half width, half
angle, count] of the ring, angle that of its slot 0, alive says which slots hold material, command shows the case again.
"""

import json
import math
from typing import Any

from tools.crosscheck.report.terminal import UNITS, bound_source, repeat_command, rows_ticks, summaries, verdict
from tools.crosscheck.results.cases import Case
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.run import versions

FORMAT = "polar-breakout crosscheck 1"


def json_text(findings: Findings) -> str:
    """The whole result as JSON text."""
    return json.dumps(_finite(as_dict(findings)), indent=1, allow_nan=False) + "\n"


def as_dict(findings: Findings) -> dict[str, Any]:
    """The whole result as nested dictionaries; numbers may be nan or infinite."""
    outcome = findings.outcome
    rows = outcome.rows
    lost = dict(outcome.lost)
    return {
        "format": FORMAT,
        "verdict": verdict(findings),
        "agrees": findings.agrees,
        "partial": outcome.partial,
        "versions": versions(),
        "options": {"facets": outcome.jobs[0].facets, "sabotage": outcome.jobs[0].sabotage, "only": outcome.jobs[0].only},
        "games": [{"options": job.source.options(), "lost": lost.get(job.source)} for job in outcome.jobs],
        "totals": {
            "contacts": rows.contacts,
            "ticks": outcome.ticks,
            "poses": rows_ticks(outcome),
            "set_free": rows.set_free,
            "elsewhere": rows.elsewhere,
        },
        "seconds": {"playing": outcome.playing, "checking": outcome.checking, "building": outcome.building},
        "classes": {kind.name.lower(): count for kind, count in rows.classes.items()},
        "rows": [
            {
                "comparison": key[0].name.lower(),
                "feature": key[1],
                "unit": UNITS[key[0]],
                **summary._asdict(),
                "bound_source": bound_source(key),
                "worst": _case(rows.samples[key].worst),
            }
            for key, summary in summaries(outcome)
        ],
        "cases": [_case(case) for case in rows.cases],
        "convergence": None
        if findings.curves is None
        else [{**curve._asdict(), "slope": curve.slope, "holds": curve.holds} for curve in findings.curves],
        "free_run": None
        if findings.free_runs is None
        else [{**run._asdict(), "growth": run.growth} for run in findings.free_runs],
    }


def _case(case: Case | None) -> dict[str, Any] | None:
    """A case with names for its enums and pairs for its points."""
    if case is None:
        return None
    fields = case._asdict()
    fields.pop("options")
    fields |= {"kind": case.kind.name.lower(), "comparison": case.comparison.name.lower(), "command": repeat_command(case)}
    return fields


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
