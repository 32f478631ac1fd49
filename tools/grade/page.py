"""The grading in a browser: in a worker of its own, which the page ends when a student's code does not answer."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import msgspec

from game.student.reply import Reply
from game.student.signatures import SIGNATURES
from game.web.client.functions.grading import GradedFunction, GradingReply, GradingRequest
from game.web.client.functions.text import RunningText
from tools.grade.findings import FunctionFindings, all_findings
from tools.grade.grading import FunctionGrade, grade
from tools.grade.report import answer_text, call_text, floored, result_text, verdict, wrong_traps
from tools.grade.scheme import Scheme
from tools.vectors.vector import vectors

_MOST_ENDINGS = 2
"""How often a function may run out of time; then its other questions are lost, too."""


class _Watched(NamedTuple):
    """The functions of a text, each call announced before it is asked.

    begins: is given the name of the function and the number of its call, from 1 on. given_up: for functions that are not asked,
    the call that they did not answer, in words. asked: how many calls each has had.
    """

    running: RunningText
    begins: Callable[[str, int], object]
    given_up: dict[str, str]
    asked: dict[str, int]

    def ask(self, function: str, arguments: Sequence[object]) -> Reply:
        """The answer."""
        if function in self.given_up:
            return Reply(problem=f"no answer to {self.given_up[function]}")
        if function in SIGNATURES:
            self.asked[function] = self.asked.get(function, 0) + 1
            self.begins(function, self.asked[function])
        reply = self.running.ask(function, arguments)
        late = reply.problem is not None and "no answer within" in reply.problem
        return reply._replace(ended=late)


class PageGrader:
    """Grades texts; the vectors are made once."""

    def __init__(self) -> None:
        """Make the published vectors, in the arithmetic of floats."""
        self._vectors = vectors(0, exact=False)

    def grade(self, request: str, begins: Callable[[str, int], object]) -> str:
        """Answer a `GradingRequest` with a `GradingReply`, both in JSON.

        begins: as of `_Watched`; ("", 1) before the text itself is run, and ("", 0) after the last call.
        """
        asked = msgspec.json.decode(request, type=GradingRequest)
        begins("", 1)
        running = RunningText(asked.text)
        if running.problem:
            return msgspec.json.encode(GradingReply(asked.number, running.problem)).decode()
        given_up = {name: self._call(name, number) for name, number in asked.given_up.items()}
        found = grade(_Watched(running, begins, given_up, {}), self._vectors, Scheme(), 0, _MOST_ENDINGS)
        begins("", 0)
        findings = all_findings(found)
        functions = tuple([_graded(function, findings[function.name]) for function in found.functions])
        written = any([function.defined for function in found.functions])
        words = verdict(found) if written else "None of the source's functions is written yet."
        return msgspec.json.encode(GradingReply(asked.number, "", words, functions)).decode()

    def _call(self, function: str, number: int) -> str:
        """A call in words. number: among those of its function, from 1 on."""
        return call_text([vector for vector in self._vectors if vector.function == function][number - 1])


def _graded(found: FunctionGrade, findings: FunctionFindings) -> GradedFunction:
    """One function's grade in words."""
    if not found.defined:
        return GradedFunction(found.name, defined=False, right=False, summary="not written")
    passed = len([checked for checked in found.counted if checked.right])
    share = "right" if found.right else f"wrong, {floored(100.0 * found.score)} %"
    summary = f"{passed} of {len(found.counted)}, {share}"
    details = [] if found.right else [f"wrong at: {wrong_traps(found)}"]
    if findings.simplest is not None:
        details.append(call_text(findings.simplest.vector))
        expected = result_text(findings.simplest.vector.expected)
        details.append(f"expected {expected}, got {answer_text(findings.simplest)}")
    silent = next((checked for checked in found.checked if checked.reply.problem is not None), findings.simplest)
    if silent is not None and silent is not findings.simplest:
        details.append(f"{call_text(silent.vector)}: {answer_text(silent)}")
    details += [f"{mistake.name}: {mistake.hint}" for mistake in findings.mistakes]
    return GradedFunction(found.name, True, found.right, summary, tuple(details), findings.lab_line or "")
