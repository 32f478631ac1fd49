"""What another engine says of the game's contacts. A picture only: nothing here reaches the rules."""

import math
from collections.abc import Callable
from typing import NamedTuple

from game.language import tr
from game.rules import Ticked

SHOWN_TICKS = 480
"""Ticks that a contact's normals are shown."""
_MOST_SHOWN = 4
"""Contacts shown at once: more would cover each other."""
_LEAST_READABLE = 0.01
"""Degrees; smaller angles are written with an exponent."""


class NormalPair(NamedTuple):
    """The normals that two engines find at one contact: both unit, from the obstacle to the ball.

    point: of the contact, on the obstacle's surface.
    ours: the game's.
    theirs: the other engine's; None where it sees no contact.
    age: 0 new to 1 gone.
    """

    point: complex
    ours: complex
    theirs: complex | None
    age: float = 0.0

    @property
    def angle(self) -> float:
        """Angle between the two, radians; nan where the other engine sees no contact."""
        if self.theirs is None:
            return math.nan
        turn = self.theirs * self.ours.conjugate()
        return abs(math.atan2(turn.imag, turn.real))

    @property
    def text(self) -> str:
        """The angle in words."""
        if self.theirs is None:
            return tr("pymunk: no contact")
        degrees = math.degrees(self.angle)
        return f"{degrees:.2f}°" if degrees >= _LEAST_READABLE else f"{degrees:.0e}°"


Compare = Callable[[Ticked], tuple[NormalPair, ...]]
"""Asks the other engine about every hit of a tick."""


def after(shown: tuple[NormalPair, ...], ticked: Ticked, compare: Compare) -> tuple[NormalPair, ...]:
    """The normals to show one tick later."""
    older = [pair._replace(age=pair.age + 1.0 / SHOWN_TICKS) for pair in shown]
    new = compare(ticked) if ticked.step.hits else ()
    return (*[pair for pair in older if pair.age < 1.0], *new)[-_MOST_SHOWN:]
