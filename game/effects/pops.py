"""Words that rise where something happened."""

from typing import NamedTuple

from game.rules import BEST_COMBO, Event, EventKind, Ticked

POP_TICKS = 190
_WORDS = {EventKind.NUDGED: "nudged", EventKind.BALL_LOST: "lost"}
_CLOSEST = 1.8
"""World units between the positions of two pops that can be read together."""


class Pop(NamedTuple):
    """A few words where something happened.

    position: world.
    text: the words.
    bad: whether they are bad news.
    age: 0 new to 1 gone.
    weight: of good news: 0 a single brick to 1 a brick of the best combo.
    """

    position: complex
    text: str
    bad: bool
    age: float
    weight: float = 0.0


def after_tick(pops: tuple[Pop, ...], ticked: Ticked) -> tuple[Pop, ...]:
    """The words a tick later."""
    if pops:
        risen = [pop._replace(age=pop.age + 1.0 / POP_TICKS) for pop in pops]
        pops = tuple([pop for pop in risen if pop.age < 1.0])
    new = [
        Pop(event.position, text, event.kind == EventKind.BALL_LOST, 0.0, _weight(event, ticked.game.combo))
        for event in ticked.events
        if (text := _text(event))
    ]
    return (*[pop for pop in pops if not _covered(pop, new)], *new) if new else pops


def _covered(pop: Pop, new: list[Pop]) -> bool:
    """Whether words make room for newer ones that are close; bad news never does."""
    return not pop.bad and any([abs(other.position - pop.position) < _CLOSEST for other in new])


def _text(event: Event) -> str:
    """The words for an event; none for most."""
    if event.kind == EventKind.BRICK_HIT:
        return f"+{event.points}"
    if event.kind == EventKind.LEVEL_CLEARED:
        return f"+{event.points} for the lives left"
    return _WORDS.get(event.kind, "")


def _weight(event: Event, combo: int) -> float:
    """How good the news is, 0 to 1."""
    return min(combo / BEST_COMBO, 1.0) if event.kind == EventKind.BRICK_HIT else float(event.points > 0)
