"""The autopilot compiled by numba: `game.autopilot`'s own functions, on the arrays of the batch."""

import functools
import inspect
import time
from collections.abc import Callable
from types import FunctionType, ModuleType
from typing import Any, NamedTuple

import numpy as np

import game.autopilot
import game.rules
import physics.batch
from game.autopilot import prediction, source_plan
from game.rules.steering import keyed_spin, spin_to_pointer
from physics.batch.arrays import no_games
from physics.batch.compilation import compile_cached, sources_hash, with_progress
from physics.batch.hits import new_rows
from physics.shapes import Ball
from tools import autopilot
from tools.autopilot import plans, steering
from tools.autopilot.plans import PLAN
from tools.autopilot.steering import Pilots

_ON_ARRAYS = ("with_ball", "ball_of", "flown", "free_seconds", "flown_freely")
"""Functions of `game.autopilot.prediction` in whose place those of `plans` are compiled."""


_INLINED = ("_copy_bricks", "is_outdated", "planned_pointer", *_ON_ARRAYS)
"""Functions of `plans` that are compiled into their callers: numba counts arrays in and out of every other call."""


class CompiledAutopilot(NamedTuple):
    """The compiled loop.

    Attributes:
        step: `tools.autopilot.steering.step`.
        seconds: that compiling or loading took.
        cached: whether it was loaded from disk.
    """

    step: Callable[..., int]
    seconds: float
    cached: bool


def compiled_autopilot(progress: Callable[[float], None] | None = None) -> CompiledAutopilot:
    """The loop, compiled now unless it was before in this process, or lies on disk; the physics with it.

    progress: called about once a second while it is compiled, with the seconds since the start.
    Raises ImportError, naming the extra, where numba cannot be imported.
    """
    return with_progress(_compiled, progress)


@functools.cache
def _compiled() -> CompiledAutopilot:
    """Compile or load; once in a process."""
    start = time.perf_counter()
    replan_cached = register_autopilot()
    import numba  # noqa: PLC0415  # an extra

    key = autopilot_key()
    to_step = steering.step

    @numba.njit(cache=True, nogil=True, error_model="numpy")  # type: ignore[untyped-decorator, unused-ignore]
    def step(pilots, top, change, games, first, last, begun, ticks, speed, ground_radius, rows, lost):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_step(pilots, top, change, games, first, last, begun, ticks, speed, ground_radius, rows, lost)

    integers = np.empty(0, np.int64)
    pilots = numba.typeof(Pilots(np.empty(0, PLAN), integers, integers, integers))
    games, rows = numba.typeof(no_games()), numba.typeof(new_rows(0))
    whole, real = numba.int64, numba.float64
    compile_cached(step, (pilots, real, real, games, whole, whole, whole, whole, real, real, rows, numba.boolean[:, ::1]))
    cached = replan_cached and sum(step.stats.cache_hits.values()) > 0
    return CompiledAutopilot(step, time.perf_counter() - start, cached)


def autopilot_key() -> str:
    """What compiled code with the autopilot in it depends on."""
    return "".join([sources_hash(package) for package in (physics, game.rules, game.autopilot, autopilot)])


@functools.cache
def register_autopilot() -> bool:
    """Tell numba of the autopilot's functions, and of the physics; once in a process. Whether `replan` was loaded from disk."""
    physics.batch.compiled()
    from numba.extending import overload, register_jitable  # noqa: PLC0415  # an extra

    for function in (keyed_spin, spin_to_pointer):
        register_jitable(function)
    replaced = [plans.replan]
    for name in _ON_ARRAYS:
        function = getattr(prediction, name)
        overload(function, jit_options={"forceinline": True})(_instead(getattr(plans, name)))
        replaced.append(function)
    for module in (prediction, source_plan, plans, steering):
        for function in own_functions(module):
            if function not in replaced:
                register_jitable(forceinline=module is steering or function.__name__ in _INLINED)(function)
    return _register_replan()


def own_functions(module: ModuleType) -> list[FunctionType]:
    """The functions that a module defines, without those that it imports."""
    return [one for one in vars(module).values() if inspect.isfunction(one) and one.__module__ == module.__name__]


def _register_replan() -> bool:
    """Compile `replan`, and have loops call what is compiled, instead of compiling it once more into each of them."""
    import numba  # noqa: PLC0415  # an extra
    from numba.extending import overload  # noqa: PLC0415

    key, to_write = autopilot_key(), plans.write_plan

    @numba.njit(cache=True, nogil=True, error_model="numpy", no_cpython_wrapper=True)  # type: ignore[untyped-decorator, unused-ignore]
    def replan(plan, games, g, ball, tick, speed, top):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        to_write(plan, games, g, ball, tick, speed, top)

    whole, real = numba.int64, numba.float64
    ball = numba.typeof(Ball(0j, 0j, 1.0))
    compile_cached(replan, (numba.from_dtype(PLAN), numba.typeof(no_games()), whole, ball, whole, real, real))

    @overload(plans.replan)
    def _replan(plan, games, g, ball, tick, speed, top):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202, ARG001
        def planned_anew(plan, games, g, ball, tick, speed, top):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
            replan(plan, games, g, ball, tick, speed, top)

        return planned_anew

    return bool(sum(replan.stats.cache_hits.values()))


def _instead(function: Any) -> Any:
    """What numba asks for the function to compile where one of the same parameters is called."""

    def chosen(*_types: Any) -> Any:
        return function

    chosen.__signature__ = inspect.signature(function)  # type: ignore[attr-defined]
    return chosen
