"""Being ended by a signal, the same in every command.

Ctrl-C (SIGINT), a request to end (SIGTERM) and a closed terminal (SIGHUP): what was played is kept, one line says what
happened, and the exit code is 128 + the signal's number. How a signal acts depends on what the program is doing:

    loading, or ending    the program ends at once; there is nothing to keep
    working               KeyboardInterrupt is raised wherever the work is
    inside `deferred`     it is noted; loops ask `pending`, and KeyboardInterrupt is raised at the end of the block;
                          one more signal, seconds later, ends a block that does not come to its end

A signal that was ignored when the program was started (nohup, a shell's background job) stays ignored.
"""

import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from enum import Enum, auto
from types import FrameType, TracebackType
from typing import Protocol

from game.system.output import output_problem, print_error

WORDS = {"SIGINT": "interrupted", "SIGTERM": "terminated", "SIGHUP": "hung up"}
"""The signals, and what is said about them."""

_REMINDER = 5.0
"""Seconds after which a signal is raised again if the work goes on."""
_PATIENCE = 5.0
"""Seconds after which one more signal ends the program inside a block that defers signals."""


class Ended(KeyboardInterrupt):
    """The KeyboardInterrupt that signals raise here.

    A class of its own, because Python remembers that a plain one passed through `eval` or `exec` of a text, as happens when
    a named tuple is made. It would then kill the process by SIGINT at the very end, whatever its exit code was to be.
    """


class _Doing(Enum):
    """What the program is doing."""

    LOADING = auto()
    WORKING = auto()
    ENDING = auto()


class _Unraisable(Protocol):
    """What Python tells of an exception that nobody can catch."""

    exc_type: type[BaseException]
    exc_value: BaseException | None
    exc_traceback: TracebackType | None
    err_msg: str | None
    object: object


class _Signals:
    """What is known about signals in this process."""

    def __init__(self) -> None:
        """Before the first."""
        self.program = ""
        self.doing = _Doing.WORKING
        self.received: int | None = None
        self.since = 0.0
        self.deferrals = 0


_signals = _Signals()

deferred_signals: list[int] = []
"""The signal that came inside the `deferred` block that is running, as `pending` asks.

A loop whose rounds take microseconds reads this list instead: a call would be 1 % of a headless game.
"""


def watch_signals(program: str) -> None:
    """Have signals end the program at once, with one line, but for `working` blocks. program: its name in that line."""
    _signals.program, _signals.doing = program, _Doing.LOADING
    if hasattr(signal, "setitimer"):  # not on Windows
        signal.signal(signal.SIGALRM, _handle_again)
    for name in WORDS:
        number = getattr(signal, name, None)  # Windows has no SIGHUP
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _handle)
    sys.unraisablehook = _unraisable


@contextmanager
def working() -> Iterator[None]:
    """A block in which a signal raises KeyboardInterrupt; after it, when everything is done, one ends the program at once."""
    before = _signals.doing
    _signals.doing, _signals.received = _Doing.WORKING, None
    try:
        yield
    finally:
        _signals.doing = _Doing.ENDING if before is _Doing.LOADING else before
        _remind(0.0)


def pending() -> bool:
    """Whether a signal came inside the `deferred` block that is running: time to come to its end."""
    return bool(deferred_signals)


def signal_words() -> str:
    """Which signal came, in words: "interrupted" and the like."""
    return WORDS[signal.Signals(_received()).name]


def exit_code() -> int:
    """128 + the number of the signal that was received; that of Ctrl-C if none was seen here."""
    return 128 + _received()


@contextmanager
def deferred() -> Iterator[None]:
    """A block that a signal does not tear apart: KeyboardInterrupt is raised at its end.

    Blocks may lie inside each other; then it is the end of the outermost that counts.
    """
    _signals.deferrals += 1
    try:
        yield
    finally:
        _signals.deferrals -= 1
        if deferred_signals and _signals.deferrals == 0:
            deferred_signals.clear()
            raise Ended


@contextmanager
def interrupts_blocked() -> Iterator[None]:
    """A block whose new processes never see Ctrl-C or a closed terminal: they are sent to all, and one process is to answer."""
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    from multiprocessing import resource_tracker  # noqa: PLC0415  # takes time to load

    resource_tracker.ensure_running()  # or the first process would start it, which unblocks SIGINT on the way
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGHUP})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _handle(number: int, _frame: FrameType | None) -> None:
    """A signal has come."""
    if _signals.received is None:
        _signals.received = number
    if _signals.doing is not _Doing.WORKING:
        _end_now()
    _remind(_REMINDER)
    if not _signals.deferrals:
        raise Ended
    if not deferred_signals:
        deferred_signals.append(number)
        _signals.since = time.monotonic()
    elif time.monotonic() - _signals.since > _PATIENCE:
        _end_now()


def _handle_again(_number: int, frame: FrameType | None) -> None:
    """The work goes on some time after a signal: the exception was lost, as in C code that clears errors while it imports."""
    if _signals.doing is _Doing.WORKING and not deferred_signals:
        _handle(_received(), frame)


def _remind(seconds: float) -> None:
    """Have the signal handled again after some time; 0 for never."""
    if _signals.program and hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_REAL, seconds)


def _received() -> int:
    """The number of the first signal."""
    return int(signal.SIGINT) if _signals.received is None else _signals.received


def _end_now() -> None:
    """End the program without another line of Python; with one line on stderr unless everything was said already."""
    if _signals.doing is not _Doing.ENDING:
        print_error(f"{_signals.program}: {signal_words()}")
    output_problem()  # writes what is still to be written
    os._exit(exit_code())


def _unraisable(told: _Unraisable) -> None:
    """KeyboardInterrupt where Python can only report it, in a callback of C code or a destructor, ends the program, too."""
    if issubclass(told.exc_type, KeyboardInterrupt):
        _end_now()
    sys.__unraisablehook__(told)  # the same attributes
