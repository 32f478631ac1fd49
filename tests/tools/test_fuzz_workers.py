"""Work that is shared by processes: results in order, faults where they are wanted, nothing left running."""

import itertools
import multiprocessing
import os
import signal
from contextlib import closing

import pytest

from game.system.errors import EnvironmentMissingError
from tools.fuzz.workers import shared_out


def squared(number):
    """A job."""
    return number * number


def failing(number):
    """A job that raises at 5."""
    if number == 5:
        raise ValueError("five")
    return number


def dying(number):
    """A job whose process is killed at 5."""
    if number == 5:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


@pytest.fixture(autouse=True)
def _nothing_is_left():
    """After every test."""
    yield
    assert multiprocessing.active_children() == []


@pytest.mark.parametrize("workers", [1, 2, 3])
@pytest.mark.parametrize("count", [0, 1, 2, 50])
def test_results_come_in_the_order_of_the_jobs(workers, count):
    """However many processes there are, also more than jobs."""
    assert list(shared_out(squared, iter(range(count)), workers)) == [k * k for k in range(count)]


def test_jobs_may_go_on_for_ever():
    """Who has enough closes the generator, and the processes end."""
    with closing(shared_out(squared, itertools.count(), 2)) as results:
        assert list(itertools.islice(results, 9)) == [k * k for k in range(9)]
        assert len(multiprocessing.active_children()) == 2


@pytest.mark.parametrize("workers", [1, 2])
def test_what_a_job_raises_is_raised_where_its_result_is_wanted(workers):
    """The results before it have come."""
    found = []
    with pytest.raises(ValueError, match="five"):
        iter_all(shared_out(failing, iter(range(9)), workers), found)
    assert found == [0, 1, 2, 3, 4]


def iter_all(results, found):
    """Put results into a list one by one, to see those before an exception."""
    for result in results:
        found.append(result)


def test_a_process_that_dies_is_named():
    """By how it ended."""
    found = []
    with pytest.raises(EnvironmentMissingError, match="died with exit code -9"):
        iter_all(shared_out(dying, iter(range(9)), 2), found)
    assert found == [0, 1, 2, 3, 4]
