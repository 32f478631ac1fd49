"""The bricks in a row, as the counter shows them: how long ago the last one was, and what is left of a row that ended."""

from typing import NamedTuple

from game.rules import EventKind, Ticked

BUMP_TICKS, ENDED_TICKS = 36, 130
"""Ticks that the counter is larger after a brick, and that it is still shown after the row ended."""


class Streak(NamedTuple):
    """Bricks in a row.

    bricks: how many.
    age: ticks since the last one, or since the row ended.
    ended: whether a paddle has ended it.
    """

    bricks: int = 0
    age: int = 0
    ended: bool = False


NO_STREAK = Streak()


def after_tick(streak: Streak, ticked: Ticked) -> Streak:
    """The streak a tick later."""
    combo = ticked.game.combo
    if any([event.kind == EventKind.BRICK_HIT for event in ticked.events]) and combo:
        return Streak(combo)
    if combo < streak.bricks and not streak.ended:
        return Streak(streak.bricks, 0, True)
    if streak.ended and streak.age >= ENDED_TICKS:
        return Streak(combo)
    return streak._replace(age=streak.age + 1) if streak.bricks else streak
