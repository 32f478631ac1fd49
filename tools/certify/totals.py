"""What a run came to: certificates counted by verdict and reason, the worst of what was measured, and the doubtful cases."""

from collections import Counter
from typing import NamedTuple

from physics import Feature
from tools.certify.certificate import NORMAL, Certificate, Decision, Reason, certificates
from tools.certify.exact_geometry import use_precision
from tools.certify.sources import ClaimSource

MOST_CASES = 200
"""Doubtful cases of one source that are kept in words. All are counted."""


class Category(NamedTuple):
    """What certificates are counted by. impact: false for a flight that no impact ends."""

    impact: bool
    verdict: Decision
    reason: Reason


class DoubtfulClaim(NamedTuple):
    """A claim that was refuted or not decided. time: seconds after its tick's start; None for a flight without an impact."""

    source: str
    tick: int
    ball: int
    time: float | None
    verdict: Decision
    reason: Reason

    def __str__(self) -> str:
        what = "a flight without an impact" if self.time is None else f"the impact at {self.time!r} s"
        return f"{self.verdict.value}: {self.source}, tick {self.tick}, ball {self.ball}, {what}: {self.reason.value}"


class Totals(NamedTuple):
    """The certificates of some sources.

    features: certified impacts by the reported feature. close: those whose normal is within 1e-14 without any allowance.
    short: those whose flight is not longer than tau. The four maxima are of certified impacts: tau and |t* - t| in seconds,
    the bound of the normal and what it is off by.
    """

    counts: Counter[Category]
    features: Counter[Feature]
    close: int = 0
    short: int = 0
    time_bound: float = 0.0
    time_off: float = 0.0
    normal_bound: float = 0.0
    normal_off: float = 0.0
    ticks: int = 0
    sources: int = 0
    cases: tuple[DoubtfulClaim, ...] = ()

    def number(self, *, impact: bool, verdict: Decision | None = None) -> int:
        """How many impacts, or other flights, there are, of one verdict or of all."""
        return sum([n for kind, n in self.counts.items() if kind.impact == impact and verdict in {None, kind.verdict}])

    @property
    def impacts(self) -> int:
        """All impacts, whatever became of them."""
        return self.number(impact=True)

    @property
    def refuted(self) -> int:
        """Refuted claims, of impacts and of flights without one."""
        return sum([self.number(impact=impact, verdict=Decision.REFUTED) for impact in (True, False)])

    def plus(self, other: "Totals") -> "Totals":
        """Both together."""
        return Totals(
            self.counts + other.counts,
            self.features + other.features,
            self.close + other.close,
            self.short + other.short,
            max(self.time_bound, other.time_bound),
            max(self.time_off, other.time_off),
            max(self.normal_bound, other.normal_bound),
            max(self.normal_off, other.normal_off),
            self.ticks + other.ticks,
            self.sources + other.sources,
            self.cases + other.cases,
        )


def no_totals() -> Totals:
    """The tally of no source."""
    return Totals(Counter(), Counter())


def totals_of(source: ClaimSource) -> Totals:
    """Every certificate of one source."""
    use_precision()
    counts: Counter[Category] = Counter()
    impacts: list[Certificate] = []
    cases: list[DoubtfulClaim] = []
    ticks = 0
    for tick in source.ticks():
        ticks += 1
        for one in certificates(tick):
            counts[Category(one.hit is not None, one.verdict, one.reason)] += 1
            if one.verdict != Decision.CERTIFIED:
                time = None if one.hit is None else one.hit.time
                cases.append(DoubtfulClaim(source.name, one.tick, one.ball, time, one.verdict, one.reason))
            elif one.hit is not None:
                impacts.append(one)
    return Totals(
        counts,
        Counter([one.hit.contact.feature for one in impacts if one.hit is not None]),
        sum([one.normal_off <= NORMAL for one in impacts]),
        sum([one.short for one in impacts]),
        max([one.time_bound for one in impacts], default=0.0),
        max([one.time_off for one in impacts], default=0.0),
        max([one.normal_bound for one in impacts], default=0.0),
        max([one.normal_off for one in impacts], default=0.0),
        ticks,
        1,
        tuple(sorted(cases, key=lambda case: case.verdict != Decision.REFUTED)[:MOST_CASES]),
    )
