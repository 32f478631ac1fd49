"""Shares the work of one step among waiting threads. Starting threads for each step would take as long as a short step."""

import os
import threading
from collections import deque
from collections.abc import Callable
from functools import partial
from queue import SimpleQueue
from typing import TypeVar

Result = TypeVar("Result")
Call = Callable[[], None]

_WAITING: list[SimpleQueue[Call]] = []
"""A queue of calls for each thread but the caller's. Threads are started when they are first needed."""
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_WAITING.clear)  # a child has none of its parent's threads


def shared(
    work: Callable[[int], Result], pieces: int, threads: int, interrupted: threading.Event | None = None
) -> list[Result]:
    """The results of `work` for the pieces 0 to below `pieces`, in this order, by this thread and `threads` - 1 others.

    Each thread begins with pieces of its own, the same ones in every call, so that its processor's cache still holds them.
    A thread without pieces takes the last one of the thread with the most. An exception is raised here once all are done.
    When the caller is interrupted (Ctrl-C), no further piece is begun, and the interrupt is raised once the pieces under way
    have ended: they would write into the arrays that the next call uses. interrupted: set before that, so that `work` can
    return early.
    """
    if threads == 1:
        return [work(piece) for piece in range(pieces)]
    left = [deque(range(pieces * k // threads, pieces * (k + 1) // threads)) for k in range(threads)]
    results: dict[int, Result] = {}
    errors: list[BaseException] = []
    done: SimpleQueue[int] = SimpleQueue()
    at_work = [threading.Lock() for _ in range(threads)]

    def take_part(number: int) -> None:
        with at_work[number]:
            while (piece := _taken(left, number)) is not None:
                try:
                    results[piece] = work(piece)
                except BaseException as error:  # noqa: BLE001  # it is raised in the caller's thread
                    errors.append(error)
                done.put(piece)

    try:
        for number in range(1, threads):
            _waiting(number - 1).put(partial(take_part, number))
        take_part(0)
        for _ in range(pieces):
            done.get()
    except BaseException:
        if interrupted is not None:
            interrupted.set()
        _stop(left, at_work)
        raise
    if errors:
        raise errors[0]
    return [results[piece] for piece in range(pieces)]


def _stop(left: list[deque[int]], at_work: list[threading.Lock]) -> None:
    """Let no thread begin another piece; return once none is at one."""
    for pieces in left:
        pieces.clear()
    for lock in at_work:
        with lock:
            pass


def _taken(left: list[deque[int]], number: int) -> int | None:
    """The next piece for a thread, taken from what is left for each; None where there is none."""
    try:
        return left[number].popleft() if left[number] else max(left, key=len).pop()
    except IndexError:  # another thread was faster
        return None


def _waiting(number: int) -> SimpleQueue[Call]:
    """The queue of a thread, which is started if necessary."""
    while len(_WAITING) <= number:
        calls: SimpleQueue[Call] = SimpleQueue()
        threading.Thread(target=_serve, args=(calls,), name=f"physics.batch {len(_WAITING)}", daemon=True).start()
        _WAITING.append(calls)
    return _WAITING[number]


def _serve(calls: SimpleQueue[Call]) -> None:
    """Run calls for ever: the function of each thread."""
    while True:
        calls.get()()
