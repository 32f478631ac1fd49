"""The loop of the compiled fuzzer: games of one arena that are played and checked, tick by tick. Compiled as a whole."""

import math

import numpy as np
import numpy.typing as npt

from physics.batch.arrays import Floats, Games, Integers
from physics.batch.games import UNKNOWN, play_one_tick, ring_of, steer, workspace
from physics.batch.hits import Rows
from tools.fuzz.compiled.checks import Before, Slots, gap_beside, tick_fault

_STEP = np.uint64(0x9E3779B97F4A7C15)
_FIRST, _SECOND = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
"""Of SplitMix64 (Steele, Lea, Flood 2014)."""
_ROOM = 1e-6
_TRIES = 30
_CALM, _STEADY = 8, 160
"""A ring that turns is steered in one tick of so many; where the free flights do not allow for that, seldom."""


def play_checked(
    games: Games,
    before: Before,
    full: Slots,
    work: Slots,
    spins: Floats,
    counters: npt.NDArray[np.uint64],
    rows: Rows,
    tally: Integers,
    first: int,
    last: int,
    ticks: int,
    dt: float,
    speed: float,
    edge: float,
) -> tuple[int, int, int]:
    """Play the games from `first` to below `last`, balls and phases drawn by chance: game, tick and `Fault` of the first fault.

    Without a fault -1, -1, 0. What happens in a game does not depend on the others.
    before: room; after a fault the tick's start. full: (rings, slots), the layers with which a game begins. work: room.
    spins: (games, rings), room. counters: (games,), the seeds of their chance. rows: room for the hits of a tick.
    tally: (4,), added to: ball-steps, hits, dropped balls, freed. edge: world units, where a ball is lost.
    """
    counter, room = np.empty(1, np.uint64), workspace(games)
    for g in range(first, last):
        counter[0] = counters[g]
        _begin(games, full, counter, speed, edge, g)
        for tick in range(ticks):
            _remember(games, before, g)
            games.dropped[g], games.freed[g] = 0, 0
            play_one_tick(games, g, dt, speed, rows, room)
            count = rows.now[0]
            tally[0] += games.positions.shape[1]
            tally[1] += count
            tally[2] += games.dropped[g]
            tally[3] += games.freed[g]
            fault = tick_fault(before, games, g, rows.hits, count, dt, speed, games.freed[g], games.dropped[g], work)
            if fault != 0:
                return g, tick, fault
            _go_on(games, spins, counter, speed, edge, g)
    return -1, -1, 0


def _begin(games: Games, full: Slots, counter: npt.NDArray[np.uint64], speed: float, edge: float, g: int) -> None:
    """Lay the bricks anew, turn every ring by chance, and serve every ball."""
    for k in range(games.phases.shape[1]):
        games.steered[k] = max(games.steered[k], 0)  # this game's flights know of no steering yet
        games.phases[g, k] = (
            ring_of(games, g, k).turned(chance(counter) * 2.0 * math.pi / max(abs(games.spins[g, k]), 1e-3)).phase
        )
        for slot in range(full.shape[1]):
            games.layers[g, k, slot] = full[k, slot]
    for i in range(games.positions.shape[1]):
        _serve(games, counter, speed, edge, g, i)


def _go_on(games: Games, spins: Floats, counter: npt.NDArray[np.uint64], speed: float, edge: float, g: int) -> None:
    """Serve the balls that are lost, and once in a while steer a ring that turns."""
    for i in range(games.positions.shape[1]):
        p = games.positions[g, i]
        if math.hypot(p.real, p.imag) > edge + 2.0 * games.ball_radii[g, i]:
            _serve(games, counter, speed, edge, g, i)
    another = False
    for k in range(games.spins.shape[1]):
        spins[g, k] = games.spins[g, k]
        calm = _CALM if games.steered[k] > 0 else _STEADY
        if spins[g, k] != 0.0 and chance(counter) * calm * games.spins.shape[1] < 1.0:
            spins[g, k] = (2.0 * chance(counter) - 1.0) * 0.99 * speed / (games.ring_radii[k] + games.half_widths[k])
            another = True
    if another:
        steer(games, spins, g, g + 1)


def _serve(games: Games, counter: npt.NDArray[np.uint64], speed: float, edge: float, g: int, i: int) -> None:
    """Put a ball at a free place, flying in a direction drawn by chance; beyond the edge where no place is found."""
    r = games.ball_radii[g, i]
    position = complex((edge + r) * 1.01, 0.0)
    for _ in range(_TRIES):
        there = chance(counter) * (edge + r) * _unit(counter)
        free = True
        for k in range(games.spins.shape[1]):
            free = free and gap_beside(there, r, ring_of(games, g, k), 0.0, games.layers[g, k], -1) > _ROOM
        if free:
            position = there
            break
    games.positions[g, i], games.velocities[g, i] = position, speed * _unit(counter)
    games.known[g], games.free[g] = UNKNOWN, 0


def _remember(games: Games, before: Before, g: int) -> None:
    """Copy the state of a game."""
    for i in range(len(before.positions)):
        before.positions[i], before.velocities[i] = games.positions[g, i], games.velocities[g, i]
    for k in range(len(before.phases)):
        before.phases[k], before.spins[k] = games.phases[g, k], games.spins[g, k]
        for slot in range(before.layers.shape[1]):
            before.layers[k, slot] = games.layers[g, k, slot]


def _unit(counter: npt.NDArray[np.uint64]) -> complex:
    """A direction of the plane."""
    angle = chance(counter) * 2.0 * math.pi
    return complex(math.cos(angle), math.sin(angle))


def chance(counter: npt.NDArray[np.uint64]) -> float:
    """The next number in [0, 1). Only compiled code wraps around in silence."""
    counter[0] += _STEP
    mixed = (counter[0] ^ (counter[0] >> np.uint64(30))) * _FIRST
    mixed = (mixed ^ (mixed >> np.uint64(27))) * _SECOND
    mixed = mixed ^ (mixed >> np.uint64(31))
    return float(mixed >> np.uint64(11)) * 2.0**-53
