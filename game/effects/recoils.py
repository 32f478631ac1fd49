"""How far a struck paddle is out of its place: a damped spring, outwards first. The rules' paddle never moves.

out(t) = s e^(-t/d) sin(w t)        s the strength of the hit
"""

import math
from typing import NamedTuple

from game.rules import TICK, EventKind, Ticked
from physics import Hit, dot, length

RECOIL_TICKS = 84
_REACH = 0.055
"""Of the ground's radius, before the spring's damping takes half."""
_DAMPING = 0.075
"""Seconds in which the spring calms down to 1/e."""
_SWING = math.tau / 0.3
"""Radians per second."""


class Recoil(NamedTuple):
    """A paddle that was struck."""

    slot: int
    reach: float  # world units
    age: int = 0  # ticks

    @property
    def out(self) -> float:
        """World units that the paddle is farther from the centre than its place."""
        seconds = self.age * TICK
        return self.reach * math.exp(-seconds / _DAMPING) * math.sin(_SWING * seconds)


def after_tick(recoils: tuple[Recoil, ...], ticked: Ticked) -> tuple[Recoil, ...]:
    """The recoils a tick later; a new hit takes the paddle from where it is."""
    if recoils:
        older = [recoil._replace(age=recoil.age + 1) for recoil in recoils]
        recoils = tuple([recoil for recoil in older if recoil.age < RECOIL_TICKS])
    for event in ticked.events:
        if event.kind == EventKind.PADDLE_HIT and event.hit is not None:
            slot = event.hit.slot
            reach = _REACH * ticked.game.level.ground_radius * _squarely(event.hit)
            recoils = (*[recoil for recoil in recoils if recoil.slot != slot], Recoil(slot, reach))
    return recoils


def _squarely(hit: Hit) -> float:
    """How much of the ball's speed goes into the paddle, outwards: 0 to 1, as its inner face is struck straight on."""
    outwards = dot(hit.before, hit.contact.point) / max(length(hit.contact.point) * length(hit.before), 1e-9)
    return min(max(outwards, 0.0), 1.0)
