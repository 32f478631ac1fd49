"""All that one run of the command found."""

from typing import NamedTuple

from tools.crosscheck.comparisons.convergence import Curve
from tools.crosscheck.comparisons.free_run import FreeRun
from tools.crosscheck.run import RunResult
from tools.crosscheck.sabotage.suite import SabotageResult


class Findings(NamedTuple):
    """The comparisons, and what else was asked for; None: not asked for."""

    result: RunResult
    curves: list[Curve] | None = None
    free_runs: list[FreeRun] | None = None
    sabotage: list[SabotageResult] | None = None

    @property
    def agrees(self) -> bool:
        """Whether every check that was asked for held."""
        curves_hold = self.curves is None or (bool(self.curves) and all(curve.holds for curve in self.curves))
        mistakes_hold = self.sabotage is None or all(one.holds for one in self.sabotage)
        return self.result.agrees and not self.result.partial and curves_hold and mistakes_hold
