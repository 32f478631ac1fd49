"""The bricks in a row, as the counter shows them: how fresh the last one is, and what is left of a row that ended."""

from typing import NamedTuple

from game.rules import EventKind, Ticked

BUMP_TICKS, ENDED_TICKS = 36, 130


class Streak(NamedTuple):
    """A row of bricks."""

    bricks: int = 0
    age: int = 0  # ticks since its last brick, or since it ended
    ended: bool = False


NO_ROW = Streak()


def after_tick(streak: Streak, ticked: Ticked) -> Streak:
    """The row a tick later."""
    combo = ticked.game.combo
    if any([event.kind == EventKind.BRICK_HIT for event in ticked.events]) and combo:
        return Streak(combo)
    if combo < streak.bricks and not streak.ended:
        return Streak(streak.bricks, 0, True)
    if streak.ended and streak.age >= ENDED_TICKS:
        return Streak(combo)
    return streak._replace(age=streak.age + 1) if streak.bricks else streak
