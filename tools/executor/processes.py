"""Work shared by processes on this machine.

Each process has a pipe of its own and nothing else in common with the others: one that is killed holds no lock, and all of them
end when this process is gone, however that came about.
"""

import multiprocessing
import signal
import time
from collections import deque
from collections.abc import Callable, Generator, Iterator
from contextlib import suppress
from itertools import islice
from multiprocessing.connection import Connection, wait
from typing import Any, NamedTuple, TypeVar

from game.system.ending import deferred, interrupts_blocked
from game.system.files import check_working_directory
from tools.executor.lost import Lost, raised

Job = TypeVar("Job")
Result = TypeVar("Result")

_WINDOW = 64
"""Jobs for each process that may be done before the oldest one is."""
_ATTEMPTS = 2
"""Processes that may die of a job before it is lost."""
_LOOK = 0.5
"""Seconds from one look at the clock to the next."""


class _Given(NamedTuple):
    """A job with its number, and how many processes have died of it."""

    number: int
    job: Any
    deaths: int = 0


class _Helper:
    """One process, the job it has, and since when.

    It has one job at a time: a second one would wait behind a long first one while another process had nothing to do.
    """

    def __init__(self, function: Callable[[Any], object]) -> None:
        """Start it."""
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(theirs, function), daemon=True)
        with interrupts_blocked():
            self.process.start()
        theirs.close()
        self.job: _Given | None = None
        self.since = 0.0

    def give(self, given: _Given, now: float) -> None:
        """Hand over a job; that the process is dead is noticed when its answer is wanted."""
        self.job, self.since = given, now
        with suppress(OSError):
            self.pipe.send(given.job)

    def end(self) -> None:
        """End it, whatever it does."""
        self.pipe.close()
        self.process.terminate()
        self.process.join()


class _Crew:
    """The processes, the jobs that wait, and the results whose turn has not come."""

    def __init__(self, function: Callable[[Any], object], jobs: Iterator[Any], workers: int, limit: float | None) -> None:
        self._function, self._workers, self._limit = function, workers, limit
        self._jobs = enumerate(jobs)
        self._again: deque[_Given] = deque()
        self._helpers: list[_Helper] = []
        self._done: dict[int, Any] = {}
        self._begun = 0
        self.clock = time.monotonic

    def result(self, number: int) -> tuple[Any] | None:
        """The result of a job, in a tuple of one, once it is there; None when there are no more jobs."""
        while number not in self._done:
            self._hand_out(number)
            if all([helper.job is None for helper in self._helpers]):
                return None
            wait([helper.pipe for helper in self._helpers], timeout=_LOOK)
            for helper in list(self._helpers):
                self._look_at(helper)
        return (self._done.pop(number),)

    def end(self) -> None:
        """End all processes."""
        for helper in self._helpers:
            helper.process.terminate()
        for helper in self._helpers:
            helper.end()
        self._helpers.clear()

    def _hand_out(self, wanted: int) -> None:
        """Give every process a job, the oldest first. wanted: the number of the next result."""
        for place in range(self._workers):
            if place < len(self._helpers) and self._helpers[place].job is not None:
                continue
            given = self._next(wanted)
            if given is None:
                return
            if place >= len(self._helpers):
                with deferred():  # a signal in between would leave a started process unknown
                    self._helpers.append(_Helper(self._function))
            self._helpers[min(place, len(self._helpers) - 1)].give(given, self.clock())

    def _next(self, wanted: int) -> _Given | None:
        """The next job to be given to a process; None where there is none, or too many are done before their turn."""
        if self._again:
            return self._again.popleft()
        if self._begun >= wanted + _WINDOW * self._workers:
            return None
        for number, job in islice(self._jobs, 1):
            self._begun = number + 1
            return _Given(number, job)
        return None

    def _look_at(self, helper: _Helper) -> None:
        """Take a process's answer. If it is dead or too slow, end it; its job is done again, or counted as lost."""
        given = helper.job
        if given is None:
            if not helper.process.is_alive():
                self._end_helper(helper)
        elif helper.pipe.poll():
            try:
                self._done[given.number] = helper.pipe.recv()
                helper.job = None
            except (EOFError, OSError):
                helper.process.join()
                if given.deaths + 1 >= _ATTEMPTS:
                    self._done[given.number] = Lost(_death(helper.process.exitcode))
                else:
                    self._again.append(given._replace(deaths=given.deaths + 1))
                self._end_helper(helper)
        elif self._limit is not None and self.clock() - helper.since > self._limit:
            self._done[given.number] = Lost(f"no answer within {self._limit:g} s")
            self._end_helper(helper)

    def _end_helper(self, helper: _Helper) -> None:
        """End a process, and forget it."""
        self._helpers.remove(helper)
        helper.end()


def process_results(
    function: Callable[[Job], Result],
    jobs: Iterator[Job],
    workers: int,
    time_limit: float | None = None,
    clock: Callable[[], float] = time.monotonic,
) -> Generator[Result | Lost, None, None]:
    """`tools.executor.results` by processes on this machine."""
    check_working_directory()
    crew = _Crew(function, jobs, workers, time_limit)
    crew.clock = clock
    number = 0
    try:
        while (answer := crew.result(number)) is not None:
            number += 1
            yield answer[0]
    finally:
        with deferred():
            crew.end()


def _death(exit_code: int | None) -> str:
    """How a process ended, in words."""
    if exit_code is not None and exit_code < 0:
        return f"its process was killed by {signal.Signals(-exit_code).name}"
    return f"its process ended with exit code {exit_code}"


def _serve(pipe: Connection, function: Callable[[Any], object]) -> None:
    """The life of a process: a job in, a result out, until the pipe is closed. Ctrl-C is the parent's business."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    with suppress(EOFError, OSError):
        while True:
            job = pipe.recv()
            try:
                pipe.send(function(job))
            except OSError:
                raise
            except Exception as error:  # noqa: BLE001  # the job is lost, the others go on
                _tell(pipe, error)


def _tell(pipe: Connection, error: Exception) -> None:
    """Say that a job raised an exception, or gave a result, that may be none to send."""
    lost = raised(error)
    try:
        pipe.send(lost)
    except OSError:
        raise
    except Exception:  # noqa: BLE001  # whatever it was that cannot be pickled
        pipe.send(lost._replace(error=None))
