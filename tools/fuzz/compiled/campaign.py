"""Cases of the compiled fuzzer: the arenas of `tools.fuzz.arenas`, each in many games at once."""

import functools
import time
from collections.abc import Callable
from inspect import isfunction
from typing import NamedTuple

import numpy as np

import physics
import physics.batch
from physics import Arena, Ball
from physics.batch.arrays import Games, arena_of, arrays_of, no_games
from physics.batch.compilation import check_subnormals, sources_hash, with_progress
from physics.batch.hits import HIT
from physics.tolerances import MAX_IMPACTS
from tools import fuzz
from tools.fuzz import compiled as package
from tools.fuzz import oracle
from tools.fuzz.arenas import TICK, random_case
from tools.fuzz.campaign import Failure, Tally, checked_tick
from tools.fuzz.compiled import checks, play
from tools.fuzz.compiled.checks import Before, Fault

GAMES, TICKS = 64, 200
"""Of a case."""


class CompiledFuzzer(NamedTuple):
    """The compiled loop.

    play: `play.play_checked`. fault: `checks.tick_fault`. gap: `checks.gap_beside`. overlap: `checks.overlap_time`.
    seconds: that compiling took, or loading. cached: whether all was loaded from disk.
    """

    play: Callable[..., tuple[int, int, int]]
    fault: Callable[..., int]
    gap: Callable[..., float]
    overlap: Callable[..., float]
    seconds: float
    cached: bool


def compiled_fuzzer(progress: Callable[[float], None] | None = None) -> CompiledFuzzer:
    """The loop, compiled now unless it was before, or lies on disk. ImportError, naming the extra, without numba."""
    return with_progress(_compiled, progress)


@functools.cache
def _compiled() -> CompiledFuzzer:
    """Compile or load; once in a process."""
    physics.batch.compiled()
    import numba  # noqa: PLC0415  # an extra
    from numba.extending import register_jitable  # noqa: PLC0415

    start = time.perf_counter()
    for module in (checks, play):
        for function in list(vars(module).values()):
            if isfunction(function) and function.__module__ == module.__name__:
                register_jitable(function)
    register_jitable(oracle.distance_to_sector)
    key = "".join([sources_hash(one) for one in (physics, fuzz, package)])
    to_play, to_fault, to_gap, to_overlap = play.play_checked, checks.tick_fault, checks.gap_beside, checks.overlap_time

    @numba.njit(cache=True, nogil=True)  # type: ignore[untyped-decorator, unused-ignore]
    def played(games, before, full, work, counter, hits, tally, ticks, dt, speed, edge):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_play(games, before, full, work, counter, hits, tally, ticks, dt, speed, edge)

    @numba.njit(cache=True)  # type: ignore[untyped-decorator, unused-ignore]
    def fault(before, games, g, hits, count, dt, speed, freed, dropped, work):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_fault(before, games, g, hits, count, dt, speed, freed, dropped, work)

    @numba.njit(cache=True)  # type: ignore[untyped-decorator, unused-ignore]
    def gap(p, r, ring, time, alive, only):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_gap(p, r, ring, time, alive, only)

    @numba.njit(cache=True)  # type: ignore[untyped-decorator, unused-ignore]
    def overlap(p, v, r, ring, start, stop, alive):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_overlap(p, v, r, ring, start, stop, alive)

    integer, real = numba.int64, numba.float64
    layers = numba.int32[:, ::1]
    rows, games = numba.typeof(np.empty(0, HIT)), numba.typeof(no_games())
    before = numba.typeof(room_for(no_games()))
    counter = numba.uint64[::1]
    played.compile((games, before, layers, layers, counter, rows, integer[::1], integer, real, real, real))
    return CompiledFuzzer(played, fault, gap, overlap, time.perf_counter() - start, sum(played.stats.cache_hits.values()) > 0)


def room_for(games: Games) -> Before:
    """Arrays for the start of a tick."""
    balls, rings = games.positions.shape[1], games.phases.shape[1]
    plane, row = np.zeros(balls, np.complex128), np.zeros(rings)
    return Before(plane, plane.copy(), row, row.copy(), np.zeros(games.layers.shape[1:], np.int32))


def play_compiled(seed: int, index: int) -> Tally:
    """One case, up to its first fault: the arena of its number, in GAMES games of TICKS ticks."""
    check_subnormals()
    arena, speed, _ = random_case(seed, index)
    edge = max([ring.radius + ring.half_width for ring in arena.rings])
    games = arrays_of([arena] * GAMES)
    before, full = room_for(games), games.layers[0].copy()
    counter = np.array([(seed * 1_000_003 + index) % 2**64], np.uint64)
    hits, tally = np.empty(2 * MAX_IMPACTS * len(arena.balls), HIT), np.zeros(4, np.int64)
    game, tick, fault = compiled_fuzzer().play(
        games, before, full, np.zeros_like(full), counter, hits, tally, TICKS, TICK, speed, edge
    )
    steps, touched, dropped, freed = (int(number) for number in tally)
    done = Tally(1, steps, touched, dropped, freed)
    if fault == Fault.NONE:
        return done
    start = _start(games, before, arena, game)
    what, _ = checked_tick(start, speed)
    named = what or f"the compiled checks find {Fault(fault).name}, the plain ones nothing"
    return done._replace(failures=(Failure(seed, index, game * TICKS + tick, named, start, speed),))


def _start(games: Games, before: Before, arena: Arena, game: int) -> Arena:
    """The arena at the start of the tick that failed."""
    now = arena_of(games, arena.rings, game)
    balls = [
        Ball(complex(p), complex(v), ball.radius)
        for p, v, ball in zip(before.positions, before.velocities, now.balls, strict=True)
    ]
    rings = [
        ring._replace(phase=float(phase), spin=float(spin))
        for ring, phase, spin in zip(now.rings, before.phases, before.spins, strict=True)
    ]
    layers = [tuple(row[: ring.count].tolist()) for ring, row in zip(now.rings, before.layers, strict=True)]
    return Arena(tuple(balls), tuple(rings), tuple(layers))
