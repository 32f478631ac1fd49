"""How many ticks are due: fixed ticks out of whatever time the frames take."""

from typing import NamedTuple

from game.rules import TICK

LONGEST_FRAME = 0.25
"""Seconds; what a stall takes beyond this is forgotten, so that no frame owes more than 60 ticks."""

_MOST_TICKS = round(LONGEST_FRAME / TICK)
"""Also where rounding makes it one more."""


class Due(NamedTuple):
    """What the time that passed amounts to."""

    ticks: int  # to run now
    rest: float  # seconds not yet used, below one tick

    @property
    def alpha(self) -> float:
        """How far the moment to draw lies into the tick after those run, 0 to 1."""
        return min(self.rest / TICK, 1.0)


def due(rest: float, seconds: float) -> Due:
    """The ticks due after some more seconds. rest: seconds left over by the last call."""
    available = rest + min(max(seconds, 0.0), LONGEST_FRAME)
    ticks = min(int(available / TICK), _MOST_TICKS)
    return Due(ticks, max(available - ticks * TICK, 0.0))
