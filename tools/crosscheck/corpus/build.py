"""The list of the corpus's games, and the manifest of what they gave."""

import hashlib
import json
import subprocess
from collections import Counter
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any, NamedTuple

from game.levels import classic
from game.system.errors import BadInputError
from game.system.files import write_text
from tools.crosscheck.corpus.part import PartJob, finished_part, made_part
from tools.crosscheck.games.sources import AIMED, AUTOPILOT, RANDOM, Source
from tools.crosscheck.results.coverage import ALL_CELLS
from tools.crosscheck.run import AIMED_TICKS, versions
from tools.crosscheck.workers import results_of
from tools.executor import Lost, Where

FORMAT = "polar-breakout corpus 1"
MANIFEST = "manifest.json"

_AUTOPILOT_SEEDS, _AUTOPILOT_TICKS = 36, 36_000
_HUMAN_SEEDS, _HUMAN_TICKS = 10, 14_400
_RANDOM_SEEDS, _RANDOM_TICKS = 160, 6_000
_AIMED_SEEDS = 8
_ROOT = Path(__file__).resolve().parents[3]
_CODE = ("physics", "game", "tools/crosscheck")


def corpus_sources() -> list[Source]:
    """The games of the corpus, always the same, the kinds mixed so that a part of the list is like the whole."""
    levels = [level.name for level in classic()]
    kinds = [
        [Source(None, AIMED, seed, AIMED_TICKS) for seed in range(1, _AIMED_SEEDS + 1)],
        [Source(None, level, seed, _HUMAN_TICKS, "mouse") for seed in range(1, _HUMAN_SEEDS + 1) for level in levels],
        [Source(None, level, seed, _HUMAN_TICKS, "keys") for seed in range(1, _HUMAN_SEEDS + 1) for level in levels],
        [Source(None, RANDOM, seed, _RANDOM_TICKS) for seed in range(1, _RANDOM_SEEDS + 1)],
        [Source(None, level, seed, _AUTOPILOT_TICKS, AUTOPILOT) for seed in range(1, _AUTOPILOT_SEEDS + 1) for level in levels],
    ]
    ordered = [(index / len(kind), number, source) for number, kind in enumerate(kinds) for index, source in enumerate(kind)]
    return [source for _, _, source in sorted(ordered, key=lambda entry: entry[:2])]


class Corpus(NamedTuple):
    """What there is of the corpus.

    manifest: as it is written. complete: whether every game of the list is in it. lost: games without an answer.
    """

    manifest: dict[str, Any]
    complete: bool
    lost: list[str]

    @property
    def agrees(self) -> bool:
        """Whether nothing is unexplained and nothing is missing."""
        return self.complete and not self.lost and self.manifest["totals"]["unexplained"] == 0


def built_corpus(
    folder: Path, most: int | None, facets: int, workers: Where, on_progress: Callable[[int, int], None]
) -> Corpus:
    """Check every game that the folder does not have yet, and write the manifest; after Ctrl-C with what there is.

    most: games of the list, from its start; None for all. on_progress: called with the games done and their contacts.
    """
    _make(folder)
    code = code_hash()
    jobs = [PartJob(k, source, facets, str(folder), code) for k, source in enumerate(corpus_sources()[:most])]
    parts = {job.number: part for job in jobs if (part := finished_part(job)) is not None}
    missing = [job for job in jobs if job.number not in parts]
    lost = []
    on_progress(len(parts), sum([part["contacts"] for part in parts.values()]))
    interrupted = False
    try:
        with closing(results_of(made_part, missing, workers)) as results:
            for index, result in results:
                if isinstance(result, Lost):
                    lost.append(f"{missing[index].source.name}: {result.why}")
                else:
                    parts[missing[index].number] = result
                on_progress(len(parts), sum([part["contacts"] for part in parts.values()]))
    except KeyboardInterrupt:
        interrupted = True
    manifest = _manifest([parts[number] for number in sorted(parts)], len(jobs))
    write_text(folder / MANIFEST, json.dumps(manifest, indent=1) + "\n")
    return Corpus(manifest, not interrupted and len(parts) == len(jobs), lost)


def code_hash() -> str:
    """One hash for the program: the game, its levels, its physics and this harness."""
    digest = hashlib.sha256()
    for folder in _CODE:
        for path in sorted((_ROOT / folder).rglob("*")):
            if path.suffix in {".py", ".toml"}:
                digest.update(path.relative_to(_ROOT).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


def _make(folder: Path) -> None:
    """The folder, made if it is not there; BadInputError where it cannot be."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / ".probe"
        probe.touch()
        probe.unlink()
    except OSError as error:
        raise BadInputError(f"--corpus {folder}: cannot write there; {error.strerror}") from None


def _manifest(parts: list[dict[str, Any]], listed: int) -> dict[str, Any]:
    """All that the corpus says of itself. `games_sha256` is the same on every machine."""
    keys = ("contacts", "poses", "ticks", "unexplained", "freed", "dropped")
    cells: Counter[tuple[int, ...]] = Counter()
    for part in parts:
        for *cell, count in part["cells"]:
            cells[tuple(cell)] += count
    return {
        "format": FORMAT,
        "versions": versions(),
        "commit": _commit(),
        "code": parts[0]["code"] if parts else code_hash(),
        "listed": listed,
        "games_sha256": hashlib.sha256("".join([part["games_sha256"] for part in parts]).encode()).hexdigest(),
        "totals": {"games": len(parts), **{key: sum([part[key] for part in parts]) for key in keys}},
        "verdicts": _added([part["verdicts"] for part in parts]),
        "empty_cells": len(ALL_CELLS) - len(cells),
        "rows": _merged_rows(parts),
        "games": [{key: value for key, value in part.items() if key not in {"cells", "rows", "code"}} for part in parts],
    }


def _merged_rows(parts: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The rows of all games together: counts added, maxima of all."""
    merged: dict[tuple[str, str], dict[str, Any]] = {}
    for part in parts:
        for row in part["rows"]:
            known = merged.setdefault((row["comparison"], row["feature"]), {**row, "count": 0})
            known["count"] += row["count"]
            for key in ("maximum", "largest_bound", "share"):
                known[key] = max(known[key], row[key])
    return list(merged.values())


def _added(counts: list[dict[str, int]]) -> dict[str, int]:
    """Counts by name, added."""
    total: Counter[str] = Counter()
    for count in counts:
        total.update(count)
    return dict(total)


def _commit() -> str | None:
    """The commit of the working copy; None outside of one."""
    try:
        done = subprocess.run(["git", "rev-parse", "HEAD"], cwd=_ROOT, capture_output=True, text=True, check=True)  # noqa: S607
    except (OSError, subprocess.CalledProcessError):
        return None
    return done.stdout.strip()
