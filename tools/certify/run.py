"""A whole run: source after source, by one process or several, until enough impacts are done."""

from collections.abc import Callable, Sequence
from contextlib import closing
from typing import NamedTuple

from tools.certify.sources import ClaimSource
from tools.certify.totals import Totals, no_totals, totals_of
from tools.executor import Lost, Where, results


class CertificationRun(NamedTuple):
    """What a run came to. lost: sources without a result, and why. partial: it was stopped by a signal."""

    tally: Totals
    lost: tuple[tuple[str, str], ...] = ()
    partial: bool = False


def outcome(
    sources: Sequence[ClaimSource], impacts: int | None, workers: Where, on_progress: Callable[[int, Totals], None]
) -> CertificationRun:
    """The sources in their order, until `impacts` are reached; None: all of them.

    The same for any number of workers: results are taken in the order of the sources. After a signal, what there is until then.
    on_progress: is called after each source, with its number from 1 on and the tally.
    """
    total, lost = no_totals(), list[tuple[str, str]]()
    try:
        with closing(results(totals_of, sources, workers)) as answers:
            for number, result in enumerate(answers):
                if isinstance(result, Lost):
                    lost.append((sources[number].name, result.why))
                else:
                    total = total.plus(result)
                on_progress(number + 1, total)
                if impacts is not None and total.impacts >= impacts:
                    break
    except KeyboardInterrupt:
        return CertificationRun(total, tuple(lost), partial=True)
    return CertificationRun(total, tuple(lost))
