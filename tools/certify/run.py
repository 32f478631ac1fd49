"""A whole run: source after source, by one process or several, until enough impacts are done."""

from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from typing import NamedTuple

from tools.certify.sources import ClaimSource
from tools.certify.totals import Totals, no_totals, totals_of
from tools.crosscheck.workers import Lost, results_of


class CertificationRun(NamedTuple):
    """What a run came to. lost: sources without a result, and why. partial: it was stopped by Ctrl-C."""

    tally: Totals
    lost: tuple[tuple[str, str], ...] = ()
    partial: bool = False


def outcome(
    sources: Sequence[ClaimSource], impacts: int | None, workers: int, tell: Callable[[int, Totals], None]
) -> CertificationRun:
    """The sources in their order, until `impacts` are reached; None: all of them.

    The same for any number of workers: results are taken in the order of the sources. After Ctrl-C, what there is until then.
    tell: is called after each source, with its number from 1 on and the tally.
    """
    total, lost = no_totals(), list[tuple[str, str]]()
    try:
        with closing(_results(sources, workers)) as results:
            for number, result in enumerate(results):
                if isinstance(result, Lost):
                    lost.append((sources[number].name, result.why))
                else:
                    total = total.plus(result)
                tell(number + 1, total)
                if impacts is not None and total.impacts >= impacts:
                    break
    except KeyboardInterrupt:
        return CertificationRun(total, tuple(lost), partial=True)
    return CertificationRun(total, tuple(lost))


def _results(sources: Sequence[ClaimSource], workers: int) -> Generator[Totals | Lost, None, None]:
    """A result for each source, in order."""
    if workers == 1:
        yield from map(totals_of, sources)
    else:
        yield from _in_order(results_of(totals_of, sources, workers))


def _in_order(results: Iterator[tuple[int, Totals | Lost]]) -> Iterator[Totals | Lost]:
    """Numbered results in the order of their numbers; what comes early waits."""
    early: dict[int, Totals | Lost] = {}
    number = 0
    for found, result in results:
        early[found] = result
        while number in early:
            yield early.pop(number)
            number += 1
