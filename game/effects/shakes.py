"""How the picture is shaken on great moments: a damped swing along one line, in shares of the arena's radius."""

import cmath
import math
from typing import NamedTuple

from game.rules import BEST_COMBO, TICK, EventKind, Ticked

SHAKE_TICKS = 110
_STRENGTHS = {EventKind.BALL_LOST: 0.03, EventKind.LEVEL_CLEARED: 0.014, EventKind.GAME_OVER: 0.02}
_TOP_COMBO_STRENGTH = 0.007
_DAMPING = 0.12
"""Seconds."""
_SWING = math.tau / 0.085
"""Radians per second."""


class Shake(NamedTuple):
    """One blow."""

    way: complex  # unit, world
    strength: float  # share of the ground's radius
    age: int = 0  # ticks

    @property
    def offset(self) -> complex:
        """How far the picture is off, in ground radii, y upwards."""
        seconds = self.age * TICK
        return self.way * self.strength * math.exp(-seconds / _DAMPING) * math.cos(_SWING * seconds)


def after_tick(shake: Shake | None, ticked: Ticked) -> Shake | None:
    """The shake a tick later: the newest blow, or none."""
    if shake is not None:
        shake = shake._replace(age=shake.age + 1) if shake.age < SHAKE_TICKS else None
    for event in ticked.events:
        strength = _STRENGTHS.get(event.kind, 0.0)
        if event.kind == EventKind.BRICK_HIT and ticked.game.combo == BEST_COMBO:
            strength = _TOP_COMBO_STRENGTH
        if strength:
            shake = Shake(_way(event.position, ticked.game.tick), strength)
    return shake


def _way(position: complex, tick: int) -> complex:
    """Away from the centre; of what happened there, any direction."""
    return position / abs(position) if abs(position) > 1e-6 else cmath.rect(1.0, 2.4 * tick)
