"""A player's own functions in a browser: a text that runs in the page's own Python, with a limit on its time."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from game.student.answering import note_of, placed_problem, usable_result
from game.student.hosted import HostedFile, answered, problem_of
from game.student.reply import Reply, parsed_answer
from game.web.client.functions.time_limit import TimeLimit

NAME = "functions.py"
PATH = Path("/own", NAME)
"""Of no file: what tracebacks say, and where the text would look for modules."""
ANSWER_SECONDS = 1.0
"""For one question."""


class RunningText:
    """A text of functions that was run, asked by the line protocol. Whatever it raises is its answer."""

    def __init__(self, text: str) -> None:
        """Run it; `problem` says what it raised, "" for nothing."""
        self._limit = TimeLimit(ANSWER_SECONDS)
        self.problem, self.own = "", frozenset[str]()
        self._file: HostedFile | None = None

        def run() -> Mapping[str, object]:
            self._file = HostedFile(PATH, text, self._limit.watch)
            return {"result": sorted(self._file.functions.own)}

        reply = self._limited(run)
        if reply.problem is None and isinstance(reply.result, list):
            self.own = frozenset(map(str, reply.result))
        else:
            self.problem, self._file = reply.problem or "not an answer", None

    def ask(self, function: str, arguments: Sequence[object]) -> Reply:
        """The answer to one question."""
        file = self._file
        if file is None:
            return Reply(problem=self.problem, ended=True)
        return self._limited(lambda: answered(file, function, list(arguments), PATH))

    def _limited(self, work: Callable[[], Mapping[str, object]]) -> Reply:
        """The reply that some work makes, in time."""
        try:
            with self._limit.running():
                return parsed_answer(work())
        except BaseException as error:  # noqa: BLE001  # whatever the student's code raises is its answer
            return Reply(problem=problem_of(error, PATH))


class FunctionsText:
    """The functions of a text as the game and the lab ask for them; see `game.student.answering.AnsweringFunctions`."""

    def __init__(self, text: str) -> None:
        """Run the text."""
        self.text = text
        self._running: RunningText | None = RunningText(text)
        self.own, self.problem = self._running.own, ""
        if self._running.problem:
            self.reject(self._running.problem)

    @property
    def name(self) -> str:
        """What the text is called."""
        return NAME

    @property
    def note(self) -> str:
        """One line that says whose functions answer."""
        return note_of(NAME, self.own, self.problem, answers=self._running is not None)

    def refresh(self) -> str:
        """Nothing: another text is another object."""
        return ""

    def ask(self, name: str, arguments: Sequence[object]) -> object:
        """The result of one question; None where there is none, and then nothing answers any more."""
        return None if self._running is None else usable_result(self, name, self._running.ask(name, arguments))

    def reject(self, problem: str) -> None:
        """Let nothing answer any more. problem: why."""
        self.problem, self.own, self._running = placed_problem(NAME, problem), frozenset(), None
