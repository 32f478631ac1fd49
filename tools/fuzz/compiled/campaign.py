"""Cases of the compiled fuzzer: the arenas of `tools.fuzz.arenas`, each in many games at once."""

import functools
import time
from collections.abc import Callable, Sequence
from inspect import isfunction
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

import physics
import physics.batch
from physics import Arena, Ball
from physics.batch.arrays import Floats, Games, Integers, arena_of, arrays_of
from physics.batch.compilation import check_subnormals, sources_hash, with_progress
from physics.batch.hits import Rows, new_rows
from physics.tolerances import MAX_IMPACTS
from tools import fuzz
from tools.fuzz import oracle
from tools.fuzz.arenas import TICK, random_case
from tools.fuzz.campaign import CampaignTally, Failure, checked_tick
from tools.fuzz.compiled import checks, play
from tools.fuzz.compiled.checks import Before, Fault, Slots

GAMES, TICKS = 64, 200
"""Of a case."""


class CompiledFuzzer(NamedTuple):
    """The compiled loop.

    Attributes:
        play: `play.play_checked`.
        seconds: that compiling took, or loading.
        cached: whether it was loaded from disk.
    """

    play: Callable[..., tuple[int, int, int]]
    seconds: float
    cached: bool


class _Room(NamedTuple):
    """The arrays of a case, the arguments of `play.play_checked` up to the tally."""

    games: Games
    before: Before
    full: Slots
    work: Slots
    spins: Floats
    counters: npt.NDArray[np.uint64]
    rows: Rows
    tally: Integers


def compiled_fuzzer(progress: Callable[[float], None] | None = None) -> CompiledFuzzer:
    """The loop, compiled now unless it was before, or lies on disk. ImportError, naming the extra, without numba."""
    return with_progress(_compiled, progress)


@functools.cache
def _compiled() -> CompiledFuzzer:
    """Compile or load; once in a process."""
    start = time.perf_counter()
    physics.batch.compiled()
    import numba  # noqa: PLC0415  # an extra
    from numba.extending import register_jitable  # noqa: PLC0415

    for module in (checks, play):
        for function in list(vars(module).values()):
            if isfunction(function) and function.__module__ == module.__name__:
                register_jitable(function)
    register_jitable(oracle.distance_to_sector)
    key = sources_hash(physics) + sources_hash(fuzz)
    to_play = play.play_checked

    @numba.njit(cache=True, nogil=True)  # type: ignore[untyped-decorator, unused-ignore]
    def played(games, before, full, work, spins, counters, rows, tally, first, last, ticks, dt, speed, edge):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_play(games, before, full, work, spins, counters, rows, tally, first, last, ticks, dt, speed, edge)

    integer, real = numba.int64, numba.float64
    room = [numba.typeof(part) for part in room_for([Arena((), (), ())], np.empty(1, np.uint64))]
    played.compile((*room, integer, integer, integer, real, real, real))
    return CompiledFuzzer(played, time.perf_counter() - start, sum(played.stats.cache_hits.values()) > 0)


def room_for(arenas: Sequence[Arena], counters: npt.NDArray[np.uint64]) -> _Room:
    """The arrays to play these arenas, which have one shape. counters: the seed of each."""
    games = arrays_of(arenas)
    full = games.layers[0].copy()
    start = games.positions[0], games.velocities[0], games.phases[0], games.spins[0], full
    before = Before(*[array.copy() for array in start])
    rows = new_rows(2 * MAX_IMPACTS * len(arenas[0].balls))
    return _Room(games, before, full, full.copy(), games.spins.copy(), counters, rows, np.zeros(4, np.int64))


def play_compiled(seed: int, index: int) -> CampaignTally:
    """One case, up to its first fault: the arena of its number, in GAMES games of TICKS ticks."""
    check_subnormals()
    room, speed, edge = _case(seed, index)
    game, tick, fault = compiled_fuzzer().play(*room, 0, GAMES, TICKS, TICK, speed, edge)
    steps, hits, dropped, freed = room.tally.tolist()
    done = CampaignTally(1, steps, hits, dropped, freed)
    if fault == Fault.NONE:
        return done
    again = plain_fault(seed, index, game)
    also = "plain Python finds the same" if again == (tick, fault) else f"plain Python, which finds {_told(again)}, differs"
    start = _start(room, random_case(seed, index).arena, game)
    what, _ = checked_tick(start, speed)
    named = f"game {game}: {_told((tick, Fault(fault)))}; {also}" + (f": {what}" if what else "")
    return done._replace(failures=(Failure(seed, index, tick, named, start, speed),))


def plain_fault(seed: int, index: int, game: int) -> tuple[int, Fault]:
    """Tick and fault of one game of a case, played without the compiler by the same functions; tick -1 for no fault."""
    room, speed, edge = _case(seed, index)
    with np.errstate(over="ignore"):
        _, tick, fault = play.play_checked(*room, game, game + 1, TICKS, TICK, speed, edge)
    return tick, Fault(fault)


def _told(found: tuple[int, Fault]) -> str:
    """A tick and its fault in words."""
    tick, fault = found
    return "nothing" if fault is Fault.NONE else f"{fault.name} at tick {tick}"


def _case(seed: int, index: int) -> tuple[_Room, float, float]:
    """The arrays of a case, the balls' speed, and how far from the centre a ball is lost."""
    arena, speed, _ = random_case(seed, index)
    counters = np.random.SeedSequence([seed, index]).generate_state(GAMES, np.uint64).astype(np.uint64)
    room = room_for([arena] * GAMES, counters)
    room.games.steered[:] = index % 2
    return room, speed, max([ring.radius + ring.half_width for ring in arena.rings])


def _start(room: _Room, arena: Arena, game: int) -> Arena:
    """The arena at the start of the tick that failed."""
    now, before = arena_of(room.games, arena.rings, game), room.before
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
