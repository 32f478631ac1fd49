"""The compiled batch as a contender of `python -m tools.bench`."""

import time
from random import Random

import numpy as np
from rich.console import Console

from physics import Arena
from physics.batch import Batch, compiled
from physics.batch.compilation import check_numba
from tools.measure.standard_arena import BALL_RADIUS, CHECK_EVERY, GROUND, SPEED, TICK, served


def missing() -> str | None:
    """What is missing for the batch, and how to install it; None where nothing is."""
    try:
        check_numba()
    except ImportError as error:
        return str(error)
    return None


class ManyGames:
    """So many games of one arena, and what its balls did while they were timed."""

    def __init__(self, console: Console, arena: Arena, games: int) -> None:
        with console.status("compiling the physics") as status:
            done = compiled(lambda seconds: status.update(f"compiling the physics: {seconds:.0f} s"))
        self.compiled = f"the batch was {'loaded' if done.cached else 'compiled'} in {done.seconds:.1f} s"
        self._arena, self._chance = arena, Random(1)
        start = [arena._replace(balls=(served(self._chance),)) for _ in range(games)]
        self._batch = Batch(start, dt=TICK, speed=SPEED, ground_radius=GROUND)
        self.name, self.games = f"physics.batch, {sum([ring.count for ring in arena.rings[1:]]):,} bricks", games
        self._ticks = self._hits = self._looks = self._near = 0

    def run(self, ticks: int) -> float:
        """Play some ticks; the seconds are returned that went into serving lost balls, game by game, and into counting."""
        aside = 0.0
        for first in range(0, ticks, CHECK_EVERY):
            steps = self._batch.step(ticks=min(CHECK_EVERY, ticks - first))
            start = time.process_time()
            self._count(len(steps.hits))
            for game in np.flatnonzero(steps.lost[:, 0]).tolist():
                rings = self._batch.arena(game).rings
                self._batch.put(game, Arena((served(self._chance),), rings, self._arena.layers))
            aside += time.process_time() - start
        self._ticks += ticks
        return aside

    def state(self) -> str:
        """How realistic it was: the share of balls in reach of a ring, and the hits."""
        near, hits = self._near / self._looks, self._hits / (self._ticks * self.games)
        return f"{self.name}: {near:.1%} of the balls in a ring's band, {hits:.5f} hits a ball-step"

    def _count(self, hits: int) -> None:
        """Count the hits, and the balls that reach into a ring's band."""
        distance = np.abs(self._batch.positions[:, 0])
        bands = [(np.abs(distance - ring.radius) <= ring.half_width + BALL_RADIUS) for ring in self._arena.rings]
        self._near += int(np.any(bands, axis=0).sum())
        self._looks += self.games
        self._hits += hits
