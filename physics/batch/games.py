"""The loop over games and ticks: what is compiled besides the physics itself.

The state of all games is stored in arrays. `play` does for each game what `physics.advance` does in a sequence of ticks, with
the same functions. Three parts of `advance` cannot be compiled, since they build and compare tuples of a length unknown to the
compiler; they are written here on arrays and lists: flying freely, moving balls out of material, and remembering the free
flight (`known`, `free`). `tests/physics/batch/test_batch.py` compares them with `advance` at every tick.
"""

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from physics.batch.arrays import Complexes, Floats, Games
from physics.batch.hits import Rows
from physics.broad_phase import has_left, in_band
from physics.escape import freed
from physics.free_flight import clear_time, may_be_steered
from physics.shapes import Ball, Ring
from physics.step import AT_START, Course, answer_impacts
from physics.tolerances import ANGLE_GRID, MAX_IMPACTS, SMALLEST
from physics.vectors import length

_STARTED = 0.5 * SMALLEST
"""rad/s: for the free flight, of a ring at rest that may be started. No ring has it: what is below SMALLEST is 0."""
_WHOLE_TURN = int(math.tau * ANGLE_GRID)
"""In lines of the angle grid."""
_LOOK_AHEAD = 1024
"""Ticks: how far ahead the free flight is computed. So many turns of a tick, in lines of the angle grid, are below 2^63."""
_MARGIN = 1e-6
"""Ticks. How much longer than whole ticks the look-ahead is, so that no rounding takes a tick from it."""

_AT_ONCE = 4

UNKNOWN, CLEAR, ENDING = 0, 1, 2
"""What `Games.known` says of a game.

UNKNOWN: nothing. CLEAR: no ball overlaps anything. ENDING: nor that, and after the free ticks something is touched, as far as
that can be told.
"""


class Workspace(NamedTuple):
    """Memory for one game, overwritten for every game, since allocating lists costs more than filling them.

    Attributes:
        balls: of the game.
        rings: of the game.
        courses: one for each ball.
        outward: the rings' numbers, the innermost first.
        order: the rings' numbers, in the order in which the free flight examines them.
    """

    balls: list[Ball]
    rings: list[Ring]
    courses: list[Course]
    outward: list[int]
    order: list[int]


def workspace(games: Games) -> Workspace:
    """Room for any of these games, of which there is at least one."""
    return Workspace(
        [Ball(games.positions[0, i], games.velocities[0, i], games.ball_radii[0, i]) for i in range(games.positions.shape[1])],
        [ring_of(games, 0, k) for k in range(games.spins.shape[1])],
        [AT_START for _ in range(games.positions.shape[1])],
        _outward(games),
        [k for k in range(games.spins.shape[1])],  # noqa: C416  # what compiles
    )


def _outward(games: Games) -> list[int]:
    """The rings' numbers, the innermost first."""
    numbers = [k for k in range(games.spins.shape[1])]  # noqa: C416  # what compiles
    for last in range(1, len(numbers)):
        for n in range(last, 0, -1):
            if games.ring_radii[numbers[n]] < games.ring_radii[numbers[n - 1]]:
                numbers[n], numbers[n - 1] = numbers[n - 1], numbers[n]
    return numbers


def steer(games: Games, spins: Floats, first: int, last: int) -> None:
    """Give the rings of the games from `first` to below `last` these spins, (G, K), rad/s; forget free flights that these end.

    Spins below SMALLEST are stored as 0.
    """
    room = workspace(games)
    balls, rings = room.balls, room.rings
    for g in range(first, last):
        for k in range(len(rings)):
            spin = spins[g, k] if abs(spins[g, k]) >= SMALLEST else 0.0
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


def step(
    games: Games,
    first: int,
    last: int,
    begun: int,
    ticks: int,
    dt: float,
    speed: float,
    ground_radius: float,
    rows: Rows,
    lost: npt.NDArray[np.bool_],
) -> int:
    """Advance the games from `first` to below `last` by some ticks.

    begun: -1; or, in a further call for the same ticks, the game that the one before returned, since its rows were full. `last`
    is returned when all is done. rows: hits are added. lost: (games, balls), written: which are outside of the ground.
    """
    if begun < 0:
        _fly_freely(games, first, last, ticks, dt)
    game = play(games, max(begun, first), last, ticks, dt, speed, rows, workspace(games))
    if game == last:
        _find_lost(games, first, last, ground_radius, lost)
    return game


def _fly_freely(games: Games, first: int, last: int, ticks: int, dt: float) -> None:  # noqa: C901  # as `play`
    """Advance the games from `first` to below `last` in which no ball touches anything in `ticks`; the others not at all.

    Every sum of a ball must wait for the sum before it, so that four balls at a time take no longer than one.
    """
    positions, velocities, radii = games.positions.ravel(), games.velocities.ravel(), games.ball_radii.ravel()  # views
    phases, spins, free, played = games.phases, games.spins, games.free, games.played
    count, waiting = games.positions.shape[1], 0
    a = b = c = d = 0  # four balls, numbered through all games
    spin, lines = 0.0, 0  # of the previous ring: most rings have the same spin
    for g in range(first, last):
        if free[g] < ticks:
            played[g] = 0
            continue
        played[g] = ticks
        free[g] -= ticks
        for k in range(spins.shape[1]):
            if spins[g, k] != 0.0:
                if spins[g, k] != spin:
                    spin = spins[g, k]
                    lines = lines_turned(spin, ticks, dt)
                phases[g, k] = turned(phases[g, k], lines)
        for i in range(count):
            a, b, c, d = b, c, d, g * count + i
            waiting += 1
            if waiting == _AT_ONCE:
                _fly_four(positions, velocities, radii, a, b, c, d, ticks, dt)
                waiting = 0
    for n in (d, c, b):
        if waiting > 0:
            one = Ball(positions[n], velocities[n], radii[n])
            for _ in range(ticks):
                one = one.moved(dt)
            positions[n] = one.position
            waiting -= 1


def _fly_four(
    positions: Complexes, velocities: Complexes, radii: Floats, a: int, b: int, c: int, d: int, ticks: int, dt: float
) -> None:
    """Move four balls, given their numbers."""
    at, v, r = positions, velocities, radii
    one, two, three, four = Ball(at[a], v[a], r[a]), Ball(at[b], v[b], r[b]), Ball(at[c], v[c], r[c]), Ball(at[d], v[d], r[d])
    for _ in range(ticks):
        one, two, three, four = one.moved(dt), two.moved(dt), three.moved(dt), four.moved(dt)
    at[a], at[b], at[c], at[d] = one.position, two.position, three.position, four.position


def _find_lost(games: Games, first: int, last: int, ground_radius: float, lost: npt.NDArray[np.bool_]) -> None:
    """Write which balls of the games from `first` to below `last` are outside of the ground."""
    positions, radii, outside = games.positions.ravel(), games.ball_radii.ravel(), lost.ravel()  # views
    count = games.positions.shape[1]
    for n in range(first * count, last * count):
        outside[n] = has_left(positions[n], radii[n], ground_radius)


def play(  # noqa: C901, PLR0912  # given to functions, the arrays of the games are counted in and out: twice as slow
    games: Games, first: int, last: int, ticks: int, dt: float, speed: float, rows: Rows, room: Workspace
) -> int:
    """Advance the games from `first` to below `last` until each has `ticks` in `games.played`.

    Hits are added to the rows. Returns the game to go on with, once there are more rows; `last` when all is done.
    """
    known, free, positions, velocities, radii = games.known, games.free, games.positions, games.velocities, games.ball_radii
    phases, spins, all_layers, steered = games.phases, games.spins, uncounted(games.layers), uncounted(games.steered)
    rows = Rows(uncounted(rows.hits), uncounted(rows.now))
    balls, rings, courses, now, played = room.balls, room.rings, room.courses, rows.now, games.played
    outward, order = room.outward, room.order
    most = len(rows.hits) - 2 * MAX_IMPACTS * len(balls)
    for g in range(first, last):
        tick = played[g]
        while tick < ticks:
            number = min(free[g], ticks - tick)
            if number > 0:
                for i in range(len(balls)):
                    ball = Ball(positions[g, i], velocities[g, i], radii[g, i])
                    for _ in range(number):
                        ball = ball.moved(dt)
                    positions[g, i] = ball.position
                for k in range(len(rings)):
                    if spins[g, k] != 0.0:
                        phases[g, k] = turned(phases[g, k], lines_turned(spins[g, k], number, dt))
                free[g] -= number
                tick += number
                continue
            if now[0] > most:
                played[g] = tick
                return g
            for i in range(len(balls)):
                balls[i] = Ball(positions[g, i], velocities[g, i], radii[g, i])
            for k in range(len(rings)):
                rings[k] = with_turn(rings[k], phases[g, k], spins[g, k])
            layers: Any = all_layers[g]
            moved = 0
            if known[g] != ENDING:
                moved = _free(balls, rings, layers) if known[g] == UNKNOWN else 0
                if moved == 0:
                    free[g], known[g] = _looked_ahead(balls, rings, layers, steered, dt, outward, order)
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
        played[g] = ticks
    return last


def uncounted(array: Any) -> Any:
    """The array itself. Compiled, it is one to which numba counts no references.

    numba counts them atomically, for every row of an array and for every array given to a function. Who calls `play` holds the
    arrays until it returns.
    """
    return array


def play_one_tick(games: Games, g: int, dt: float, speed: float, rows: Rows, room: Workspace) -> None:
    """One tick of one game, its hits in the rows from the first on. By it other compiled loops call what is compiled."""
    rows.now[0], games.played[g] = 0, 0
    play(games, g, g + 1, 1, dt, speed, rows, room)


def lines_turned(spin: float, ticks: int, dt: float) -> int:
    """The turn of a ring in some ticks, at most _LOOK_AHEAD, as a number of lines of the angle grid, without whole turns.

    The turn of a tick lies on the grid, on which sums are exact, so a multiplication gives the same bits as the sum of all
    ticks.
    """
    once = Ring(1.0, 0.5, 0.1, 1, 0.0, spin, 0.0).turned(dt).phase  # its other fields do not matter
    return (ticks * int(once * ANGLE_GRID)) % _WHOLE_TURN


def turned(phase: float, lines: int) -> float:
    """The phase of a ring after a turn by some lines of the angle grid, from 0 to below a whole turn."""
    there = int(phase * ANGLE_GRID) + lines
    return (there - _WHOLE_TURN if there >= _WHOLE_TURN else there) / ANGLE_GRID


def startable(ring: Ring) -> Ring:
    """The ring with a tiny spin if it is at rest, so that it counts as one whose spin may change."""
    return ring if ring.spin != 0.0 else with_turn(ring, ring.phase, _STARTED)


def _looked_ahead(
    balls: list[Ball], rings: list[Ring], layers: Any, steered: Any, dt: float, outward: list[int], order: list[int]
) -> tuple[int, int]:
    """The number of ticks without any touch, and what is known after them. Before them no ball overlaps anything."""
    horizon = (_LOOK_AHEAD + _MARGIN) * dt
    seconds = horizon
    for ball in balls:
        _order_from(length(ball.position), rings, outward, order)
        seconds = clear_time(ball, rings, layers, seconds, steered, order)
    is_known = seconds < horizon and not _may_be_steered_away(balls, rings, steered, seconds, dt)
    return int(seconds / dt), ENDING if is_known else CLEAR


def _order_from(distance: float, rings: list[Ring], outward: list[int], order: list[int]) -> None:
    """Sort the rings as a ball at a distance from the centre meets them: inwards the smaller ones, then outwards the others."""
    n = 0
    for m in range(len(outward) - 1, -1, -1):
        if rings[outward[m]].radius <= distance:
            order[n] = outward[m]
            n += 1
    for k in outward:
        if rings[k].radius > distance:
            order[n] = k
            n += 1


def _may_be_steered_away(balls: list[Ball], rings: list[Ring], steered: Any, seconds: float, dt: float) -> bool:
    """Whether after some seconds a ball is near the band of a ring that may be steered.

    Then the free flight most often ends because the ring might have been turned fast, and not by a touch. Computing another
    free flight costs less than searching a tick without a hit.
    """
    for ball in balls:
        distance, reach = length(ball.moved(seconds).position), ball.radius + length(ball.velocity) * dt
        for k in range(len(rings)):
            if steered[k] != 0 and in_band(distance, reach, rings[k]):
                return True
    return False


def _free(balls: list[Ball], rings: list[Ring], layers: Any) -> int:
    """Move the balls that overlap material out of it, in place. Returns how many there were."""
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
