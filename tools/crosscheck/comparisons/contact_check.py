"""The errors of one contact, gathered while it is compared."""

from tools.crosscheck.comparisons.hit_frame import Moment
from tools.crosscheck.pymunk_model.ring_model import Part, ShapeContact
from tools.crosscheck.results.coverage import CoverageCell
from tools.crosscheck.results.measurements import Compared, ContactVerdict, Measurement
from tools.crosscheck.results.rows import ContactRecord, ContactRows


class ContactCheck:
    """One contact: its moment, what pymunk touches there, and what was compared so far.

    touched: the shape to bounce off; None where pymunk sees nothing near. verdict: the gravest so far.
    """

    def __init__(self, moment: Moment) -> None:
        """Before the first comparison."""
        self.moment = moment
        self.touched: ShapeContact | None = None
        self.verdict = ContactVerdict.EXACT
        self.compared: list[Compared] = []
        self.noted: list[Compared] = []

    @property
    def part(self) -> Part | None:
        """The part of the shape that pymunk touches."""
        return None if self.touched is None else self.touched.shape.part

    def measure(self, compared: Compared) -> None:
        """Take one comparison; its verdict weighs on the contact's."""
        self.compared.append(compared)
        self.verdict = max(self.verdict, compared.verdict)

    def note(self, compared: Compared) -> None:
        """Take a comparison whose error has no bound to be held to: a tie or a graze."""
        self.noted.append(compared)
        self.verdict = max(self.verdict, compared.verdict)

    def add_to(self, rows: ContactRows, cell: CoverageCell | None, *, recorded: bool) -> None:
        """Add everything to a game's rows. recorded: whether the contact gets a record of its own."""
        situation = self.moment.situation(self.part)
        for compared in self.compared:
            row = rows.row(compared.comparison, situation.feature)
            if compared.error == 0.0:
                row.zeros += 1
            elif row.add(compared.error, compared.bound):
                row.worst = Measurement(compared, situation)
            if compared.verdict in {ContactVerdict.RULE, ContactVerdict.UNEXPLAINED}:
                rows.measurements.append(Measurement(compared, situation))
        rows.measurements += [Measurement(compared, situation) for compared in self.noted]
        if self.verdict == ContactVerdict.UNEXPLAINED:
            rows.notice()
        rows.contacts += 1
        rows.verdicts[self.verdict] += 1
        if cell is None:
            return
        rows.cells[cell] += 1
        if recorded:
            hit = self.moment.hit
            answers = (
                hit.contact.point,
                hit.contact.normal,
                hit.before,
                hit.after,
                hit.layers,
                self.verdict,
                cell,
                tuple(self.compared),
            )
            rows.records.append(ContactRecord(situation, *answers))
