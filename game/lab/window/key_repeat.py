"""A key that repeats what it asks for while it is held, counted in the lab's own time.

pygame's repeated key events are not used: they are made while a picture is drawn, and then one short tap of a key counts
several times on a slow computer.
"""

from typing import NamedTuple

from game.lab.window.commands import Command

REPEATED = frozenset({Command.FORWARD, Command.BACK})
"""What is repeated: single steps. Everything else is done once for each press."""
_DELAY, _INTERVAL = 0.4, 0.05
"""Seconds from the press to the first repeat, and between repeats."""


class HeldKey(NamedTuple):
    """A key that is down.

    key: pygame's code. command: what it asks for. wait: seconds until it asks again; None until the first picture after the
    press, so that the time that went by before the press does not count.
    """

    key: int
    command: Command
    wait: float | None = None


def later(held: HeldKey, seconds: float) -> tuple[HeldKey, bool]:
    """The key some seconds later, and whether it asks again: at most once for each picture."""
    if held.wait is None:
        return held._replace(wait=_DELAY), False
    wait = held.wait - seconds
    return (held._replace(wait=wait), False) if wait > 0.0 else (held._replace(wait=_INTERVAL), True)
