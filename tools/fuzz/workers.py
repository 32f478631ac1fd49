"""Work shared by other processes, its results in the order of the jobs.

Each process has a pipe of its own and nothing else in common with the others: one that is killed holds no lock, and all of them
end when this process is gone, however that came about.
"""

import multiprocessing
from collections import deque
from collections.abc import Callable, Generator, Iterator
from contextlib import suppress
from itertools import cycle, islice
from multiprocessing.connection import Connection
from typing import Any, TypeVar

from game.system.ending import deferred, interrupts_blocked
from game.system.errors import EnvironmentMissingError
from game.system.files import check_working_directory

Task = TypeVar("Task")
Answer = TypeVar("Answer")

_AHEAD = 2
"""Jobs that a process is given at a time, so that it need not wait for the next."""


class _Helper:
    """One process."""

    def __init__(self, work: Callable[[Any], object]) -> None:
        """Start it."""
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(theirs, work), daemon=True)
        with interrupts_blocked():
            self.process.start()
        theirs.close()

    def give(self, job: object) -> None:
        """Hand over a job; that the process is dead is noticed when its answer is wanted."""
        with suppress(OSError):
            self.pipe.send(job)

    def answer(self) -> object:
        """The result of the oldest job it was given; what the job raised is raised here."""
        try:
            answer = self.pipe.recv()
        except (EOFError, OSError):
            self.process.join()
            raise EnvironmentMissingError(
                f"a process that shared the work died with exit code {self.process.exitcode}"
            ) from None
        if isinstance(answer, Exception):
            raise answer
        return answer

    def end(self) -> None:
        """End it, whatever it does."""
        self.pipe.close()
        self.process.terminate()
        self.process.join()


def shared_out(work: Callable[[Task], Answer], jobs: Iterator[Task], workers: int) -> Generator[Answer, None, None]:
    """The results of jobs in the order of the jobs. work: importable by its name, where other processes share the jobs.

    Raises EnvironmentMissingError when one of them dies.
    """
    if workers == 1:
        yield from map(work, jobs)
        return
    check_working_directory()
    helpers: list[_Helper] = []
    try:
        for _ in range(workers):
            with deferred():  # or one might be started and not be known of
                helpers.append(_Helper(work))
        waiting: deque[_Helper] = deque()
        for helper, job in zip(cycle(helpers), islice(jobs, _AHEAD * workers)):  # the jobs end first
            helper.give(job)
            waiting.append(helper)
        while waiting:
            helper = waiting.popleft()
            answer: Any = helper.answer()
            for job in islice(jobs, 1):
                helper.give(job)
                waiting.append(helper)
            yield answer
    finally:
        with deferred():
            for helper in helpers:
                helper.end()


def _serve(pipe: Connection, work: Callable[[Any], object]) -> None:
    """The life of a process: a job in, a result out, until the pipe is closed."""
    while True:
        try:
            pipe.send(work(pipe.recv()))
        except (EOFError, OSError):
            return
        except Exception as error:  # noqa: BLE001  # raised where the answer is wanted
            pipe.send(error)
