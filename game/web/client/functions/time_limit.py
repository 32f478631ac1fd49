"""A limit on the time of a student's code in this very process: an endless loop ends with an exception in its line."""

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import CodeType
from typing import Any

_MONITORING: Any = getattr(sys, "monitoring", None)
"""Since Python 3.12, and so in every browser; without it there is no limit."""
_TOOL = 4
"""A number that no debugger and no profiler has (PEP 669)."""
_JUMPS = 256
"""Jumps between two looks at the clock."""


class TooLongError(Exception):
    """The code did not answer in time."""


class TimeLimit:
    """Watches the jumps of code objects: every loop in Python has one. A loop within a function written in C has none."""

    def __init__(self, seconds: float) -> None:
        """seconds: for one use of `running`."""
        self._seconds, self._until, self._jumps = seconds, 0.0, 0
        if _MONITORING is not None:
            if _MONITORING.get_tool(_TOOL) is not None:
                _MONITORING.free_tool_id(_TOOL)
            _MONITORING.use_tool_id(_TOOL, "time limit")
            _MONITORING.register_callback(_TOOL, _MONITORING.events.JUMP, self._jumped)

    def watch(self, code: CodeType) -> None:
        """Watch a code object, and all that is defined in it."""
        if _MONITORING is not None:
            _MONITORING.set_local_events(_TOOL, code, _MONITORING.events.JUMP)
        for inner in code.co_consts:
            if isinstance(inner, CodeType):
                self.watch(inner)

    @contextmanager
    def running(self) -> Iterator[None]:
        """What runs in here raises TooLongError when it has used up the time."""
        self._until = time.monotonic() + self._seconds
        try:
            yield
        finally:
            self._until = 0.0

    def _jumped(self, _code: CodeType, _offset: int, _target: int) -> None:
        """Look at the clock now and then."""
        self._jumps += 1
        if self._until and self._jumps % _JUMPS == 0 and time.monotonic() > self._until:
            raise TooLongError(f"no answer within {self._seconds:g} seconds")
