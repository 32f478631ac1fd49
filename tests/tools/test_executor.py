"""Work that is shared: the same results in the same order, whoever dies; nothing left running."""

import itertools
import multiprocessing
import os
import signal
import sys
import threading
import time
from contextlib import closing

import pytest

from game.system.errors import EnvironmentMissingError
from tools.executor import Lost, results, sure
from tools.executor.processes import process_results


def squared(number):
    """A job."""
    return number * number


def job(word):
    """A job that may do harm. Importable by its name, as the new process needs it."""
    if word == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    if word == "leave":
        os._exit(7)
    if word == "raise":
        raise ValueError(word)
    if word == "hang":
        threading.Event().wait()
    if word == "unsendable":
        return lambda: None
    return word.upper()


def dies_once(path):
    """A job whose first process is killed."""
    if not path.exists():
        path.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return path.name


def opens_or_waits(paths):
    """A job that creates its own file, then waits for another job's, at most a minute. Returns whether it came."""
    own, awaited = paths
    own.touch()
    for _ in range(6000):
        if awaited.exists():
            return True
        time.sleep(0.01)
    return False


@pytest.fixture(autouse=True)
def _nothing_is_left():
    """After every test."""
    yield
    assert multiprocessing.active_children() == []


@pytest.mark.parametrize(("workers", "count"), [(1, 0), (1, 50), (2, 0), (2, 1), (3, 200)])
def test_results_come_in_the_order_of_the_jobs(workers, count):
    """However many processes there are, also more than jobs."""
    assert list(results(squared, range(count), workers)) == [k * k for k in range(count)]


def test_jobs_may_go_on_for_ever():
    """Who has enough closes the generator, and the processes end."""
    with closing(results(squared, itertools.count(), 2)) as answers:
        assert list(itertools.islice(answers, 9)) == [k * k for k in range(9)]
        assert len(multiprocessing.active_children()) == 2


def test_the_last_job_is_not_left_behind_a_long_one(tmp_path):
    """The first of three jobs ends only when the third has begun; so the process that has done the second takes the third."""
    first, third = tmp_path / "first", tmp_path / "third"
    assert list(results(opens_or_waits, [(first, third), (first, first), (third, third)], 2)) == [True, True, True]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL to send")
def test_a_death_loses_one_job():
    """Killed twice, gone twice, raised, or a result that cannot be sent: lost with its reason; the others come back."""
    words = ["a", "die", "b", "leave", "raise", "unsendable", "c"]
    answers = [answer.why if isinstance(answer, Lost) else answer for answer in results(job, words, 2, alone=True)]
    assert answers[:5] == [
        "A",
        "its process was killed by SIGKILL",
        "B",
        "its process ended with exit code 7",
        "ValueError: raise",
    ]
    assert "pickle" in answers[5]
    assert answers[6] == "C"


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL to send")
def test_what_a_killed_process_had_is_done_again(tmp_path):
    """By another process, once."""
    paths = [tmp_path / name for name in "abc"]
    paths[1].touch()
    assert list(results(dies_once, paths, 2)) == ["a", "b", "c"]


def test_a_job_that_hangs_is_given_up():
    """After the time limit its process is stopped, and the next job runs. The clock stands still but for one jump."""
    clock = itertools.chain([0.0], itertools.repeat(2.5))
    answers = process_results(job, iter(["hang", "a"]), 1, time_limit=2.0, clock=lambda: next(clock))
    assert list(answers) == [Lost("no answer within 2 s"), "A"]


def test_a_job_within_the_time_limit_is_waited_for():
    """A clock that stops just before the limit: the answer comes, however long the process needs to start."""
    clock = itertools.chain([0.0], itertools.repeat(2.0))
    assert list(process_results(job, iter(["a"]), 1, time_limit=2.0, clock=lambda: next(clock))) == ["A"]


def test_closing_ends_all_processes_at_once():
    """In the middle of jobs that would never end, without waiting for them."""
    answers = results(job, ["a", "hang", "hang"], 2)
    assert next(answers) == "A"
    answers.close()
    assert multiprocessing.active_children() == []


@pytest.mark.parametrize("workers", [1, 2])
def test_where_nothing_may_be_lost_a_job_raises_what_it_raised(workers):
    """After the results before it."""
    answers = sure(results(job, ["a", "raise", "b"], workers))
    assert next(answers) == "A"
    with pytest.raises(ValueError, match="raise"):
        next(answers)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL to send")
def test_where_nothing_may_be_lost_a_death_is_named():
    """By how the process ended."""
    with pytest.raises(EnvironmentMissingError, match="killed by SIGKILL"):
        list(sure(results(job, ["die"], 2)))
