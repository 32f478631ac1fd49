"""The loop over games and ticks: what is compiled besides the physics itself.

The state of all games is arrays. `play` does for each game what `physics.advance` does in a sequence of ticks, by the same
functions. Three pieces of `advance` cannot be compiled as they stand, since they build and compare tuples whose length is
known at run time only, and are written here on arrays: flying freely (`_fly_freely`), moving balls out of material, and
remembering the free flight (`known`, `seconds`). `tests/physics/test_batch.py` compares them with `advance` at every tick.
"""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from physics.escape import freed
from physics.free_flight import clear_time, may_be_steered
from physics.shapes import Ball, Ring
from physics.step import LOOK_AHEAD, Hit, answer_impacts
from physics.tolerances import MAX_IMPACTS

Floats = npt.NDArray[np.float64]
Complexes = npt.NDArray[np.complex128]
Integers = npt.NDArray[np.int64]


class Games(NamedTuple):
    """The state of G games of B balls, K rings and at most S slots a ring; the fields of `Ball` and `Ring`, as arrays.

    Attributes:
        positions: (G, B), world units.
        velocities: (G, B), world units per second.
        ball_radii: (G, B), world units.
        phases: (G, K), radians.
        spins: (G, K), rad/s.
        layers: (G, K, S); what is beyond a ring's count is 0 and never read.
        ring_radii: (K,), world units; this and the following are the same in all games.
        half_widths: (K,), world units.
        half_angles: (K,), radians.
        counts: (K,).
        frictions: (K,).
        known: (G,), 1 where it is known that no ball overlaps anything, as after every step; else 0.
        seconds: (G,), for which no ball touches anything.
        dropped: (G,), balls that used up MAX_IMPACTS since this was set to 0.
        freed: (G,), balls moved out of material since this was set to 0.
    """

    positions: Complexes
    velocities: Complexes
    ball_radii: Floats
    phases: Floats
    spins: Floats
    layers: Integers
    ring_radii: Floats
    half_widths: Floats
    half_angles: Floats
    counts: Integers
    frictions: Floats
    known: Integers
    seconds: Floats
    dropped: Integers
    freed: Integers


def steer(games: Games, spins: Floats, first: int, last: int) -> None:
    """Give the rings of the games from `first` to below `last` these spins, (G, K), rad/s, and forget what that makes untrue."""
    for g in range(first, last):
        for k in range(spins.shape[1]):
            spin = spins[g, k]
            if spin != games.spins[g, k]:
                if games.known[g] != 0:
                    old = _ring(games, g, k)
                    games.spins[g, k] = spin
                    if not may_be_steered(old, _ring(games, g, k), _balls(games, g)):
                        games.known[g] = 0
                games.spins[g, k] = spin


def play(
    games: Games, first: int, last: int, tick: int, ticks: int, dt: float, speed: float, hits: npt.NDArray[Any], count: int
) -> tuple[int, int, int]:
    """Advance the games from `first` to below `last` to tick number `ticks`, the first of them from tick number `tick`.

    hits: rows of `HIT`, of which `count` are filled; filled further. Returns the game and tick to go on with, once there are
    more rows, and the count; the game is `last` when all is done.
    """
    room = 2 * MAX_IMPACTS * games.positions.shape[1]
    for g in range(first, last):
        while tick < ticks:
            free, seconds = 0, games.seconds[g]
            if games.known[g] != 0:
                while tick + free < ticks and dt <= seconds:
                    seconds -= dt
                    free += 1
            if free > 0:
                games.seconds[g] = seconds
                _fly_freely(games, g, free, dt)
                tick += free
            elif not _look_ahead(games, g, dt):
                if count + room > len(hits):
                    return g, tick, count
                count = _flown(games, g, tick, dt, speed, hits, count)
                tick += 1
        tick = 0
    return last, 0, count


def _fly_freely(games: Games, g: int, ticks: int, dt: float) -> None:
    """Move balls and turn rings for some ticks in which nothing is touched."""
    for i in range(games.positions.shape[1]):
        ball = Ball(games.positions[g, i], games.velocities[g, i], games.ball_radii[g, i])
        for _ in range(ticks):
            ball = ball.moved(dt)
        games.positions[g, i] = ball.position
    for k in range(games.spins.shape[1]):
        if games.spins[g, k] != 0.0:
            ring = _ring(games, g, k)
            for _ in range(ticks):
                ring = ring.turned(dt)
            games.phases[g, k] = ring.phase


def _look_ahead(games: Games, g: int, dt: float) -> bool:
    """Find out for how long nothing is touched; whether that is at least a tick.

    A ball that overlaps material is moved out of it first. A free flight that ends within this tick is not asked for anew.
    """
    known, ending = games.known[g] != 0, games.seconds[g] > 0.0
    games.known[g], games.seconds[g] = 1, 0.0
    if known and ending:
        return False
    balls, rings, layers = _balls(games, g), _rings(games, g), games.layers[g]
    if not known and _free(games, g, balls, rings) > 0:
        return False
    seconds = LOOK_AHEAD * dt if known else dt
    for ball in balls:
        seconds = clear_time(ball, rings, layers, seconds)
    if seconds < dt:
        return False
    games.seconds[g] = seconds
    return True


def _flown(games: Games, g: int, tick: int, dt: float, speed: float, hits: npt.NDArray[Any], count: int) -> int:
    """A tick in which something may be touched; the number of hits, those of this tick added."""
    balls, rings, layers = _balls(games, g), _rings(games, g), games.layers[g]
    found, dropped = answer_impacts(balls, rings, layers, dt, speed)
    for hit in found:
        _write(hits[count], g, tick, hit)
        count += 1
    for i in range(len(balls)):
        games.positions[g, i], games.velocities[g, i] = balls[i].position, balls[i].velocity
    for k in range(len(rings)):
        if rings[k].spin != 0.0:
            games.phases[g, k] = rings[k].turned(dt).phase
    if dropped > 0:
        games.dropped[g] += dropped
        _free(games, g, balls, _rings(games, g))
    return count


def _free(games: Games, g: int, balls: list[Ball], rings: list[Ring]) -> int:
    """Move the balls that overlap material out of it; how many there were."""
    number = 0
    for i in range(len(balls)):
        ball = freed(balls[i], rings, games.layers[g])
        if ball.position != balls[i].position:
            games.positions[g, i] = ball.position
            number += 1
    games.freed[g] += number
    return number


def _balls(games: Games, g: int) -> list[Ball]:
    """The balls of a game."""
    return [
        Ball(games.positions[g, i], games.velocities[g, i], games.ball_radii[g, i]) for i in range(games.positions.shape[1])
    ]


def _rings(games: Games, g: int) -> list[Ring]:
    """The rings of a game."""
    return [_ring(games, g, k) for k in range(games.spins.shape[1])]


def _ring(games: Games, g: int, k: int) -> Ring:
    """A ring of a game."""
    return Ring(
        games.ring_radii[k],
        games.half_widths[k],
        games.half_angles[k],
        int(games.counts[k]),
        games.phases[g, k],
        games.spins[g, k],
        games.frictions[k],
    )


def _write(row: Any, g: int, tick: int, hit: Hit) -> None:
    """Fill one row of `HIT`."""
    row["game"], row["tick"], row["time"] = g, tick, hit.time
    row["ball"], row["ring"], row["slot"], row["layers"] = hit.ball, hit.ring, hit.slot, hit.layers
    row["normal"], row["point"], row["gap"] = hit.contact.normal, hit.contact.point, hit.contact.gap
    row["feature"] = hit.contact.feature.value
    row["before"], row["after"] = hit.before, hit.after
