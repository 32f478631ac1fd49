"""The compiled batch as a contender of `python -m tools.bench`."""

import os
import time
from collections.abc import Callable
from random import Random

import numpy as np
from rich.console import Console

from physics import Arena
from physics.batch import Batch, compiled
from physics.batch.arrays import Integers
from physics.batch.compilation import check_numba
from tools.measure.contenders import Play
from tools.measure.standard_arena import BALL_RADIUS, CHECK_EVERY, GROUND, SPEED, TICK, arena, served

_FEW = 256
_USUAL, _LARGE = 4096, 65_536
"""Games, and so many that a short step of them is worth being shared by threads."""


def missing() -> str | None:
    """What is missing for the batch, and how to install it; None where nothing is."""
    try:
        check_numba()
    except ImportError as error:
        return str(error)
    return None


class ManyGames:
    """So many games of one arena, and what its balls did while they were timed. rows: what its name says of the rows."""

    def __init__(self, console: Console, state: Arena, games: int, rows: str = "") -> None:
        with console.status("compiling the physics") as status:
            done = compiled(lambda seconds: status.update(f"compiling the physics: {seconds:.0f} s"))
        self.compiled = f"the batch was {'loaded' if done.cached else 'compiled'} in {done.seconds:.1f} s"
        self._arena, self._chance = state, Random(1)
        start = [state._replace(balls=(served(self._chance),)) for _ in range(games)]
        self._batch = Batch(start, dt=TICK, speed=SPEED, ground_radius=GROUND)
        laid = self._batch.layers[0].copy()
        self._layers = laid if (laid > 0).any() else None  # what never breaks need not be laid anew
        self.name, self.games = f"physics.batch, {sum([ring.count for ring in state.rings[1:]]):,} bricks{rows}", games
        if games != _USUAL:
            self.name += f", {games:,} games"
        self._threads, self._is_large = os.cpu_count() or 1, games >= _LARGE
        self._ticks = self._hits = self._looks = self._near = 0

    def plays(self) -> list[Play]:
        """The contenders: one thread, and where there are enough games, all threads, by the clock."""
        one = Play(self.name, self.run, self.games)
        if not self._is_large or self._threads == 1:
            return [one]
        name = f"{self.name}, {self._threads} threads, by the clock"
        return [one, Play(name, lambda ticks: self.run(ticks, self._threads, time.perf_counter), self.games, time.perf_counter)]

    def run(self, ticks: int, threads: int = 1, clock: Callable[[], float] = time.process_time) -> float:
        """Play some ticks; the seconds are returned that went into serving lost balls, game by game, and into counting."""
        aside = 0.0
        for first in range(0, ticks, CHECK_EVERY):
            steps = self._batch.step(ticks=min(CHECK_EVERY, ticks - first), threads=threads)
            start = clock()
            self._count(len(steps.hits))
            self._serve(np.flatnonzero(steps.lost[:, 0]))
            aside += clock() - start
        self._ticks += ticks
        return aside

    def _serve(self, games: Integers) -> None:
        """Bring lost balls back, and lay anew the bricks of their games that can break."""
        balls = [served(self._chance) for _ in games]
        if len(balls) > 0:
            positions, velocities = np.array([[ball.position] for ball in balls]), np.array([[ball.velocity] for ball in balls])
            self._batch.serve(games, positions, velocities, self._layers)

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


def many_bricks(per_row: int) -> Play:
    """A contender: 256 games with so many bricks in each of three rows."""
    games = ManyGames(Console(stderr=True), arena(per_row), _FEW)
    return Play("", games.run, _FEW)


def many_balls(balls: int) -> Play:
    """A contender: 256 games with so many balls each, and 48 bricks. Lost balls come back, and so do the bricks."""
    chance, state = Random(1), arena(16)
    start = [state._replace(balls=tuple([served(chance) for _ in range(balls)])) for _ in range(_FEW)]
    batch = Batch(start, dt=TICK, speed=SPEED, ground_radius=GROUND)

    def run(ticks: int) -> float:
        """Play some ticks; the seconds are returned that went into that."""
        aside = 0.0
        for first in range(0, ticks, CHECK_EVERY):
            steps = batch.step(ticks=min(CHECK_EVERY, ticks - first))
            begun = time.process_time()
            for game, i in np.argwhere(steps.lost).tolist():
                now = batch.arena(game)
                batch.put(game, now._replace(balls=(*now.balls[:i], served(chance), *now.balls[i + 1 :]), layers=state.layers))
            aside += time.process_time() - begun
        return aside

    return Play("", run, _FEW * balls)
