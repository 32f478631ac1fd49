"""All mistakes, one after the other: which comparison catches which, and after how many contacts?"""

from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import closing
from typing import NamedTuple

from tools.crosscheck.comparisons.game import Checked
from tools.crosscheck.games.sources import AIMED, RANDOM, Source
from tools.crosscheck.results.measurements import Comparison, ContactVerdict
from tools.crosscheck.results.rows import ContactRows
from tools.crosscheck.run import Job, check_game
from tools.crosscheck.sabotage.catalogue import MISTAKES, Mistake
from tools.crosscheck.workers import results_of
from tools.executor import Lost, Where

_ENOUGH = 100
"""Unexplained measurements in one game after which its rest says nothing new."""
_GAMES = (("4", 5, 4_000, "autopilot"), ("6", 3, 3_000, "mouse"), (RANDOM, 1, 2_000, "autopilot"))
_AIMED = 1_000


class SabotageResult(NamedTuple):
    """What became of one mistake.

    contacts: compared in all. first: contacts before the first unexplained measurement; None where there was none.
    unexplained: measurements, by comparison. named: what the harness said most often. lost: why a game has no answer, or "".
    """

    mistake: Mistake
    contacts: int
    first: int | None
    unexplained: dict[Comparison, int]
    named: str
    lost: str

    @property
    def caught(self) -> bool:
        """Whether the harness noticed."""
        return self.first is not None

    @property
    def holds(self) -> bool:
        """Whether the mistake was caught, or missed for the reason that is given."""
        return not self.lost and self.caught == (not self.mistake.invisible)


def suite_jobs(names: Sequence[str], seed: int, facets: int) -> list[Job]:
    """The games that are played with each mistake: aimed contacts, two levels, a random arena."""
    sources = [Source(None, AIMED, seed, _AIMED)]
    sources += [Source(None, level, seed - 1 + number, ticks, player) for level, number, ticks, player in _GAMES]
    return [Job(source, facets, None, name, False, _ENOUGH) for name in names for source in sources]


def sabotage_results(
    jobs: Sequence[Job], workers: Where, on_progress: Callable[[int], None] = lambda _: None
) -> list[SabotageResult]:
    """The results of all jobs by mistake. on_progress: called with the number of games done."""
    answers: dict[int, Checked | Lost] = {}
    with closing(results_of(check_game, jobs, workers)) as results:
        for number, answer in results:
            answers[number] = answer
            on_progress(len(answers))
    by_name: dict[str, list[Checked | Lost]] = {}
    for number, job in enumerate(jobs):
        by_name.setdefault(job.sabotage or "", []).append(answers[number])
    return [_result(MISTAKES[name], checked) for name, checked in by_name.items()]


def _result(mistake: Mistake, answers: list[Checked | Lost]) -> SabotageResult:
    """What the games played with one mistake gave together."""
    rows = ContactRows()
    lost = ""
    for answer in answers:
        if isinstance(answer, Lost):
            lost = answer.why
        else:
            rows.merge(answer.rows)
    found = [one.compared for one in rows.measurements if one.compared.verdict == ContactVerdict.UNEXPLAINED]
    words = Counter([compared.what for compared in found])
    counts = Counter([compared.comparison for compared in found])
    named = words.most_common(1)[0][0] if words else ""
    return SabotageResult(mistake, rows.contacts, rows.before_first, dict(counts.most_common()), named, lost)
