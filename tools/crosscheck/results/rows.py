"""What one game's comparisons gave, or those of many games together."""

from collections import Counter
from typing import NamedTuple

from tools.crosscheck.results.coverage import CoverageCell
from tools.crosscheck.results.measurements import (
    ANYWHERE,
    Compared,
    Comparison,
    ContactVerdict,
    Key,
    Measurement,
    Samples,
    Situation,
)


class ContactRecord(NamedTuple):
    """One contact: where it was, what the game did, and every error.

    point, normal, before, after: the game's. layers: left in the slot, by the game. compared: in the order of comparison.
    """

    situation: Situation
    point: complex
    normal: complex
    before: complex
    after: complex
    layers: int
    verdict: ContactVerdict
    cell: CoverageCell
    compared: tuple[Compared, ...]


class ContactRows:
    """The table's rows, the contacts by verdict and by cell, and the measurements that need a word.

    contacts: hits compared. elsewhere: unexplained measurements away from hits. freed, dropped: balls that the physics put
    outside material, or stopped for the rest of a tick, confirmed by pymunk. records: one per contact, if they are asked for.
    before_first: contacts compared before the first unexplained measurement; None where there is none.
    """

    def __init__(self) -> None:
        """Start with nothing."""
        self.samples: dict[Key, Samples] = {}
        self.verdicts = dict.fromkeys(ContactVerdict, 0)
        self.cells: Counter[CoverageCell] = Counter()
        self.measurements: list[Measurement] = []
        self.records: list[ContactRecord] = []
        self.contacts = 0
        self.elsewhere = 0
        self.freed = 0
        self.dropped = 0
        self.before_first: int | None = None

    def row(self, comparison: Comparison, feature: str) -> Samples:
        """The samples of one row."""
        samples = self.samples.get((comparison, feature))
        if samples is None:
            samples = self.samples[comparison, feature] = Samples()
        return samples

    @property
    def unexplained(self) -> int:
        """Contacts and other moments at which one of the two engines must be wrong."""
        return self.verdicts[ContactVerdict.UNEXPLAINED] + self.elsewhere

    @property
    def poses(self) -> int:
        """Balls at the end of a tick whose presence was compared."""
        return len(self.row(Comparison.PRESENCE_TICK, ANYWHERE))

    def report(self, measurement: Measurement) -> None:
        """Take a measurement away from hits; it counts as unexplained where its verdict says so."""
        compared = measurement.compared
        row = self.row(compared.comparison, measurement.situation.feature)
        if row.add(compared.error, compared.bound):
            row.worst = measurement
        if compared.verdict == ContactVerdict.UNEXPLAINED:
            self.elsewhere += 1
            self.measurements.append(measurement)
            self.notice()

    def notice(self) -> None:
        """Remember how many contacts there were before something unexplained."""
        if self.before_first is None:
            self.before_first = self.contacts

    def merge(self, other: "ContactRows") -> None:
        """Take all that another game gave."""
        if self.before_first is None and other.before_first is not None:
            self.before_first = self.contacts + other.before_first
        for key, samples in other.samples.items():
            self.row(*key).merge(samples)
        for verdict, count in other.verdicts.items():
            self.verdicts[verdict] += count
        self.cells.update(other.cells)
        self.measurements.extend(other.measurements)
        self.records.extend(other.records)
        self.contacts += other.contacts
        self.elsewhere += other.elsewhere
        self.freed += other.freed
        self.dropped += other.dropped
