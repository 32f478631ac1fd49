"""What one game's comparisons gave, or those of many games together."""

from tools.crosscheck.comparisons.hit_frame import Moment
from tools.crosscheck.results.cases import Case, Class, Comparison, Key, Samples


class Rows:
    """The table's rows, the contacts by class, and the cases that need a word."""

    def __init__(self) -> None:
        """Start with nothing.

        contacts: hits compared; elsewhere: unexplained places that are no hits; set_free: hits of ticks in which the
        physics put an overlapping ball outside, so that its flight cannot be rebuilt.
        """
        self.samples: dict[Key, Samples] = {}
        self.classes = dict.fromkeys(Class, 0)
        self.cases: list[Case] = []
        self.contacts = 0
        self.elsewhere = 0
        self.set_free = 0

    def row(self, comparison: Comparison, feature: str) -> Samples:
        """The samples of one row."""
        samples = self.samples.get((comparison, feature))
        if samples is None:
            samples = self.samples[comparison, feature] = Samples()
        return samples

    def measure(
        self,
        moment: Moment,
        kind: Class,
        comparison: Comparison,
        what: str,
        measured: tuple[float, float],
        answers: tuple[complex, complex],
    ) -> None:
        """Add one error with its bound to its row, and to the cases if it is unexplained."""
        row = self.row(comparison, moment.feature)
        if row.add(*measured):
            row.worst = moment.case(kind, comparison, what, measured, answers)
        if kind == Class.UNEXPLAINED:
            self.disagree(moment.case(kind, comparison, what, measured, answers))

    @property
    def unexplained(self) -> int:
        """Contacts and other places at which one of the two engines must be wrong."""
        return self.classes[Class.UNEXPLAINED] + self.elsewhere

    def report(self, case: Case) -> None:
        """Keep an unexplained case that is not at a hit."""
        self.elsewhere += 1
        self.disagree(case)

    def disagree(self, case: Case) -> None:
        """Keep a case to list."""
        self.cases.append(case)

    def merge(self, other: "Rows") -> None:
        """Take all that another game gave."""
        for key, samples in other.samples.items():
            self.row(*key).merge(samples)
        for kind, count in other.classes.items():
            self.classes[kind] += count
        self.cases.extend(other.cases)
        self.contacts += other.contacts
        self.elsewhere += other.elsewhere
        self.set_free += other.set_free
