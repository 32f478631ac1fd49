"""A Python file of a student's functions: it runs in a child process, and is read again when it was saved."""

import importlib.util
import queue
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Self

from game.language import tr
from game.student.answering import note_of, placed_problem, usable_result
from game.student.program import Limits, Lines, Student, Wait, next_line, python_host
from game.student.reply import Reply
from game.system.errors import BadInputError, CheckFailedError
from game.system.wording import quoted_path

OWN_LIMITS = Limits(answer=2.0, start=20.0, memory=1024)
"""What a file may use that the game or the lab waits for."""
_LOOK_EVERY = 1.0
"""Seconds between two looks at whether the file was saved."""
_LARGEST_FILE = 1 << 20
"""Bytes."""


class FunctionsFile:
    """The functions of the last version of a file that could be read. Close it after use.

    If a new version cannot be read or run, the functions of the version before stay. If a function fails, none answers until
    the file is saved again. Apart from `check`, no method raises: `problem` says what is wrong.

    Attributes:
        own: names of the source's functions that the file defines, and "advance" where it has one; empty where none answers.
        problem: what is wrong, in one line that names the file's line where there is one; "" where nothing is.
        broken: the first problem there ever was.
    """

    def __init__(
        self,
        path: Path,
        limits: Limits = OWN_LIMITS,
        wait: Wait = next_line,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Read the file. wait, clock: by the clock, unless a test decides.

        BadInputError is raised for a file that is not there, EnvironmentMissingError where no Python can run it.
        """
        if not path.is_file():
            raise BadInputError(f"--with {quoted_path(path)}: no such file")
        self._path, self._limits, self._wait, self._clock = path.resolve(), limits, wait, clock
        self._command = python_host(limits)
        self.own: frozenset[str] = frozenset()
        self.problem = self.broken = self._news = ""
        self._student: Student | None = None
        self._loading: tuple[Student, Lines, float] | None = None
        self._stamp: tuple[int, int] | None = None
        self._next_look = clock() + _LOOK_EVERY
        self._load()
        if self._loading is not None:
            student, lines, _ = self._loading
            self._loaded(student, self._wait(lines, limits.start))
        self._news = ""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def name(self) -> str:
        """The file's name."""
        return self._path.name

    @property
    def note(self) -> str:
        """One line that says whose functions answer."""
        return note_of(self.name, self.own, self.problem, answers=self._student is not None)

    def refresh(self) -> str:
        """Look at the file, at most once a second, and read it again if it was saved. Returns news in a few words, or "".

        It does not wait: what is being read answers at a later call.
        """
        if self._loading is not None:
            student, lines, until = self._loading
            try:
                self._loaded(student, lines.get_nowait())
            except queue.Empty:
                if self._clock() > until:
                    self._loaded(student, None)
        elif self._clock() >= self._next_look:
            self._next_look = self._clock() + _LOOK_EVERY
            self._load()
        news, self._news = self._news, ""
        return news

    def ask(self, name: str, arguments: Sequence[object]) -> object:
        """The result of one question; None if it failed, and then no function answers until the file is saved."""
        return None if self._student is None else usable_result(self, name, self._student.ask(name, arguments))

    def reject(self, problem: str) -> None:
        """Let no function answer until the file is saved again. problem: why, without the file's name."""
        self._tell(problem)
        self.own = frozenset()
        if self._student is not None:
            self._student.close()
            self._student = None

    def check(self) -> None:
        """Raise CheckFailedError where anything has been wrong with the file."""
        if self.broken:
            raise CheckFailedError(f"{self.broken}; from there on the slides' own functions answered")

    def close(self) -> None:
        """End the child process."""
        for student in (self._student, None if self._loading is None else self._loading[0]):
            if student is not None:
                student.close()
        self._student = self._loading = None

    def _load(self) -> None:
        """Begin to read the file, if it is another one than was last read."""
        try:
            found = self._path.stat()
            if (found.st_mtime_ns, found.st_size) == self._stamp:
                return
            text = importlib.util.decode_source(self._path.read_bytes()[:_LARGEST_FILE])
        except OSError:
            return  # it is being replaced: the next look will find it
        except (UnicodeDecodeError, SyntaxError) as error:
            self._stamp = found.st_mtime_ns, found.st_size
            self._tell(str(error))
            return
        self._stamp = found.st_mtime_ns, found.st_size
        student = Student(self._command, self._limits, self._wait, self._path)
        lines = student.send("load", [str(self._path), text])
        self._loading = student, lines, self._clock() + self._limits.start

    def _loaded(self, student: Student, line: bytes | None) -> None:
        """Replace the version before by the one that was read, if that succeeded."""
        self._loading = None
        try:
            reply = student.reply(line, self._limits.start)
        except BadInputError as error:
            reply = Reply(problem=str(error))
        if reply.problem is not None or not isinstance(reply.result, list):
            student.close()
            self._tell(reply.problem or "not an answer")
            return
        if self._student is not None:
            self._student.close()
        self._student, self.own, self.problem = student, frozenset(map(str, reply.result)), ""
        self._news = tr("{file}: read again").format(file=self.name)

    def _tell(self, problem: str) -> None:
        """Remember a problem."""
        self.problem = placed_problem(self.name, problem)
        self.broken = self.broken or self.problem
        self._news = ": ".join(self.problem.split(": ")[:2])  # where and what; `note` has the rest
