"""The loop over games and ticks: what is compiled besides the physics itself.

The state of all games is arrays. `play` does for each game what `physics.advance` does in a sequence of ticks, by the same
functions. Three pieces of `advance` cannot be compiled as they stand, since they build and compare tuples whose length is
known at run time only, and are written here on arrays and lists: flying freely, moving balls out of material, and remembering
the free flight (`known`, `seconds`). `tests/physics/test_batch.py` compares them with `advance` at every tick.
"""

from typing import Any

import numpy.typing as npt

from physics.batch.arrays import Complexes, Floats, Games, Integers
from physics.escape import freed
from physics.free_flight import clear_time, may_be_steered
from physics.shapes import Ball, Ring
from physics.step import LOOK_AHEAD, Hit, answer_impacts
from physics.tolerances import MAX_IMPACTS, SMALLEST

_STARTED = 0.5 * SMALLEST
"""rad/s: for the free flight, of a ring at rest that may be started. No ring has it: what is below SMALLEST is 0."""


def steer(games: Games, spins: Floats, first: int, last: int) -> None:
    """Give the rings of the games from `first` to below `last` these spins, (G, K), rad/s; forget what that makes untrue."""
    balls, rings = _balls(games, first), _rings(games, first)
    for g in range(first, last):
        for k in range(len(rings)):
            spin = spins[g, k]
            if spin != games.spins[g, k]:
                if games.known[g] != 0:
                    for i in range(len(balls)):
                        balls[i] = Ball(games.positions[g, i], games.velocities[g, i], games.ball_radii[g, i])
                    old = with_turn(rings[k], games.phases[g, k], games.spins[g, k])
                    if not may_be_steered(startable(old, games.steered[k]), with_turn(old, old.phase, spin), balls):
                        games.known[g] = 0
                if games.spins[g, k] == 0.0 and games.steered[k] == 0:
                    games.steered[k] = -1
                games.spins[g, k] = spin


def play(
    games: Games, first: int, last: int, tick: int, ticks: int, dt: float, speed: float, hits: npt.NDArray[Any], count: int
) -> tuple[int, int, int]:
    """Advance the games from `first` to below `last` to tick number `ticks`, the first of them from tick number `tick`.

    hits: rows of `HIT`, of which `count` are filled; filled further. Returns the game and tick to go on with, once there are
    more rows, and the count; the game is `last` when all is done.
    """
    known, remaining, positions, velocities = games.known, games.seconds, games.positions, games.velocities
    phases, spins, radii = games.phases, games.spins, games.ball_radii
    balls, rings = _balls(games, first), _rings(games, first)  # written over for every game: a new list costs more
    room = 2 * MAX_IMPACTS * len(balls)
    for g in range(first, last):
        while tick < ticks:
            free, remaining[g] = ticks_of_free_flight(known[g] != 0, remaining[g], dt, ticks - tick)
            if free > 0:
                fly_freely(positions, velocities, radii, phases, spins, g, free, dt)
                tick += free
                continue
            if count + room > len(hits):
                return g, tick, count
            _read(balls, rings, positions, velocities, radii, phases, spins, g)
            layers = games.layers[g]
            moved, seconds = _looked_ahead(known[g] != 0, remaining[g], balls, rings, layers, games.steered, dt)
            known[g], remaining[g] = 1, seconds
            if seconds >= dt:
                continue
            found, dropped = answer_impacts(balls, rings, layers, dt, speed)
            for hit in found:
                _write(hits[count], g, tick, hit)
                count += 1
            for k in range(len(rings)):
                rings[k] = rings[k].turned(dt) if rings[k].spin != 0.0 else rings[k]
                phases[g, k] = rings[k].phase
            if dropped > 0:
                moved += _free(balls, rings, layers)
            for i in range(len(balls)):
                positions[g, i], velocities[g, i] = balls[i].position, balls[i].velocity
            games.dropped[g] += dropped
            games.freed[g] += moved
            tick += 1
        tick = 0
    return last, 0, count


def play_one_tick(games: Games, g: int, dt: float, speed: float, hits: npt.NDArray[Any]) -> int:
    """One tick of one game; how many rows of hits it filled. Other compiled loops call by it the machine code of `play`."""
    _, _, count = play(games, g, g + 1, 0, 1, dt, speed, hits, 0)
    return count


def ticks_of_free_flight(known: bool, seconds: float, dt: float, most: int) -> tuple[int, float]:  # noqa: FBT001
    """How many of the next ticks, at most so many, touch nothing, and the seconds of free flight after them."""
    free = 0
    while known and free < most and dt <= seconds:
        seconds -= dt
        free += 1
    return free, seconds


def fly_freely(
    positions: Complexes, velocities: Complexes, radii: Floats, phases: Floats, spins: Floats, g: int, ticks: int, dt: float
) -> None:
    """Move balls and turn rings for some ticks in which nothing is touched."""
    for i in range(positions.shape[1]):
        positions[g, i] = _flown_freely(Ball(positions[g, i], velocities[g, i], radii[g, i]), ticks, dt).position
    for k in range(spins.shape[1]):
        if spins[g, k] != 0.0:
            phases[g, k] = turned(phases[g, k], spins[g, k], ticks, dt)


def _flown_freely(ball: Ball, ticks: int, dt: float) -> Ball:
    """The ball after some ticks in which it touches nothing."""
    for _ in range(ticks):
        ball = ball.moved(dt)
    return ball


def turned(phase: float, spin: float, ticks: int, dt: float) -> float:
    """The phase of a ring after some ticks."""
    ring = Ring(1.0, 0.5, 0.1, 1, phase, spin, 0.0)  # its other fields do not matter
    for _ in range(ticks):
        ring = ring.turned(dt)
    return ring.phase


def _read(
    balls: list[Ball],
    rings: list[Ring],
    positions: Complexes,
    velocities: Complexes,
    radii: Floats,
    phases: Floats,
    spins: Floats,
    g: int,
) -> None:
    """Write the balls and rings of a game over those of another."""
    for i in range(len(balls)):
        balls[i] = Ball(positions[g, i], velocities[g, i], radii[g, i])
    for k in range(len(rings)):
        rings[k] = with_turn(rings[k], phases[g, k], spins[g, k])


def startable(ring: Ring, steered: int) -> Ring:
    """The ring as the free flight takes it: one at rest that may be started turns, if ever so slowly."""
    return with_turn(ring, ring.phase, _STARTED) if steered > 0 and ring.spin == 0.0 else ring


def _looked_ahead(
    known: bool,  # noqa: FBT001
    remaining: float,
    balls: list[Ball],
    rings: list[Ring],
    layers: Any,
    steered: Integers,
    dt: float,
) -> tuple[int, float]:
    """How many balls were moved out of material, in place, and the seconds of free flight; 0 where they are less than a tick.

    known: whether no ball overlaps anything. A flight that ends within this tick is not asked for anew.
    """
    if known and remaining > 0.0:
        return 0, 0.0
    moved = 0 if known else _free(balls, rings, layers)
    if moved > 0:
        return moved, 0.0
    seconds = LOOK_AHEAD * dt if known else dt
    for k in range(len(rings)):
        rings[k] = startable(rings[k], steered[k])
    for ball in balls:
        seconds = clear_time(ball, rings, layers, seconds)
    for k in range(len(rings)):
        rings[k] = rings[k] if rings[k].spin != _STARTED else with_turn(rings[k], rings[k].phase, 0.0)
    return 0, seconds if seconds >= dt else 0.0


def _free(balls: list[Ball], rings: list[Ring], layers: Any) -> int:
    """Move the balls that overlap material out of it, in place; how many there were."""
    number = 0
    for i in range(len(balls)):
        ball = freed(balls[i], rings, layers)
        if ball.position != balls[i].position:
            balls[i] = ball
            number += 1
    return number


def with_turn(ring: Ring, phase: float, spin: float) -> Ring:
    """The ring with another phase and spin."""
    return Ring(ring.radius, ring.half_width, ring.half_angle, ring.count, phase, spin, ring.friction)


def _balls(games: Games, g: int) -> list[Ball]:
    """The balls of a game."""
    return [
        Ball(games.positions[g, i], games.velocities[g, i], games.ball_radii[g, i]) for i in range(games.positions.shape[1])
    ]


def _rings(games: Games, g: int) -> list[Ring]:
    """The rings of a game."""
    return [ring_of(games, g, k) for k in range(games.spins.shape[1])]


def ring_of(games: Games, g: int, k: int) -> Ring:
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
