"""Comparison f: how a ring stands, rebuilt from the start of the level and the recorded spins."""

import math
from collections.abc import Sequence

from physics import Ring
from tools.crosscheck.games.level_numbers import LevelNumbers
from tools.crosscheck.pymunk_model.rounding import phase_noise


class PhaseBook:
    """The phase that every ring must have, and how far rounding may have taken the game's.

    The bricks' spins are the level's. Of the paddles' recorded spins each is counted in ticks while it lasts; a new one adds
    what the old one has turned.
    """

    def __init__(self, level: LevelNumbers, dt: float) -> None:
        """At the start of a level, whose ticks take dt seconds."""
        self._level, self._dt = level, dt
        self._ticks = 0
        self._spin, self._steady = 0.0, 0  # of the paddles, and the ticks with that spin
        self._turns = [level.rings[0].phase]  # of the paddles before: a sum in two numbers, the second what the first lost
        self._turned = 0.0

    def turn(self, rings: Sequence[Ring]) -> None:
        """One tick."""
        self._ticks += 1
        spin = rings[0][5]
        if spin != self._spin:
            self._fold()
            self._spin = spin
        self._steady += 1

    def is_the_levels(self, k: int, spin: float) -> bool:
        """Whether a ring of bricks turns as the level says."""
        return k == 0 or spin == self._level.rings[k].spin

    def difference(self, k: int, phase: float) -> tuple[float, float]:
        """How far a recorded phase is from the rebuilt one, radians, and the bound that rounding allows."""
        ring = self._level.rings[k]
        if ring.spin is None:
            turn = self._spin * self._dt * self._steady
            rebuilt, turned = math.fsum([*self._turns, turn]), self._turned + abs(turn)
        else:
            turn = ring.spin * self._dt * self._ticks
            rebuilt, turned = ring.phase + turn, abs(turn)
        bound = phase_noise(self._ticks + 1, turned)  # one more for the rounding of the phase at the start
        return abs(math.remainder(rebuilt - phase, math.tau)), bound

    def _fold(self) -> None:
        """Add what the paddles have turned with their last spin."""
        turn = self._spin * self._dt * self._steady
        parts = [*self._turns, turn]
        total = math.fsum(parts)
        self._turns = [total, math.fsum([*parts, -total])]
        self._turned += abs(turn)
        self._steady = 0
