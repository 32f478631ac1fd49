"""One game of the corpus: a file with a line for every contact, and a summary that knows its hashes.

NNNN.jsonl has one JSON object a line. `game` is what the game did; it comes from `+ - * /` and `sqrt` alone and is the same on
every machine:

    tick, time     number of the tick, seconds after its start
    ball, ring, slot, layers    what was hit, and how many layers are left
    point, normal, before, after    on the surface; unit; the ball's velocities: [x, y]

`pymunk` is what the second engine made of it; the C library's sines let its last digits differ from machine to machine:

    feature, verdict, cell    as pymunk judges the contact; the cell as indices into results/coverage.py
    errors         {comparison: [error, bound]}

NNNN.json is the summary that goes into the manifest.
"""

import hashlib
import json
import math
from pathlib import Path
from typing import Any, NamedTuple

from game.system.files import write_text
from tools.crosscheck.comparisons.game import Checked
from tools.crosscheck.games.sources import Source
from tools.crosscheck.results.measurements import Comparison, Samples
from tools.crosscheck.results.rows import ContactRecord
from tools.crosscheck.run import Job, check_game


class PartJob(NamedTuple):
    """One game to check and to write down.

    number: in the list of the corpus. code: the hash of the program that does it.
    """

    number: int
    source: Source
    facets: int
    folder: str
    code: str


def made_part(job: PartJob) -> dict[str, Any]:
    """The summary of one game, whose contacts are written to its file; what an earlier run has written is taken as it is."""
    known = finished_part(job)
    if known is not None:
        return known
    checked = check_game(Job(job.source, job.facets, recorded=True))
    lines = [_lines(record) for record in checked.rows.records]
    text = "".join([f'{{"game": {games}, "pymunk": {pymunks}}}\n' for games, pymunks in lines])
    write_text(_file(job, "jsonl"), text)
    summary = _summary(job, checked)
    summary["games_sha256"] = _hash("".join([games + "\n" for games, _ in lines]))
    summary["file_sha256"] = _hash(text)
    write_text(_file(job, "json"), json.dumps(summary, indent=1) + "\n")
    return summary


def finished_part(job: PartJob) -> dict[str, Any] | None:
    """The summary that an earlier run of the same program has written for this game, if its file is still what it was."""
    try:
        summary: dict[str, Any] = json.loads(_file(job, "json").read_text(encoding="utf-8"))
        text = _file(job, "jsonl").read_text(encoding="utf-8")
    except (OSError, ValueError):
        return None
    wanted = {"options": job.source.options(), "facets": job.facets, "code": job.code}
    if not isinstance(summary, dict) or any(summary.get(key) != value for key, value in wanted.items()):
        return None
    return summary if summary.get("file_sha256") == _hash(text) else None


def _summary(job: PartJob, checked: Checked) -> dict[str, Any]:
    """What the manifest says of a game."""
    rows = checked.rows
    return {
        "options": job.source.options(),
        "facets": job.facets,
        "code": job.code,
        "file": _file(job, "jsonl").name,
        "contacts": rows.contacts,
        "poses": rows.poses,
        "ticks": checked.ticks,
        "unexplained": rows.unexplained,
        "freed": rows.freed,
        "dropped": rows.dropped,
        "verdicts": {verdict.name.lower(): count for verdict, count in rows.verdicts.items()},
        "cells": [[*cell, count] for cell, count in sorted(rows.cells.items())],
        "rows": [_row(*key, samples) for key, samples in sorted(rows.samples.items()) if len(samples)],
    }


def _row(comparison: Comparison, feature: str, samples: Samples) -> dict[str, Any]:
    """A row of the table without its quantiles, which do not add up."""
    summary = samples.summary()
    assert summary is not None
    bound = max(samples.bounds, default=0.0)
    return {
        "comparison": comparison.name.lower(),
        "feature": feature,
        "count": summary.count,
        "maximum": _finite(summary.maximum),
        "largest_bound": bound,
        "share": _finite(summary.share),
    }


def _lines(record: ContactRecord) -> tuple[str, str]:
    """A contact as JSON: what the game did, and what pymunk made of it."""
    where = record.situation
    games = {
        "tick": where.tick,
        "time": where.time,
        "ball": where.ball,
        "ring": where.ring,
        "slot": where.slot,
        "layers": record.layers,
        "point": _pair(record.point),
        "normal": _pair(record.normal),
        "before": _pair(record.before),
        "after": _pair(record.after),
    }
    pymunks = {
        "feature": where.feature,
        "verdict": record.verdict.name.lower(),
        "cell": list(record.cell),
        "errors": {one.comparison.name.lower(): [_finite(one.error), one.bound] for one in record.compared},
    }
    return json.dumps(games), json.dumps(pymunks)


def _pair(point: complex) -> list[float]:
    return [point.real, point.imag]


def _finite(value: float) -> float:
    """The number itself; for an infinite one, which JSON has not, one that is larger than any."""
    return value if math.isfinite(value) else 1e308


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _file(job: PartJob, ending: str) -> Path:
    return Path(job.folder) / f"{job.number:04}.{ending}"
