"""Work in other processes: what kills one of them costs one job."""

import itertools
import multiprocessing
import os
import signal
import sys
import threading

import pytest

from tools.crosscheck.workers import Lost, results_of


def job(word):
    """What a worker does in these tests. Importable by its name, as the new process needs it."""
    if word == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    if word == "leave":
        os._exit(7)
    if word == "raise":
        raise ValueError(word)
    if word == "hang":
        threading.Event().wait()
    return word.upper()


def test_every_job_is_answered():
    """By two workers, five jobs: each result once, under its number."""
    words = ["a", "b", "c", "d", "e"]
    assert sorted(results_of(job, words, 2)) == list(enumerate("ABCDE"))


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL to send")
def test_a_death_loses_one_job():
    """Killed, gone or raised: that job is lost with its reason, the others come back."""
    results = dict(results_of(job, ["a", "die", "b", "leave", "raise", "c"], 1))
    assert results == {
        0: "A",
        1: Lost("its process was killed by SIGKILL"),
        2: "B",
        3: Lost("its process ended with exit code 7"),
        4: Lost("ValueError: raise"),
        5: "C",
    }


def test_a_job_that_hangs_is_given_up():
    """After the time limit its process is stopped, and the next job runs. The clock stands still but for one jump."""
    clock = itertools.chain([0.0], itertools.repeat(2.5))
    results = dict(results_of(job, ["hang", "a"], 1, time_limit=2.0, clock=lambda: next(clock)))
    assert results == {0: Lost("no answer within 2 s"), 1: "A"}
    assert multiprocessing.active_children() == []


def test_a_job_within_the_time_limit_is_waited_for():
    """A clock that stops just before the limit: the answer comes, however long the process needs to start."""
    clock = itertools.chain([0.0], itertools.repeat(2.0))
    assert dict(results_of(job, ["a"], 1, time_limit=2.0, clock=lambda: next(clock))) == {0: "A"}


def test_closing_ends_all_processes_at_once():
    """In the middle of jobs that would never end, without waiting for them."""
    results = results_of(job, ["a", "hang", "hang"], 2)
    assert next(results) == (0, "A")
    results.close()
    assert multiprocessing.active_children() == []
