"""The autopilot that `Batch.step` takes."""

import math
from numbers import Integral
from typing import Any

import numpy as np
import numpy.typing as npt

from game.levels import Level
from game.rules import PADDLES, TICK
from physics.batch.arrays import Games, Integers
from physics.batch.hits import Rows
from tools.autopilot.compilation import compiled_autopilot
from tools.autopilot.plans import PLAN
from tools.autopilot.steering import Pilots

_MOST_GAMES = 2**31 - 1
"""As many as environments can be."""


class BatchAutopilot:
    """Steers the paddles of every game of a batch as `game.autopilot.SourcePilot` steers those of one game, to the bit.

    The paddles are ring 0. Of several balls it meets the outermost that is not lost. It does not serve.

    level: how fast its paddles turn at most, and how fast they come to rest. games: how many the batch has.
    Raises ValueError, naming the argument; ImportError, naming the extra, without numba. The first one of a machine takes the
    time to compile.
    """

    def __init__(self, level: Level, games: int) -> None:
        _check(level, games)
        self._step = compiled_autopilot().step
        self._top = math.radians(level.paddles.top_speed)
        self._change = math.radians(level.paddles.acceleration) * TICK
        self._pilots = Pilots(*[np.zeros(games, dtype) for dtype in (PLAN, np.int64, np.int64, np.int64)])
        self._pilots.pointers[:] = -1

    @property
    def ring(self) -> int:
        """Index of the ring that is steered."""
        return PADDLES

    @property
    def pointers(self) -> Integers:
        """(games,), where a paddle was wanted in the last tick, as in `game.rules.Controls`; -1 for nowhere. Read-only."""
        view = self._pilots.pointers.view()
        view.flags.writeable = False
        return view

    def forget(self, games: Any = slice(None)) -> None:
        """Plan anew in some games: after a ball was put elsewhere without having been lost.

        games: an index of an array: a number, numbers, a mask, or a slice. ValueError where it is none of these games.
        """
        try:
            self._pilots.plans["state"][games] = 0
        except IndexError as error:
            raise ValueError(f"games must be an index of {len(self._pilots.plans)} games: {error}") from None

    def check(self, games: int, rings: int, dt: float) -> None:
        """Raise ValueError unless it can steer a batch of so many games and rings in ticks of `dt` seconds."""
        if games != len(self._pilots.plans):
            raise ValueError(f"autopilot must be one of {games} games, not of {len(self._pilots.plans)}")
        if rings <= PADDLES:
            raise ValueError("autopilot needs paddles: arenas without rings have none")
        if dt != TICK:
            raise ValueError(f"autopilot needs ticks of {TICK} s, not {dt}")

    def step(
        self,
        games: Games,
        first: int,
        last: int,
        begun: int,
        ticks: int,
        dt: float,  # noqa: ARG002  # TICK, as `check` makes sure
        speed: float,
        ground_radius: float,
        rows: Rows,
        lost: npt.NDArray[np.bool_],
    ) -> int:
        """As `physics.batch.games.step`."""
        return self._step(
            self._pilots, self._top, self._change, games, first, last, begun, ticks, speed, ground_radius, rows, lost
        )


def _check(level: Any, games: Any) -> None:
    """Refuse what is no level, or no number of games."""
    if not isinstance(level, Level):
        raise ValueError(f"level must be one of game.levels.chosen(...), not {type(level).__name__}")  # noqa: TRY004  # as below
    if not isinstance(games, Integral) or isinstance(games, bool) or not 1 <= int(games) <= _MOST_GAMES:
        raise ValueError(f"games must be a whole number from 1 to {_MOST_GAMES}, not {games!r}")
