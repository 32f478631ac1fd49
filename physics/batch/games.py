"""The loop over games and ticks: what is compiled besides the physics itself.

The state of all games is arrays. `play` does for each game what `physics.advance` does in a sequence of ticks, by the same
functions. Three pieces of `advance` cannot be compiled as they stand, since they build and compare tuples whose length is
known at run time only, and are written here on arrays and lists: flying freely, moving balls out of material, and remembering
the free flight (`known`, `free`). `tests/physics/test_batch.py` compares them with `advance` at every tick.
"""

import math
from typing import NamedTuple

from physics.batch.arrays import Floats, Games, Integers, Layers
from physics.batch.hits import Rows
from physics.escape import freed
from physics.free_flight import clear_time, may_be_steered
from physics.shapes import Ball, Ring
from physics.step import AT_START, LOOK_AHEAD, Course, answer_impacts
from physics.tolerances import ANGLE_GRID, MAX_IMPACTS, SMALLEST

_STARTED = 0.5 * SMALLEST
"""rad/s: for the free flight, of a ring at rest that may be started. No ring has it: what is below SMALLEST is 0."""
_WHOLE_TURN = int(math.tau * ANGLE_GRID)
"""In lines of the angle grid."""
_MARGIN = 1e-6
"""Ticks. How much longer than whole ticks the look-ahead is, so that no rounding takes a tick from it."""

UNKNOWN, CLEAR, ENDING = 0, 1, 2
"""What `Games.known` says of a game.

UNKNOWN: nothing. CLEAR: no ball overlaps anything. ENDING: nor that, and after the free ticks something may be touched.
"""


class Workspace(NamedTuple):
    """Room for what one game needs, written over for every game: lists that are made anew cost more than all their contents.

    Attributes:
        balls: of the game.
        rings: of the game.
        courses: one for each ball.
    """

    balls: list[Ball]
    rings: list[Ring]
    courses: list[Course]


def workspace(games: Games) -> Workspace:
    """Room for any of these games, of which there is at least one."""
    return Workspace(
        [Ball(games.positions[0, i], games.velocities[0, i], games.ball_radii[0, i]) for i in range(games.positions.shape[1])],
        [ring_of(games, 0, k) for k in range(games.spins.shape[1])],
        [AT_START for _ in range(games.positions.shape[1])],
    )


def steer(games: Games, spins: Floats, first: int, last: int) -> None:
    """Give the rings of the games from `first` to below `last` these spins, (G, K), rad/s; forget what that makes untrue."""
    room = workspace(games)
    balls, rings = room.balls, room.rings
    for g in range(first, last):
        for k in range(len(rings)):
            spin = spins[g, k]
            if spin != games.spins[g, k]:
                if games.known[g] != UNKNOWN:
                    for i in range(len(balls)):
                        balls[i] = Ball(games.positions[g, i], games.velocities[g, i], games.ball_radii[g, i])
                    old = with_turn(rings[k], games.phases[g, k], games.spins[g, k])
                    allowed_for = games.steered[k] > 0
                    if not (allowed_for and may_be_steered(startable(old), with_turn(old, old.phase, spin), balls)):
                        games.known[g], games.free[g] = UNKNOWN, 0
                if games.steered[k] == 0:
                    games.steered[k] = -1
                games.spins[g, k] = spin


def play(  # in pieces that are given the games it takes half as long again: their arrays are counted in and out
    games: Games, first: int, last: int, tick: int, ticks: int, dt: float, speed: float, rows: Rows, room: Workspace
) -> tuple[int, int]:
    """Advance the games from `first` to below `last` to tick number `ticks`, the first of them from tick number `tick`.

    Hits are added to the rows. Returns the game and tick to go on with, once there are more rows; the game is `last` when all
    is done.
    """
    known, free, positions, velocities, radii = games.known, games.free, games.positions, games.velocities, games.ball_radii
    phases, spins, all_layers, steered = games.phases, games.spins, games.layers, games.steered
    balls, rings, courses, now = room.balls, room.rings, room.courses, rows.now
    most = len(rows.hits) - 2 * MAX_IMPACTS * len(balls)
    for g in range(first, last):
        while tick < ticks:
            number = min(free[g], ticks - tick)
            if number > 0:
                for i in range(len(balls)):
                    positions[g, i] = _flown_freely(positions[g, i], velocities[g, i], number, dt)
                for k in range(len(rings)):
                    if spins[g, k] != 0.0:
                        phases[g, k] = turned(phases[g, k], spins[g, k], number, dt)
                free[g] -= number
                tick += number
                continue
            if now[0] > most:
                return g, tick
            for i in range(len(balls)):
                balls[i] = Ball(positions[g, i], velocities[g, i], radii[g, i])
            for k in range(len(rings)):
                rings[k] = with_turn(rings[k], phases[g, k], spins[g, k])
            layers = all_layers[g]
            moved = 0
            if known[g] != ENDING:
                moved = _free(balls, rings, layers) if known[g] == UNKNOWN else 0
                if moved == 0:
                    free[g], known[g] = _looked_ahead(balls, rings, layers, steered, dt)
                    if free[g] > 0:
                        continue
            now[1], now[2] = g, tick
            dropped = answer_impacts(balls, rings, layers, dt, speed, courses, rows)
            for k in range(len(rings)):
                if spins[g, k] != 0.0:
                    rings[k] = rings[k].turned(dt)
                    phases[g, k] = rings[k].phase
            if dropped > 0:
                moved += _free(balls, rings, layers)
                games.dropped[g] += dropped
            if moved > 0:
                games.freed[g] += moved
            for i in range(len(balls)):
                positions[g, i], velocities[g, i] = balls[i].position, balls[i].velocity
            known[g], free[g] = CLEAR, 0
            tick += 1
        tick = 0
    return last, 0


def play_one_tick(games: Games, g: int, dt: float, speed: float, rows: Rows, room: Workspace) -> None:
    """One tick of one game, its hits in the rows from the first on. Other compiled loops call by it what is compiled already."""
    rows.now[0] = 0
    play(games, g, g + 1, 0, 1, dt, speed, rows, room)


def _flown_freely(position: complex, velocity: complex, ticks: int, dt: float) -> complex:
    """Where a ball is after some ticks in which it touches nothing."""
    ball = Ball(position, velocity, 1.0)  # its radius does not matter
    for _ in range(ticks):
        ball = ball.moved(dt)
    return ball.position


def turned(phase: float, spin: float, ticks: int, dt: float) -> float:
    """The phase of a ring after some ticks, at most LOOK_AHEAD.

    Phases and the turn of a tick lie on the angle grid, on which every sum is exact: one multiplication is all the ticks.
    """
    once = Ring(1.0, 0.5, 0.1, 1, 0.0, spin, 0.0).turned(dt).phase  # its other fields do not matter
    return ((int(phase * ANGLE_GRID) + ticks * int(once * ANGLE_GRID)) % _WHOLE_TURN) / ANGLE_GRID


def startable(ring: Ring) -> Ring:
    """The ring as one that may be started where it rests: it turns, if ever so slowly."""
    return ring if ring.spin != 0.0 else with_turn(ring, ring.phase, _STARTED)


def _looked_ahead(
    balls: list[Ball], rings: list[Ring], layers: Layers, steered: Integers, dt: float
) -> tuple[int, int]:
    """How many ticks are free of any touch, and what is known then. No ball overlaps anything."""
    horizon = (LOOK_AHEAD + _MARGIN) * dt
    seconds = horizon
    for ball in balls:
        seconds = clear_time(ball, rings, layers, seconds, steered)
    return int(seconds / dt), CLEAR if seconds == horizon else ENDING


def _free(balls: list[Ball], rings: list[Ring], layers: Layers) -> int:
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
