"""How the picture is shaken on great moments: a damped swing along one line."""

import cmath
import math
from typing import NamedTuple

from game.rules import BEST_COMBO, TICK, EventKind, Ticked

SHAKE_TICKS = 240
"""Ticks of a blow, in which there is no other: what moves to and fro flashes at its edges, and more than three flashes a second
may harm some players. It has calmed down after half of them."""
_STRENGTHS = {EventKind.BALL_LOST: 0.03, EventKind.LEVEL_CLEARED: 0.014, EventKind.GAME_OVER: 0.02}
"""First offset of the picture, in shares of the ground's radius."""
_BEST_COMBO_STRENGTH = 0.007
_DAMPING = 0.12
"""Seconds in which the swing calms down to 1/e."""
_SWING = math.tau / 0.085
"""Radians per second."""
_CENTRE = 1e-6
"""World units; so near to the centre there is no direction away from it."""
_TURN = 2.4
"""Radians from one tick's direction to the next one's, for what happens at the centre."""


class Shake(NamedTuple):
    """One blow.

    direction: of the first offset: unit, world.
    strength: first offset of the picture, in shares of the ground's radius.
    age: ticks.
    """

    direction: complex
    strength: float
    age: int = 0

    @property
    def offset(self) -> complex:
        """How far the picture is off, in ground radii, y upwards."""
        seconds = self.age * TICK
        return self.direction * self.strength * math.exp(-seconds / _DAMPING) * math.cos(_SWING * seconds)


def after_tick(shake: Shake | None, ticked: Ticked) -> Shake | None:
    """The shake a tick later: the last blow, or none."""
    if shake is not None:
        shake = shake._replace(age=shake.age + 1) if shake.age < SHAKE_TICKS else None
    for event in ticked.events:
        strength = _STRENGTHS.get(event.kind, 0.0)
        if event.kind == EventKind.BRICK_HIT and ticked.game.combo == BEST_COMBO:
            strength = _BEST_COMBO_STRENGTH
        if strength and (shake is None or shake.age == 0):
            shake = Shake(_direction(event.position, ticked.game.tick), strength)
    return shake


def _direction(position: complex, tick: int) -> complex:
    """The direction away from the centre; at the centre any, another one in every tick."""
    return position / abs(position) if abs(position) > _CENTRE else cmath.rect(1.0, _TURN * tick)
