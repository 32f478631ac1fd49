"""Work in other processes: what kills one of them costs one job."""

import multiprocessing
import os
import signal
import time

from tools.crosscheck.workers import Lost, results_of


def job(word):
    """What a worker does in these tests. Importable by its name, as the new process needs it."""
    if word == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    if word == "leave":
        os._exit(7)
    if word == "raise":
        raise ValueError(word)
    if word == "sleep":
        time.sleep(60.0)
    return word.upper()


def test_every_job_is_answered():
    """By two workers, five jobs: each result once, under its number."""
    words = ["a", "b", "c", "d", "e"]
    assert sorted(results_of(job, words, 2)) == list(enumerate("ABCDE"))


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
    """After the time limit its process is stopped, and the next job runs."""
    before = time.monotonic()
    results = dict(results_of(job, ["sleep", "a"], 1, time_limit=2.0))
    assert results == {0: Lost("no answer within 2 s"), 1: "A"}
    assert time.monotonic() - before < 30.0


def test_closing_ends_all_processes_at_once():
    """In the middle of a job, without waiting for it."""
    results = results_of(job, ["a", "sleep", "sleep"], 2)
    assert next(results) == (0, "A")
    before = time.monotonic()
    results.close()
    assert time.monotonic() - before < 30.0
    assert multiprocessing.active_children() == []
