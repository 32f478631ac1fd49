"""The physics compiled by numba: the same functions, no copy of them.

`register_jitable` tells numba that a function called from compiled code may be compiled as it stands. The methods and
properties of `Ball` and `Ring` are handed over one by one, since numba takes a NamedTuple for a bare tuple.

numba keeps compiled code on disk, but sees a change only in the file of the function that is called first. That function is
therefore a closure over the hash of all sources of the physics, which numba makes part of the key.
"""

import functools
import hashlib
import sys
import threading
import time
from collections.abc import Callable
from importlib import resources
from inspect import isfunction
from types import ModuleType
from typing import Any, NamedTuple, TypeVar

import physics
from physics.batch import games as loop
from physics.batch.arrays import no_games
from physics.batch.games import Workspace
from physics.batch.hits import new_rows, write_hit
from physics.shapes import Ball, Ring, unchecked
from physics.step import AT_START, add_hit, set_layers


class Compiled(NamedTuple):
    """The compiled loop.

    Attributes:
        steer: `physics.batch.games.steer`.
        step: `physics.batch.games.step`.
        seconds: that compiling took, or loading.
        cached: whether it was loaded from disk.
    """

    steer: Callable[..., None]
    step: Callable[..., int]
    seconds: float
    cached: bool


def check_numba() -> None:
    """Raise ImportError, with what to do, where numba cannot be imported."""
    try:
        import numba  # noqa: F401, PLC0415  # only whether it can be
    except (ImportError, OSError) as error:
        wanted = "install the extra [batch]: python -m pip install 'polar-breakout[batch]'"
        raise ImportError(f"physics.batch needs numba, which cannot be imported ({error}); {wanted}") from None


def check_subnormals() -> None:
    """Raise RuntimeError where this thread's processor takes subnormal floats for 0: every bit might differ.

    A shared library built with fast-math switches that on for the whole process as it is loaded.
    """
    smallest = sys.float_info.min
    if not (smallest * 0.5 > 0.0 and 2.0 * (smallest * 0.5) == smallest):
        raise RuntimeError("flush-to-zero is switched on in this process, probably by a library built with fast-math")


Result = TypeVar("Result")

_LOCK = threading.Lock()
_REPLACED = {"set_layers", "add_hit", "play_one_tick", "joined", "uncounted"}
"""Functions in whose place others are compiled."""
_INLINED = {"answer_impacts", "clear_time", "first_impact", "gap_end", "touched_now"} | {
    *("_answer", "_clear_of_ring", "_clear_of_sectors", "_earliest", "_first_touch", "_next_impact", "_time_to_touch")
}
"""Functions compiled into their callers, as are those of the loop: they are given lists and arrays, which numba counts in and
out of every call, atomically. To do so with all of the physics would take four times as long to compile."""
_NOT_COMPILED = {f"physics.batch{name}" for name in ("", ".arrays", ".batch", ".compilation", ".threads")}


def compiled(progress: Callable[[float], None] | None = None) -> Compiled:
    """The loop, compiled now unless it was before in this process, or lies on disk.

    progress: called about once a second while it is compiled, with the seconds since the start.
    Raises ImportError, naming the extra, where numba cannot be imported.
    """
    check_numba()
    with _LOCK:
        return with_progress(_compiled, progress)


def with_progress(work: Callable[[], Result], progress: Callable[[float], None] | None) -> Result:
    """What some work gives; about once a second while it lasts, `progress` is called with the seconds since its start."""
    if progress is None:
        return work()
    done, start = threading.Event(), time.perf_counter()

    def report() -> None:
        while not done.wait(1.0):
            progress(time.perf_counter() - start)

    reporter = threading.Thread(target=report, daemon=True)
    reporter.start()
    try:
        return work()
    finally:
        done.set()
        reporter.join()


def sources_hash(package: ModuleType = physics) -> str:
    """SHA-256 of all sources of a package."""
    digest = hashlib.sha256()
    folders = [resources.files(package)]
    while folders:
        for item in sorted(folders.pop().iterdir(), key=lambda item: item.name):
            if item.is_dir():
                folders.append(item)
            elif item.name.endswith(".py"):
                digest.update(item.name.encode() + b"\0" + item.read_bytes() + b"\0")
    return digest.hexdigest()


def compile_cached(function: Any, signature: tuple[Any, ...]) -> None:
    """Compile numba's function for a signature, or load what is on disk."""
    try:
        function.compile(signature)
    except (AttributeError, ImportError):  # the index on disk names a class that another version of the project had
        function._cache.flush()  # noqa: SLF001  # numba reads the index before it compares the sources' times
        function.compile(signature)


@functools.cache
def _compiled() -> Compiled:
    """Compile or load; once in a process."""
    import numba  # noqa: PLC0415  # an extra

    start = time.perf_counter()
    _register()
    key = sources_hash()
    to_steer, to_step, to_play = loop.steer, loop.step, loop.play

    @numba.njit(cache=True, nogil=True)  # type: ignore[untyped-decorator, unused-ignore]
    def steer(games, spins, first, last):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        to_steer(games, spins, first, last)

    @numba.njit(cache=True, nogil=True, error_model="numpy")  # type: ignore[untyped-decorator, unused-ignore]
    def step(games, first, last, begun, ticks, dt, speed, ground_radius, rows, lost):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        return to_step(games, first, last, begun, ticks, dt, speed, ground_radius, rows, lost)

    @numba.njit(cache=True, nogil=True, error_model="numpy", no_cpython_wrapper=True)  # type: ignore[untyped-decorator, unused-ignore]
    def play_one_tick(games, g, dt, speed, rows, room):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        _ = key
        rows.now[0], games.played[g] = 0, 0
        to_play(games, g, g + 1, 1, dt, speed, rows, room)

    games = numba.typeof(no_games())
    integer, real, rows = numba.int64, numba.float64, numba.typeof(new_rows(0))
    compile_cached(steer, (games, real[:, ::1], integer, integer))
    compile_cached(step, (games, integer, integer, integer, integer, real, real, real, rows, numba.boolean[:, ::1]))
    compile_cached(play_one_tick, (games, integer, real, real, rows, _workspace_type()))
    _register_tick(play_one_tick)
    cached = all([sum(function.stats.cache_hits.values()) > 0 for function in (steer, step, play_one_tick)])
    return Compiled(steer, step, time.perf_counter() - start, cached)


def _register() -> None:
    """Tell numba of every function of the physics, and of the methods and properties of Ball and Ring."""
    from numba.extending import overload, register_jitable  # noqa: PLC0415  # an extra

    for name in sorted(sys.modules):
        if name.startswith("physics.") and name not in _NOT_COMPILED:
            for function in list(vars(sys.modules[name]).values()):
                if isfunction(function) and function.__module__ == name and function.__name__ not in _REPLACED:
                    register_jitable(forceinline=name == loop.__name__ or function.__name__ in _INLINED)(function)
    _register_members()
    _register_uncounted()

    @overload(unchecked)
    def _unchecked(cls, fields):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202, ARG001
        whole = cls.instance_class
        return lambda cls, fields: whole(*fields)  # noqa: ARG005

    @overload(set_layers)
    def _set_layers(layers, ring, slot, left):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202, ARG001
        def write(layers, ring, slot, left):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
            layers[ring, slot] = left

        return write

    @overload(add_hit)
    def _add_hit(hits, hit):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202, ARG001
        return lambda hits, hit: write_hit(hits, hit)  # noqa: PLW0108  # the names and annotations must be the function's


def _register_uncounted() -> None:
    """An array without an owner: numba finds nothing whose references it could count."""
    from numba.core import cgutils  # noqa: PLC0415  # an extra
    from numba.extending import intrinsic, overload  # noqa: PLC0415

    @intrinsic  # type: ignore[untyped-decorator, unused-ignore]
    def without_owner(typing, array):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202, ARG001
        def generate(context, builder, signature, arguments):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
            view = context.make_array(signature.return_type)(context, builder, arguments[0])
            view.meminfo, view.parent = (cgutils.get_null_value(owner.type) for owner in (view.meminfo, view.parent))
            return view._getvalue()  # noqa: SLF001  # numba's own way to read the struct

        return array(array), generate

    @overload(loop.uncounted)
    def _uncounted(array):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202, ARG001
        return lambda array: without_owner(array)  # noqa: PLW0108


def _register_tick(compiled_tick: Any) -> None:
    """Have `play_one_tick` call what is compiled already, instead of compiling it once more into every loop that uses it."""
    from numba.extending import overload  # noqa: PLC0415  # an extra

    @overload(loop.play_one_tick)
    def _play_one_tick(games, g, dt, speed, rows, room):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202, ARG001
        def tick(games, g, dt, speed, rows, room):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
            compiled_tick(games, g, dt, speed, rows, room)

        return tick


def _workspace_type() -> Any:
    """numba's type of `Workspace`: its lists cannot be made outside of compiled code."""
    from numba import typeof  # noqa: PLC0415
    from numba.core import types  # noqa: PLC0415  # an extra

    examples = Ball(0j, 0j, 1.0), Ring(1.0, 0.5, 0.1, 1), AT_START, 0, 0
    return types.NamedTuple([types.List(typeof(example)) for example in examples], Workspace)


def _register_members() -> None:
    """The methods and properties. numba knows a NamedTuple's class, but nothing that the class has beside its fields."""
    from numba.core.types import BaseNamedTuple  # noqa: PLC0415  # an extra
    from numba.extending import overload_attribute, overload_method  # noqa: PLC0415

    def of(cls: type, value: Any, function: Any) -> Any:
        """The function for values of this class; None, which leaves the name to others, for all others."""
        return function if getattr(value, "instance_class", None) is cls else None

    overload_method(BaseNamedTuple, "theta", strict=False)(lambda self: of(Ball, self, Ball.theta))
    overload_method(BaseNamedTuple, "moved", strict=False)(lambda self, time: of(Ball, self, Ball.moved))  # noqa: ARG005
    overload_method(BaseNamedTuple, "angle", strict=False)(lambda self, slot: of(Ring, self, Ring.angle))  # noqa: ARG005
    overload_method(BaseNamedTuple, "turned", strict=False)(lambda self, time: of(Ring, self, Ring.turned))  # noqa: ARG005
    overload_method(BaseNamedTuple, "surface_velocity", strict=False)(
        lambda self, point: of(Ring, self, Ring.surface_velocity)  # noqa: ARG005
    )
    for name in ("inner_radius", "outer_radius"):
        getter = getattr(Ring, name).fget
        overload_attribute(BaseNamedTuple, name, strict=False)(lambda self, getter=getter: of(Ring, self, getter))
