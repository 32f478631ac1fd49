"""Words that rise where something happened."""

from typing import NamedTuple

from game.language import grouped, tr, tr_noop
from game.rules import BEST_COMBO, HARMFUL, Event, EventKind, PowerUp, Ticked

POP_TICKS, PLATED_TICKS = 190, 240
"""How long words are visible: points, and other words, which take longer to read."""
_WORDS = {
    EventKind.NUDGED: tr_noop("nudged"),
    EventKind.BALL_LOST: tr_noop("lost"),
    EventKind.LIFE_GAINED: tr_noop("extra life"),
    EventKind.SHIELD_HIT: tr_noop("saved"),
    EventKind.SPEED_UP: tr_noop("faster"),
    EventKind.CORE_BROKEN: tr_noop("the wall falls"),
    EventKind.BRICK_CRUMBLED: tr_noop("crumbled"),
}
POWER_NAMES = {
    PowerUp.MULTI_BALL: tr_noop("three balls"),
    PowerUp.WIDE: tr_noop("wide paddles"),
    PowerUp.NARROW: tr_noop("narrow paddles"),
    PowerUp.SLOW: tr_noop("slow ball"),
    PowerUp.FAST: tr_noop("fast ball"),
    PowerUp.STICKY: tr_noop("sticky paddles"),
    PowerUp.LIFE: tr_noop("extra life"),
    PowerUp.SHIELD: tr_noop("shield"),
    PowerUp.PIERCE: tr_noop("piercing ball"),
}
"""What power-ups are called."""
_GOOD = frozenset({EventKind.LEVEL_CLEARED, EventKind.LIFE_GAINED, EventKind.CORE_BROKEN, EventKind.DROP_CAUGHT})
"""Good news beside bricks."""
_POINTS = frozenset({EventKind.BRICK_HIT, EventKind.BUMPER_HIT})
"""Points have no plate: they are many, and a plate would hide bricks."""
_BY_PADDLE = frozenset({EventKind.DROP_CAUGHT, EventKind.LIFE_GAINED, EventKind.SPEED_UP})
_BAD = frozenset({EventKind.BALL_LOST})
_BEYOND = 1.07
"""Distance of a paddle's words from the centre, as a multiple of the paddle's: outside of it, where they hide no ball."""
_CLOSEST = 1.8
"""World units between the positions of two pops that can be read together."""


class Pop(NamedTuple):
    """A few words where something happened.

    position: world.
    text: the words.
    bad: whether they are bad news.
    age: 0 new to 1 gone.
    weight: of good news: 0 a single brick to 1 a brick of the best combo.
    plate: whether the words stand on a plate of their own, for much may move behind them.
    """

    position: complex
    text: str
    bad: bool
    age: float
    weight: float = 0.0
    plate: bool = False


def after_tick(pops: tuple[Pop, ...], ticked: Ticked) -> tuple[Pop, ...]:
    """The words a tick later."""
    if pops:
        risen = [pop._replace(age=pop.age + 1.0 / (PLATED_TICKS if pop.plate else POP_TICKS)) for pop in pops]
        pops = tuple([pop for pop in risen if pop.age < 1.0])
    new = [
        Pop(_position(event, ticked), text, _is_bad(event), 0.0, _weight(event, ticked.game.combo), event.kind not in _POINTS)
        for event in ticked.events
        if (text := _text(event))
    ]
    return (*[pop for pop in pops if not _covered(pop, new)], *new) if new else pops


def _covered(pop: Pop, new: list[Pop]) -> bool:
    """Whether words make room for newer ones that are close; bad news never does."""
    return not pop.bad and any([abs(other.position - pop.position) < _CLOSEST for other in new])


def _position(event: Event, ticked: Ticked) -> complex:
    """The position of an event's words. Those of a paddle are outside of it, where they hide no ball."""
    position = event.position
    if event.kind == EventKind.SPEED_UP:
        position = next((other.position for other in ticked.events if other.kind == EventKind.PADDLE_HIT), position)
    return position * _BEYOND if event.kind in _BY_PADDLE else position


def _text(event: Event) -> str:
    """The words for an event, in the player's language; none for most."""
    if event.kind in _POINTS:
        return f"+{event.points}"
    if event.kind == EventKind.LEVEL_CLEARED:
        return tr("+{points} bonus").format(points=grouped(event.points))
    if event.kind == EventKind.DROP_CAUGHT and event.power is not None:
        return "" if event.power == PowerUp.LIFE else tr(POWER_NAMES[event.power])  # a life says it itself, if there is one
    return tr(_WORDS[event.kind]) if event.kind in _WORDS else ""


def _is_bad(event: Event) -> bool:
    """Whether an event is bad news."""
    return event.kind in _BAD or (event.kind == EventKind.DROP_CAUGHT and event.power in HARMFUL)


def _weight(event: Event, combo: int) -> float:
    """How good the news is, 0 to 1."""
    if event.kind == EventKind.BRICK_HIT:
        return min(combo / BEST_COMBO, 1.0)
    return float(event.kind in _GOOD)
