"""All that one run of the command found."""

from typing import NamedTuple

from tools.crosscheck.comparisons.convergence import Curve
from tools.crosscheck.comparisons.free_run import FreeRun
from tools.crosscheck.run import Outcome


class Findings(NamedTuple):
    """The comparisons, and what else was asked for."""

    outcome: Outcome
    curves: list[Curve] | None = None  # None: not asked for
    free_runs: list[FreeRun] | None = None

    @property
    def agrees(self) -> bool:
        """Whether every check that was asked for held."""
        curves_hold = self.curves is None or (bool(self.curves) and all(curve.holds for curve in self.curves))
        return self.outcome.agrees and not self.outcome.partial and curves_hold
