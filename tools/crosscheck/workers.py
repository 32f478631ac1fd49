"""Games that are checked in processes of their own, so that what kills one of them costs one game and not the run."""

from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from typing import TypeVar

from tools.executor import Lost, Where, results

Job = TypeVar("Job")
Result = TypeVar("Result")

TIME_LIMIT = 1800.0
"""Seconds for one job: an hour's game takes a quarter of it. pymunk can also hang, not only die."""


def results_of(
    function: Callable[[Job], Result], jobs: Sequence[Job], workers: Where
) -> Generator[tuple[int, Result | Lost], None, None]:
    """(number of the job, its result), in order; `Lost` for those whose process did not live to answer.

    function: importable by its name; what it raises is its job's loss. Close the generator to end all processes at once.
    """
    with closing(results(function, jobs, workers, alone=True, time_limit=TIME_LIMIT)) as answers:
        yield from enumerate(answers)
