"""One interface for all tools that share their work: the same results in the same order, wherever they are computed."""

from collections.abc import Callable, Generator, Iterable
from contextlib import closing
from typing import TypeVar

from game.system.errors import EnvironmentMissingError
from tools.executor.lost import Lost, raised
from tools.executor.processes import process_results

Job = TypeVar("Job")
Result = TypeVar("Result")

Where = int | str
"""A number of processes on this machine, or the address of a Dask scheduler."""


def results(
    function: Callable[[Job], Result],
    jobs: Iterable[Job],
    where: Where = 1,
    *,
    alone: bool = False,
    time_limit: float | None = None,
) -> Generator[Result | Lost, None, None]:
    """The results of jobs, in the order of the jobs, which may be endless; `Lost` for those that have none.

    function: importable by its name. where: 1 computes in this process, unless `alone` asks for one of its own, since what the
    function does may kill it. time_limit: seconds for a job; only processes of their own can be stopped.
    A job whose process or machine dies is done again by another, once here, three times in a cluster. Close the generator
    to end all processes at once. Raises EnvironmentMissingError where no cluster answers, or one of another version.
    """
    if isinstance(where, str):
        from tools.executor.cluster import cluster_results  # noqa: PLC0415  # an extra

        yield from cluster_results(function, iter(jobs), where)
    elif where > 1 or alone:
        yield from process_results(function, iter(jobs), where, time_limit)
    else:
        for job in jobs:
            yield _result(function, job)


def sure(answers: Generator[Result | Lost, None, None]) -> Generator[Result, None, None]:
    """The results, of which none may be lost: what a job raised is raised here; EnvironmentMissingError for one that died."""
    with closing(answers):
        for answer in answers:
            if isinstance(answer, Lost):
                if answer.error is not None:
                    raise answer.error
                raise EnvironmentMissingError(f"a part of the work was lost: {answer.why}")
            yield answer


def _result(function: Callable[[Job], Result], job: Job) -> Result | Lost:
    """The result of a job in this process."""
    try:
        return function(job)
    except Exception as error:  # noqa: BLE001  # the caller decides
        return raised(error)
