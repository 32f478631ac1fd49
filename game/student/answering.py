"""The interface of a student's functions for the game and the lab, whether they run in a child process or in a browser."""

from collections.abc import Sequence
from typing import Protocol

from game.language import tr
from game.student.reply import Reply, parsed_answer

_LISTED = 4
"""Functions that are named; of more, the number."""


class AnsweringFunctions(Protocol):
    """The functions of a file. Its methods do not raise: `problem` says what is wrong.

    Attributes:
        own: names of the source's functions that the file defines, and "advance" where it has one; empty where none answers.
        problem: what is wrong, in one line that names the file's line where there is one; "" where nothing is.
    """

    own: frozenset[str]
    problem: str

    @property
    def name(self) -> str:
        """The file's name."""

    @property
    def note(self) -> str:
        """One line that says whose functions answer."""

    def refresh(self) -> str:
        """What has happened to the file since the last call, in a few words; "" if nothing has."""

    def ask(self, name: str, arguments: Sequence[object]) -> object:
        """The result of one question; None if it failed, and then no function answers until the file has changed."""

    def reject(self, problem: str) -> None:
        """Let no function answer until the file has changed. problem: why, without the file's name."""


def answers_to(
    functions: AnsweringFunctions, calls: Sequence[tuple[str, Sequence[float]]], *, composed: bool = False
) -> list[Reply]:
    """The answers to calls of the source's functions, each call with its flat list of numbers; a failed one has a problem.

    composed: of the slides' functions with the file's in their place, so that every function has an answer.
    """
    answers = functions.ask("composed" if composed else "calls", calls) if calls else []
    if not isinstance(answers, list) or len(answers) != len(calls):
        return [Reply(problem=functions.problem)] * len(calls)
    return [parsed_answer(answer) for answer in answers]


def usable_result(functions: AnsweringFunctions, name: str, reply: Reply) -> object:
    """The result of one call; if it failed, the functions are rejected, and it is None. name: of the called function."""
    if reply.problem is not None or not reply.defined:
        functions.reject(reply.problem or f"{name} is not there")
        return None
    return reply.result


def note_of(name: str, own: frozenset[str], problem: str, *, answers: bool) -> str:
    """One line that says whose functions answer. name: of the file. own, problem: as of `AnsweringFunctions`.

    answers: whether any version of the file does.
    """
    if problem and not answers:
        return tr("{problem}; the slides' own functions answer until it is saved again").format(problem=problem)
    if problem:
        return tr("{problem}; the version before goes on").format(problem=problem)
    if len(own) > _LISTED:
        return tr("Your {count} functions, from {file}; the rest is the slides'").format(file=name, count=len(own))
    names = ", ".join(sorted(own)) or tr("nothing yet")
    return tr("Yours, from {file}: {functions}; the rest is the slides'").format(file=name, functions=names)


def placed_problem(name: str, problem: str) -> str:
    """A problem after the name of the file: NAME, line 3: ... or NAME: ..."""
    return f"{name}, {problem}" if problem.startswith("line ") else f"{name}: {problem}"
