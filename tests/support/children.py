"""Child processes of a test: each leads a process group of its own, which is ended with the test."""

import contextlib
import ctypes
import os
import re
import signal
import subprocess
import sys
import time

GIVE_UP = 600.0
"""Seconds after which `eventually` calls a condition false: far beyond what a busy machine needs, so only a fault meets it."""


_LIBC = ctypes.CDLL(None) if sys.platform == "linux" else None
_PR_SET_PDEATHSIG = 1
"""Linux's prctl: the signal that a process gets when its parent ends."""


class Children:
    """Starts child processes; `end` kills every group that was started, whatever is left in it."""

    def __init__(self):
        self._started = []

    def start(self, command, **options):
        """A new child; the options are those of `subprocess.Popen`. On Windows only the child itself is ended.

        It has the signal handlers of a program started at a terminal. Without this it would ignore Ctrl-C under a shell's
        background command, and a closed terminal under nohup. On Linux it is also killed if this process ends without calling
        `end`: a killed pytest leaves no game and no X server behind.
        """
        if sys.platform != "win32":
            options |= {"start_new_session": True, "preexec_fn": _prepare}
        child = subprocess.Popen(command, **options)
        self._started.append(child)
        return child

    def end(self):
        """Kill every group and wait for its leader."""
        for child in self._started:
            if sys.platform == "win32":
                child.kill()
            else:
                with contextlib.suppress(ProcessLookupError):  # everything in the group has ended already
                    os.killpg(child.pid, signal.SIGKILL)
            for stream in (child.stdin, child.stdout, child.stderr):
                if stream is not None:
                    stream.close()
            child.wait()


def _prepare():
    """Run in the child before its program: reset its signals, and let it end with this process."""
    if _LIBC is not None:
        _LIBC.prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    for number in (signal.SIGHUP, signal.SIGINT, signal.SIGQUIT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)


class Terminal:
    """A terminal that a child writes to: some programs show their progress on nothing else. Not for Windows."""

    def __init__(self):
        self._ours, self.theirs = os.openpty()
        self.text = ""

    def read_until(self, pattern):
        """Read until the pattern is found in all that was written; an AssertionError if the writers end before."""
        while not re.search(pattern, self.text):
            assert self._read(), f"ended without {pattern!r}: {self.text}"

    def read_to_the_end(self):
        """Read until no process has the terminal open any more; all that was ever written."""
        while self._read():
            pass
        return self.text

    def given(self):
        """Call this once the child has the terminal: the end is seen only when nobody else holds it."""
        os.close(self.theirs)
        self.theirs = None

    def close(self):
        """Close what is open."""
        for end in (self._ours, self.theirs):
            if end is not None:
                os.close(end)

    def _read(self):
        """Whether there was more to read."""
        try:
            data = os.read(self._ours, 65536)
        except OSError:  # how Linux says that the last writer is gone
            return False
        self.text += data.decode(errors="replace")
        return bool(data)


def eventually(condition):
    """Wait until a condition holds, however long that takes on a busy machine."""
    end = time.monotonic() + GIVE_UP
    while not condition():
        assert time.monotonic() < end, condition
        time.sleep(0.005)
