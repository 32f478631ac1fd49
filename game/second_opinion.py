"""What another engine says of the game's contacts. A picture only: nothing here reaches the rules."""

import math
from collections.abc import Callable
from typing import NamedTuple

from game.rules import Ticked

SHOWN_TICKS = 480
_MOST = 4
"""Shown at once: more cover each other."""


class Opinions(NamedTuple):
    """What two engines say of one contact."""

    point: complex  # on the surface
    ours: complex  # unit, from the obstacle to the ball
    theirs: complex | None  # None where the other engine sees no contact
    age: float = 0.0  # 0 new to 1 gone

    @property
    def angle(self) -> float:
        """Angle between the two, radians."""
        if self.theirs is None:
            return math.nan
        turn = self.theirs * self.ours.conjugate()
        return abs(math.atan2(turn.imag, turn.real))

    @property
    def text(self) -> str:
        """The angle as people read it."""
        if self.theirs is None:
            return "pymunk: no contact"
        degrees = math.degrees(self.angle)
        return f"{degrees:.2f}°" if degrees >= 0.01 else f"{degrees:.0e}°"


Compare = Callable[[Ticked], tuple[Opinions, ...]]
"""Asks the other engine about every hit of a tick."""


def after(shown: tuple[Opinions, ...], ticked: Ticked, compare: Compare) -> tuple[Opinions, ...]:
    """The opinions to show one tick later."""
    older = [one._replace(age=one.age + 1.0 / SHOWN_TICKS) for one in shown]
    return (*[one for one in older if one.age < 1.0], *(compare(ticked) if ticked.step.hits else ()))[-_MOST:]
