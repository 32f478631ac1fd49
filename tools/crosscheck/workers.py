"""Work in other processes, so that what kills one of them costs one job and not the run."""

import contextlib
import multiprocessing
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection, wait
from typing import NamedTuple, TypeVar

from game.system.ending import interrupts_blocked

Job = TypeVar("Job")
Result = TypeVar("Result")

TIME_LIMIT = 1800.0
"""Seconds for one job: an hour's game takes a quarter of it. pymunk can also hang, not only die."""


class Lost(NamedTuple):
    """A job whose process died, or gave up, or took too long."""

    why: str


class _Worker:
    """One process and the job it has."""

    def __init__(self, function: Callable[[Job], Result]) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(theirs, function), daemon=True)
        with interrupts_blocked():
            self.process.start()
        theirs.close()
        self.job: int | None = None
        self.since = 0.0

    def give(self, number: int, job: object) -> None:
        """Hand over a job."""
        self.job, self.since = number, time.monotonic()
        with contextlib.suppress(OSError):  # a process that died idle is noticed by its closed pipe
            self.pipe.send(job)

    def stop(self) -> None:
        """End the process, whatever it does."""
        self.pipe.close()
        self.process.terminate()
        self.process.join()


def results_of(
    function: Callable[[Job], Result], jobs: Sequence[Job], workers: int, time_limit: float = TIME_LIMIT
) -> Iterator[tuple[int, Result | Lost]]:
    """(number of the job, its result) as they come; `Lost` for those whose process did not live to answer.

    function: importable by its name; what it raises is its job's loss. A new process takes a dead one's place.
    """
    waiting = list(range(len(jobs)))[::-1]
    crew: list[_Worker] = []
    try:
        while waiting or crew:
            while waiting and len(crew) < workers:
                crew.append(_Worker(function))
                crew[-1].give(waiting[-1], jobs[waiting.pop()])
            wait([worker.pipe for worker in crew], timeout=0.5)
            for worker in list(crew):
                answer = _answer(worker, time_limit)
                if answer is None:
                    continue
                number = worker.job
                assert number is not None
                if waiting and not isinstance(answer[0], Lost):
                    worker.give(waiting[-1], jobs[waiting.pop()])
                else:
                    crew.remove(worker)
                    worker.stop()
                yield number, answer[0]
    finally:
        for worker in crew:
            worker.stop()


def _answer(worker: _Worker, time_limit: float) -> tuple[Result | Lost] | None:
    """What a worker has to say, in a tuple of one; None while it works."""
    if worker.pipe.poll():
        try:
            return (worker.pipe.recv(),)
        except (EOFError, OSError):
            worker.process.join()
            return (Lost(_death(worker.process.exitcode)),)
    if time.monotonic() - worker.since > time_limit:
        return (Lost(f"no answer within {time_limit:g} s"),)
    return None


def _death(exit_code: int | None) -> str:
    """How a process ended, in words."""
    if exit_code is not None and exit_code < 0:
        return f"its process was killed by {signal.Signals(-exit_code).name}"
    return f"its process ended with exit code {exit_code}"


def _serve(pipe: Connection, function: Callable[[Job], Result]) -> None:
    """The life of a worker: a job in, a result out. Ctrl-C is the parent's business."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    while True:
        try:
            job = pipe.recv()
        except EOFError:
            return
        try:
            pipe.send(function(job))
        except Exception as error:  # noqa: BLE001  # the job is lost, the run goes on
            pipe.send(Lost(f"{type(error).__name__}: {error}"))
