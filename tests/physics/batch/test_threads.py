"""Pieces of work shared by threads: results in order, no piece waits behind another, exceptions are raised."""

import subprocess
import sys
import threading
import time

import pytest

from physics.batch import threads
from physics.batch.threads import shared
from tests.support.paths import ROOT

PATIENCE = 60.0
"""Seconds after which a waiting thread gives up."""
AFTER_A_FORK = """
import os, signal
from physics.batch.threads import shared
assert shared(abs, 4, 2) == [0, 1, 2, 3]
child = os.fork()
if child == 0:
    signal.alarm(60)
    os._exit(0 if shared(abs, 4, 2) == [0, 1, 2, 3] else 1)
print(os.waitpid(child, 0)[1])
"""


@pytest.mark.parametrize(("pieces", "threads"), [(1, 1), (7, 1), (2, 2), (9, 2), (9, 4), (3, 3)])
def test_the_results_are_in_the_order_of_the_pieces(pieces, threads):
    """Whichever thread did them."""
    assert shared(lambda piece: piece * piece, pieces, threads) == [piece * piece for piece in range(pieces)]


@pytest.mark.parametrize("slow", [0, 2])
def test_who_is_done_helps_a_thread_that_is_held_up(slow):
    """The first piece of one of two threads ends only when its second piece is done; so the other thread does the second."""
    helped = threading.Event()

    def work(piece):
        if piece == slow + 1:
            helped.set()
        return helped.wait(PATIENCE) if piece == slow else True

    assert shared(work, 4, 2) == [True] * 4


def test_what_a_piece_raises_is_raised_when_all_are_done():
    """The pieces after it are done, too; the threads serve the next call."""
    done = []

    def work(piece):
        if piece == 0:
            raise RuntimeError(f"piece {piece}")
        done.append(piece)

    with pytest.raises(RuntimeError, match="piece 0"):
        shared(work, 4, 2)
    assert sorted(done) == [1, 2, 3]
    assert shared(abs, 2, 2) == [0, 1]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork")
def test_a_forked_process_starts_threads_of_its_own():
    """It has none of its parent's threads; without threads of its own it would wait for ever."""
    command = [sys.executable, "-W", "ignore", "-c", AFTER_A_FORK]
    assert subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout == "0\n"


def test_nothing_is_at_work_any_more_when_the_caller_is_interrupted(monkeypatch):
    """Here since no further thread can be started, as by Ctrl-C: what was begun is done, and nothing else is begun."""
    begun, ended, first = [], [], threading.Event()
    queue_of = threads._waiting

    def work(piece):
        begun.append(piece)
        first.set()
        time.sleep(0.05)
        ended.append(piece)

    def one_thread(number):
        if number == 0:
            return queue_of(number)
        first.wait(PATIENCE)
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(threads, "_waiting", one_thread)
    with pytest.raises(RuntimeError, match="new thread"):
        shared(work, 9, 3)
    assert len(begun) == 1
    assert ended == begun


def test_work_under_way_is_told_that_the_caller_is_interrupted(monkeypatch):
    """Else Ctrl-C would wait for the longest piece, which may be minutes of a large step."""
    interrupted, begun, queue_of = threading.Event(), threading.Event(), threads._waiting

    def work(_piece):
        begun.set()
        assert interrupted.wait(PATIENCE)

    def one_thread(number):
        if number == 0:
            return queue_of(number)
        begun.wait(PATIENCE)
        raise KeyboardInterrupt

    monkeypatch.setattr(threads, "_waiting", one_thread)
    with pytest.raises(KeyboardInterrupt):
        shared(work, 9, 3, interrupted)
    assert interrupted.is_set()
