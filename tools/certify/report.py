"""A run's outcome in words and as JSON."""

import importlib.metadata
import json
import math
import platform
from collections.abc import Iterator, Sequence

from game import VERSION
from physics import PHYSICS_VERSION
from tools.certify.boxes.subdivision import Proof
from tools.certify.certificate import NORMAL, NORMAL_WIDTH, ROUNDINGS, SEARCH_ENDS, Decision
from tools.certify.run import CertificationRun

FORMAT = "polar-breakout certify 1"
_SHOWN = 10


def verdict(outcome: CertificationRun) -> str:
    """The line that says it."""
    tally = outcome.tally
    certified, undecided = (tally.number(impact=True, verdict=one) for one in (Decision.CERTIFIED, Decision.UNDECIDED))
    flights = tally.number(impact=False, verdict=Decision.CERTIFIED)
    unsure = tally.number(impact=False, verdict=Decision.UNDECIDED)
    word = "REFUTED" if tally.refuted else "CERTIFIED" if certified else "NOTHING CERTIFIED"
    line = f"{word}: {certified:,} impacts and {flights:,} free flights certified, {tally.refuted} refuted, "
    line += f"{undecided} and {unsure} undecided"
    if outcome.lost:
        line += f"; {len(outcome.lost)} sources lost"
    return line + ("; stopped by Ctrl-C" if outcome.partial else "")


def lines(outcome: CertificationRun, *, every_case: bool) -> Iterator[str]:
    """The whole report, the verdict last."""
    tally = outcome.tally
    certified = tally.number(impact=True, verdict=Decision.CERTIFIED)
    yield f"{tally.sources:,} games and arenas, {tally.ticks:,} ticks"
    if certified:
        features = ", ".join(
            [f"{name.name.lower().replace('_', ' ')} {count:,}" for name, count in sorted(tally.features.items())]
        )
        yield f"certified impacts by feature: {features}"
        yield f"time: at most {tally.time_off:.2g} s off, every enclosure within {tally.time_bound:.2g} s"
        yield f"after a flight no longer than that, so that only touch and normal are proved: {tally.short:,}"
        share = f"within {NORMAL:g} without any allowance: {tally.close / certified:.2%}"
        yield f"normal: at most {tally.normal_off:.2g} off; {share}"
    for (impact, one, reason), count in sorted(tally.counts.items(), key=lambda item: -item[1]):
        if one != Decision.CERTIFIED:
            yield f"{one.value}: {count:,} {'impacts' if impact else 'free flights'}: {reason.value}"
    shown = tally.cases if every_case else [case for case in tally.cases if case.verdict == Decision.REFUTED][:_SHOWN]
    yield from map(str, shown)
    yield from [f"lost: {name}: {why}" for name, why in outcome.lost]
    yield verdict(outcome)


def json_text(outcome: CertificationRun, options: dict[str, object]) -> str:
    """The outcome as JSON: one object; `format` changes when a key changes its meaning."""
    tally = outcome.tally
    kinds = [
        {"impact": kind.impact, "verdict": kind.verdict.value, "reason": kind.reason.value, "count": count}
        for kind, count in tally.counts.items()
    ]
    result = {
        "format": FORMAT,
        "verdict": verdict(outcome),
        "partial": outcome.partial,
        "versions": _versions(),
        "options": options,
        "asked": {"search_ends": SEARCH_ENDS, "roundings": ROUNDINGS, "normal": NORMAL, "normal_width": NORMAL_WIDTH},
        "sources": tally.sources,
        "ticks": tally.ticks,
        "counts": kinds,
        "features": {name.name.lower(): count for name, count in sorted(tally.features.items())},
        "normals_within": tally.close,
        "short_flights": tally.short,
        "worst": {
            "time_bound": tally.time_bound,
            "time_off": tally.time_off,
            "normal_bound": tally.normal_bound,
            "normal_off": tally.normal_off,
        },
        "cases": [case._asdict() | {"verdict": case.verdict.value, "reason": case.reason.value} for case in tally.cases],
        "lost": [{"source": name, "why": why} for name, why in outcome.lost],
    }
    return json.dumps(result, indent=1, allow_nan=False) + "\n"


def functions_lines(proofs: Sequence[Proof]) -> Iterator[str]:
    """A line for every box, and the verdict last."""
    for proof in proofs:
        yield (
            f"{proof.name}: within {proof.bound:g} (found {proof.worst:.2g}) on {_share(proof.proved)} of the box, "
            f"{proof.border:.2g} of it on the border of a branch, {proof.loose:.2g} not bounded; {proof.pieces:,} pieces"
        )
        if proof.wrong is not None:
            yield f"  another formula at {proof.wrong}"
    yield functions_verdict(proofs)


def functions_verdict(proofs: Sequence[Proof]) -> str:
    """The line that says it."""
    wrong = [proof.name for proof in proofs if proof.wrong is not None]
    nothing = [proof.name for proof in proofs if proof.wrong is None and proof.proved == 0.0]
    if wrong or nothing:
        return f"REFUTED: {len(wrong)} boxes with another formula; nothing proved of {len(nothing)}"
    return f"CERTIFIED: {len(proofs)} boxes, at least {_share(min([proof.proved for proof in proofs]))} of each"


def functions_json_text(proofs: Sequence[Proof], pieces: int) -> str:
    """The proofs over boxes as JSON."""
    result = {
        "format": FORMAT,
        "verdict": functions_verdict(proofs),
        "versions": _versions(),
        "options": {"functions": pieces},
        "boxes": [proof._asdict() for proof in proofs],
    }
    return json.dumps(result, indent=1, allow_nan=False) + "\n"


def _share(x: float) -> str:
    """A share, never rounded up to all."""
    return "all" if x == 1.0 else f"{math.floor(x * 1e6) / 1e4:.4f} %"


def _versions() -> dict[str, object]:
    """What the result was made with."""
    return {
        "game": VERSION,
        "physics": PHYSICS_VERSION,
        "python": platform.python_version(),
        "python-flint": importlib.metadata.version("python-flint"),
    }
