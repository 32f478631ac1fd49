"""A held key that does its work again and again, for the few keys where that is wanted.

Counted in the frames' own time, after the frame's events: a key that was only tapped is up again by then, however late the
events come. The system's key repeat, made by a timer, is not used: on a busy machine it fires before the release is read.
"""

from typing import NamedTuple

FIRST = 0.4
"""Seconds from the press to the first repetition."""
NEXT = 0.05
"""Seconds from one repetition to the next."""


class Repeat(NamedTuple):
    """One held key.

    position: its scancode. left: seconds until it acts again; None until the end of the frame in which it was pressed, so that
    the time before the press does not count.
    """

    position: int
    left: float | None = None

    def later(self, seconds: float) -> tuple["Repeat", bool]:
        """The same key a frame later, and whether it acts in this frame: at most once."""
        if self.left is None:
            return self._replace(left=FIRST), False
        left = self.left - max(seconds, 0.0)
        return (self._replace(left=left), False) if left > 0.0 else (self._replace(left=NEXT), True)
