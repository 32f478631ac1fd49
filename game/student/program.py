"""The student's program: a child process that is asked one question at a time, and started again when it fails."""

import contextlib
import json
import os
import queue
import re
import signal
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from game.student.reply import Reply, parsed_answer, shown_text
from game.system.errors import BadInputError, EnvironmentMissingError

_LONGEST_ANSWER = 65536
_ENDING = 5.0
"""Seconds in which a program that has closed its output must end."""
_REMEMBERED = 40
"""Lines at the end of stderr that are looked at when the program has ended: the trace of a Python program is among them."""
_GRACE = 1.0
"""Seconds beyond the limit in which a Python file's host ends itself and says where it hung."""
_HOST = Path(__file__).with_name("python_host.py")
_FRAME = re.compile(r'File "(?P<file>.*)", line (?P<line>\d+) in ')
"""A line of the trace that `faulthandler` writes."""


class Limits(NamedTuple):
    """What the student's program may use.

    answer: seconds for a question. start: seconds for the first question after a start. memory: mebibytes.
    """

    answer: float = 2.0
    start: float = 20.0
    memory: int = 2048


Lines = queue.SimpleQueue[bytes]
"""One line of the program's output for each that was asked for; empty where the output has ended."""
Wait = Callable[[Lines, float], bytes | None]
"""Takes the next line; None when the seconds have passed."""


def next_line(lines: Lines, seconds: float) -> bytes | None:
    """The next line by the clock."""
    try:
        return lines.get(timeout=seconds)
    except queue.Empty:
        return None


def python_host(limits: Limits, file: Path | None = None) -> list[str]:
    """The command that answers with a Python file's functions; without a file, those of the text that it is asked to load.

    EnvironmentMissingError where there is no Python to run it.
    """
    if getattr(sys, "frozen", False) or not _HOST.is_file():
        raise EnvironmentMissingError("a file of functions needs Python and this package unpacked: no archive, no application")
    return [sys.executable, str(_HOST), str(limits.answer), *([] if file is None else [str(file.resolve())])]


class Student:
    """A program that answers questions by the line protocol. Close it after use.

    command: the program and its arguments. wait: by the clock, unless a test decides. file: the Python file that it runs; where
    it hung or crashed there, the problem names the line. BadInputError is raised where the program cannot be started, or says
    that it cannot be used.
    """

    def __init__(self, command: Sequence[str], limits: Limits, wait: Wait = next_line, file: Path | None = None) -> None:
        self._command, self._limits, self._wait, self._file = list(command), limits, wait, file
        self._running: _Running | None = None

    def ask(self, function: str, arguments: Sequence[object]) -> Reply:
        """The program's answer. Whatever goes wrong is in the reply, and the next question finds a fresh program."""
        fresh = self._running is None
        lines = self.send(function, arguments)
        seconds = self._limits.start if fresh else self._limits.answer
        return self.reply(self._wait(lines, seconds + (0.0 if self._file is None else _GRACE)), seconds)

    def send(self, function: str, arguments: Sequence[object]) -> Lines:
        """Ask without waiting: where the line of the answer will arrive. It is for `reply`, before the next question."""
        if self._running is None:
            self._running = _Running(self._command, self._limits.memory)
        return self._running.asked(json.dumps({"function": function, "arguments": list(arguments)}))

    def reply(self, line: bytes | None, seconds: float) -> Reply:
        """The answer in a line of the program's output; None where none came within some seconds."""
        if line is None:
            return self._failed(f"no answer within {seconds:g} seconds")
        if not line:
            assert self._running is not None, "a line was waited for"
            return self._failed(self._last_words(self._running))
        reply = _parsed(line)
        return self._failed(reply.problem) if reply.ended else reply

    def close(self) -> None:
        """End the program, and whatever it has started."""
        if self._running is not None:
            self._running.end()
            self._running = None

    def _last_words(self, running: "_Running") -> str:
        """How the program ended by itself: the line of its file, its exit code or signal, and its last line on stderr."""
        how, written = running.ended()
        frames = [found for line in written if (found := _FRAME.search(line)) is not None]
        line = next((frame["line"] for frame in frames if frame["file"] == str(self._file)), None)
        where = "" if line is None else f"line {line}: "
        if frames and any([words.startswith("Timeout (") for words in written]):
            return f"{where}no answer within {self._limits.answer:g} seconds"
        words = next((line.strip() for line in reversed(written) if line.strip()), "")
        return f"{where}the program ended ({how}){f': {shown_text(words)}' if words and not frames else ''}"

    def _failed(self, problem: str | None) -> Reply:
        """The reply to a question during which the program ended."""
        self.close()
        return Reply(problem=problem, ended=True)


class _Running:
    """One run of the program."""

    def __init__(self, command: list[str], memory: int) -> None:
        limited = [sys.executable, str(Path(__file__).with_name("memory_limit.py")), str(memory), *command]
        pipe = subprocess.PIPE
        try:
            self._process = subprocess.Popen(  # noqa: S603  # running the student's program is the purpose
                command if sys.platform == "win32" else limited, stdin=pipe, stdout=pipe, stderr=pipe, start_new_session=True
            )
        except OSError as error:
            raise BadInputError(f"{command[0]}: cannot be started; {error.strerror}") from None
        assert self._process.stdin and self._process.stdout and self._process.stderr  # noqa: PT018  # all three are pipes
        self._stdin, self._stdout, self._stderr = self._process.stdin, self._process.stdout, self._process.stderr
        self._ended = False
        self._wanted = threading.Semaphore(0)
        self._lines: Lines = queue.SimpleQueue()
        self._errors: deque[bytes] = deque(maxlen=_REMEMBERED)
        self._threads = [
            threading.Thread(target=self._read, daemon=True),
            threading.Thread(target=self._read_errors, daemon=True),
        ]
        for thread in self._threads:
            thread.start()

    def asked(self, question: str) -> Lines:
        """Where the answer to a question will arrive."""
        with contextlib.suppress(OSError):  # the program has ended: its output ends, too
            self._stdin.write(question.encode() + b"\n")
            self._stdin.flush()
        self._wanted.release()
        return self._lines

    def ended(self) -> tuple[str, list[str]]:
        """How the program ended by itself: its exit code or signal; and the last lines that it wrote on stderr."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_ENDING)
        self._kill()
        code = self._process.wait()
        self._threads[1].join(_ENDING)
        written = b"".join(self._errors).decode(errors="replace").split("\n")
        return f"exit code {code}" if code >= 0 else signal.Signals(-code).name, written

    def end(self) -> None:
        """Kill the program with all that it has started, and wait for it."""
        self._kill()
        self._process.wait()
        self._ended = True
        self._wanted.release()
        with contextlib.suppress(OSError):  # what was not yet written has no reader
            self._stdin.close()
        for thread, stream in zip(self._threads, (self._stdout, self._stderr), strict=True):
            thread.join(_ENDING)
            if not thread.is_alive():  # else a program that left the group still holds the pipe
                stream.close()

    def _kill(self) -> None:
        """Kill the process group."""
        if sys.platform == "win32":
            self._process.kill()
        else:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self._process.pid, signal.SIGKILL)

    def _read(self) -> None:
        """Read one line whenever one is wanted; so a program that prints without end fills its pipe, and no memory of ours."""
        while True:
            self._wanted.acquire()
            if self._ended:
                return
            line = self._stdout.readline(_LONGEST_ANSWER)
            self._lines.put(line)
            if not line:
                return

    def _read_errors(self) -> None:
        """Read stderr, and remember its end."""
        while line := self._stderr.readline(_LONGEST_ANSWER):
            self._errors.append(line)


def _parsed(line: bytes) -> Reply:
    """The reply in a line; `ended` where it is none, since what else the program will print is unknown."""
    with contextlib.suppress(ValueError, RecursionError):
        reply = parsed_answer(json.loads(line))
        if not reply.ended:
            return reply
    return Reply(problem=f"not an answer: {shown_text(line.decode(errors='replace').strip())}", ended=True)
