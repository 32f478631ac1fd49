"""The environments' loops compiled by numba, with the physics of the batch and the rules' own functions."""

import functools
import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

import physics.batch
from game.rules.nudging import nudged_ball
from game.rules.scoring import layer_points
from game.rules.serving import served_ball, swung_aim
from physics.batch.arrays import no_games
from physics.batch.compilation import compile_cached, sources_hash, with_progress
from physics.batch.hits import new_rows
from tools import environments
from tools.autopilot.compilation import autopilot_key, own_functions, register_autopilot
from tools.autopilot.plans import PLAN
from tools.environments import observation, ticks
from tools.environments.numbers import EPISODE, LevelConstants, new_results


class CompiledLoops(NamedTuple):
    """The loops of `ticks` and `observation`, compiled.

    Attributes:
        step: `ticks.step`.
        begin: `ticks.begin` for every environment of a mask, and `observation.write_states`.
        write_states: `observation.write_states`.
        paint: `observation.paint`.
        seconds: that compiling or loading took.
        cached: whether they were loaded from disk.
    """

    step: Callable[..., int]
    begin: Callable[..., None]
    write_states: Callable[..., None]
    paint: Callable[..., None]
    seconds: float
    cached: bool


def compiled_loops(progress: Callable[[float], None] | None = None) -> CompiledLoops:
    """The loops, compiled now unless they were before in this process, or lie on disk; the physics with them.

    progress: called about once a second while they are compiled, with the seconds since the start.
    Raises ImportError, naming the extra, where numba cannot be imported.
    """
    return with_progress(_compiled_loops, progress)


@functools.cache
def _compiled_loops() -> CompiledLoops:
    """Compile or load; once in a process."""
    physics.batch.compiled()
    import numba  # noqa: PLC0415  # an extra

    start = time.perf_counter()
    _register()
    key = autopilot_key() + sources_hash(environments)
    to_step, to_begin, to_write, to_paint = ticks.step, ticks.begin, observation.write_states, observation.paint

    @numba.njit(cache=True, nogil=True, error_model="numpy")  # type: ignore[untyped-decorator, unused-ignore]
    def step(numbers, games, episodes, plans, actions, pointers, results, states, rows, busy, begun):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_step(numbers, games, episodes, plans, actions, pointers, results, states, rows, busy, begun)

    @numba.njit(cache=True, nogil=True)  # type: ignore[untyped-decorator, unused-ignore]
    def begin(numbers, games, episodes, states, mask):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        for g in range(len(episodes)):
            if mask[g]:
                to_begin(numbers, games, episodes, g)
        to_write(numbers, games, episodes, states)

    @numba.njit(cache=True, nogil=True)  # type: ignore[untyped-decorator, unused-ignore]
    def write_states(numbers, games, episodes, states):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        to_write(numbers, games, episodes, states)

    @numba.njit(cache=True, nogil=True)  # type: ignore[untyped-decorator, unused-ignore]
    def paint(games, cells, only, pictures):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        to_paint(games, cells, only, pictures)

    examples = (
        LevelConstants(0.0, 0.0, 0.0, 0.0, 0.0, 0, 0, 0, 0.0, 0, 0, 0.0, 0.0, 0.0),
        no_games(),
        np.empty(0, EPISODE),
        np.empty(0, PLAN),
        new_rows(0),
        new_results(0),
    )
    numbers, games, episodes, plans, rows, results = (numba.typeof(example) for example in examples)
    integers, small, states = numba.int64[::1], numba.uint8, numba.float32[:, ::1]
    compile_cached(step, (numbers, games, episodes, plans, integers, integers, results, states, rows, integers, numba.int64))
    compile_cached(begin, (numbers, games, episodes, states, numba.boolean[::1]))
    compile_cached(write_states, (numbers, games, episodes, states))
    cells = observation.Cells(np.empty(0, np.complex128), np.empty(0), np.empty(0, np.int64), np.empty(0))
    compile_cached(paint, (games, numba.typeof(cells), integers, small[:, ::1]))
    loops = (step, begin, write_states, paint)
    cached = all([sum(loop.stats.cache_hits.values()) > 0 for loop in loops])
    # These are the compiled functions themselves, which check their arguments' types. numba's dispatcher would look up the only
    # version that there is: a call through it takes 6 µs, without it 2 µs.
    to_step, to_begin, to_write, to_paint = [loop.overloads[loop.signatures[0]].entry_point for loop in loops]
    return CompiledLoops(to_step, to_begin, to_write, to_paint, time.perf_counter() - start, cached)


def _register() -> None:
    """Tell numba of every function that is compiled here."""
    from numba.extending import register_jitable  # noqa: PLC0415  # an extra

    register_autopilot()
    for function in (served_ball, swung_aim, nudged_ball, layer_points):
        register_jitable(function)
    for module in (ticks, observation):
        for function in own_functions(module):
            register_jitable(forceinline=True)(function)
