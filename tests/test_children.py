"""What a test starts is ended with it."""

import os
import signal
import subprocess
import sys

import pytest

from tests.support.children import Children, Terminal, eventually
from tests.support.paths import ROOT

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has neither process groups nor terminals of this kind")

_GRANDCHILD = "import time; print('alive', flush=True); time.sleep(1000)"
_CHILD = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {_GRANDCHILD!r}])"


def test_a_child_and_its_own_children_are_killed():
    """The pipe that both write to reaches its end, which it does only when nobody is left to write."""
    started = Children()
    reading, writing = os.pipe()
    child = started.start([sys.executable, "-c", _CHILD], stdout=writing)
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8") as told:
        assert told.readline() == "alive\n"
        started.end()
        assert child.returncode is not None
        assert told.read() == ""


_STARTER = """
import sys, time
from tests.support.children import Children

Children().start([sys.executable, "-c", sys.argv[1]])
time.sleep(1000)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells a child that its parent has ended")
def test_a_child_does_not_outlive_a_killed_pytest(children):
    """The child ends although the process that would call `end` is killed."""
    reading, writing = os.pipe()
    starter = children.start([sys.executable, "-c", _STARTER, _GRANDCHILD], stdout=writing, cwd=ROOT)
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8") as told:
        assert told.readline() == "alive\n"
        os.kill(starter.pid, signal.SIGKILL)
        assert told.read() == ""


@pytest.mark.parametrize("name", ["SIGINT", "SIGHUP"])
def test_a_child_ignores_no_signal(children, name):
    """Not even if this process does, as it does in the background of a shell or under nohup."""
    number = getattr(signal, name)
    before = signal.signal(number, signal.SIG_IGN)
    try:
        child = children.start(
            [sys.executable, "-c", f"import signal; signal.raise_signal(signal.{name})"], stderr=subprocess.DEVNULL
        )
    finally:
        signal.signal(number, before)
    assert child.wait() == -number


def test_a_child_that_has_ended_is_no_error():
    """There is no group to kill any more."""
    started = Children()
    started.start([sys.executable, "-c", ""]).wait()
    started.end()


def test_a_terminal_tells_when_its_writers_are_gone():
    """What was written is there; a pattern that never comes is an error and not an endless wait."""
    started, terminal = Children(), Terminal()
    started.start([sys.executable, "-c", "print('one two')"], stdout=terminal.theirs)
    terminal.given()
    terminal.read_until("one")
    assert "two" in terminal.read_to_the_end()
    with pytest.raises(AssertionError, match="ended without 'three'"):
        terminal.read_until("three")
    terminal.close()
    started.end()


def test_eventually_waits_for_its_condition():
    """It asks until the answer is yes."""
    answers = iter([False, False, True])
    eventually(lambda: next(answers))
    assert list(answers) == []
