"""Where every command's words go: two streams that cannot fail, and the two functions that write a line to them.

A terminal may be closed, a disk full, a reader gone, a character missing from the encoding. None of this is a reason to stop
what the command is doing, so the streams made here never raise: a character that cannot be encoded is written as its escape,
and after the first write that fails the rest is dropped. `output_problem` tells why, for the exit code.
"""

import io
import os
import select
import sys
from typing import TextIO

from game.system.wording import printable


class UnfailingStream(io.RawIOBase):
    """A raw stream in front of another one. Its writes never raise; problem: the first error of the other one."""

    def __init__(self, raw: io.RawIOBase) -> None:
        """raw: where the bytes go. It is not closed with this stream."""
        self._raw = raw
        self.problem: OSError | None = None

    def write(self, data: object) -> int:
        """Write all bytes of a buffer, or drop them; their number."""
        left = memoryview(data).cast("B")  # type: ignore[arg-type]  # any buffer
        size = left.nbytes
        while left and self.problem is None:
            try:
                written = self._raw.write(left)
                if written is None:  # not ready: a terminal that somebody has made non-blocking
                    select.select([], [self._raw], [])
                else:
                    left = left[written:]
            except OSError as error:
                self.problem = error
        return size

    def writable(self) -> bool:
        """Always."""
        return True

    def fileno(self) -> int:
        """That of the other stream."""
        return self._raw.fileno()

    def isatty(self) -> bool:
        """Whether the other stream is a terminal."""
        return self._raw.isatty()


def open_output() -> None:
    """Put streams that cannot fail in the place of `sys.stdout` and `sys.stderr`; once, before anything is written.

    Numbers 0 to 2 that are closed are opened on the null device first, or the next file that is opened would get what other
    libraries print.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)  # the lowest free number, which is this
    sys.stdout, sys.stderr = _unfailing(sys.stdout, 1), _unfailing(sys.stderr, 2)


def print_line(line: str) -> None:
    """One line on stdout."""
    sys.stdout.write(f"{line}\n")


def print_error(line: str) -> None:
    """One line on stderr, whatever characters it quotes."""
    sys.stderr.write(f"{printable(line)}\n")


def output_problem() -> str | None:
    """Why output was dropped, once all of it is written; None if none was, or only because nobody reads on."""
    for stream in (sys.stdout, sys.stderr):
        stream.flush()
    raw = getattr(getattr(sys.stdout, "buffer", None), "raw", None)
    problem = raw.problem if isinstance(raw, UnfailingStream) else None
    return None if problem is None or isinstance(problem, BrokenPipeError) else problem.strerror or str(problem)


def _unfailing(stream: TextIO | None, number: int) -> TextIO:
    """A stream like the given one that cannot fail. stream: None where the program was started without it."""
    buffer = io.FileIO(number, "w", closefd=False) if stream is None else stream.buffer
    raw = UnfailingStream(getattr(buffer, "raw", buffer))  # type: ignore[arg-type]  # an unbuffered stream is raw itself
    return io.TextIOWrapper(
        io.BufferedWriter(raw),
        encoding="utf-8" if stream is None else stream.encoding,
        errors="backslashreplace",
        line_buffering=number == 2 or bool(getattr(stream, "line_buffering", False)),
        write_through=bool(getattr(stream, "write_through", False)),
    )
