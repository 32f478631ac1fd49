"""How the wall is built up when a level begins: ring after ring from the centre, brick after brick, until the first serve."""

import math

from game.rules import PADDLES, EventKind, Phase, Ticked

ENTRY_TICKS = 190
"""Ticks until the last brick stands."""
_SPREAD = 0.45
"""Share of that time that one ring takes."""
_GLOW_TICKS = 40
"""Ticks for which a brick that has just come glows."""
GLOW = 0.6
"""Of a brick that has just come, in shares of a hit's."""


def after_tick(entry: int | None, ticked: Ticked) -> int | None:
    """Ticks since the wall began to be built; None once it stands, or nobody waits for it any more."""
    game = ticked.game
    started = any([event.kind == EventKind.LEVEL_STARTED for event in ticked.events])
    if game.phase != Phase.SERVING:
        return None
    if started or game.tick == 1:
        return 0
    if entry is None or entry >= ENTRY_TICKS + _GLOW_TICKS:
        return None
    return entry + 1


def arrival(entry: int, ring: int, rings: int, slot: int, slots: int) -> float:
    """How far a brick has come: below 0 it is not there yet, from 0 to 1 it glows less and less, above it is as ever.

    ring, rings: its ring's number in order from the centre, and how many there are; slot, slots: likewise.
    """
    begin = ENTRY_TICKS * (1.0 - _SPREAD) * ring / max(rings - 1, 1)
    due = begin + ENTRY_TICKS * _SPREAD * (slot / slots)
    return math.floor(entry - due) / _GLOW_TICKS


def order(radii: tuple[float, ...]) -> tuple[int, ...]:
    """For every ring of an arena its number in order from the centre; the paddles have none, -1."""
    inwards = sorted(range(PADDLES + 1, len(radii)), key=lambda k: radii[k])
    return tuple([-1 if k == PADDLES else inwards.index(k) for k in range(len(radii))])
