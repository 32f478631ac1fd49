"""How far a struck paddle is out of its slot: a damped spring, outwards first. The rules' paddle never moves.

out(t) = s e^(-t/d) sin(w t)        s the strength of the hit
"""

import math
from typing import NamedTuple

from game.rules import PADDLES, TICK, EventKind, Ticked
from physics import Hit, dot, length

RECOIL_TICKS = 84
_STRENGTH = 0.055
"""Of a hit straight on, in shares of the ground's radius; the damping leaves about half of it at the farthest."""
_DAMPING = 0.075
"""Seconds in which the spring calms down to 1/e."""
_SWING = math.tau / 0.3
"""Radians per second."""


class Recoil(NamedTuple):
    """A paddle that was struck; of two players who play against each other, the first one's.

    slot: which one.
    strength: of the hit, world units.
    age: ticks.
    """

    slot: int
    strength: float
    age: int = 0

    @property
    def out(self) -> float:
        """World units that the paddle is farther from the centre than its slot; negative while it swings inwards."""
        seconds = self.age * TICK
        return self.strength * math.exp(-seconds / _DAMPING) * math.sin(_SWING * seconds)


def after_tick(recoils: tuple[Recoil, ...], ticked: Ticked) -> tuple[Recoil, ...]:
    """The recoils a tick later; a new hit on the same paddle begins its recoil anew."""
    if recoils:
        older = [recoil._replace(age=recoil.age + 1) for recoil in recoils]
        recoils = tuple([recoil for recoil in older if recoil.age < RECOIL_TICKS])
    for event in ticked.events:
        if event.kind == EventKind.PADDLE_HIT and event.hit is not None and event.hit.ring == PADDLES:
            slot = event.hit.slot
            strength = _STRENGTH * ticked.game.level.ground_radius * _outwards(event.hit)
            recoils = (*[recoil for recoil in recoils if recoil.slot != slot], Recoil(slot, strength))
    return recoils


def _outwards(hit: Hit) -> float:
    """Share of the ball's speed that goes outwards: 1 straight into the paddle's inner face, 0 along it or inwards."""
    outwards = dot(hit.before, hit.contact.point) / max(length(hit.contact.point) * length(hit.before), 1e-9)
    return min(max(outwards, 0.0), 1.0)
