"""The answers of the player's functions beside ours and the slides'."""

from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple

from game.lab.yours.calls import OwnCall
from game.student.answering import AnsweringFunctions, answers_to
from game.student.engine_functions import EngineFunctions
from game.student.reply import Reply
from game.student.signatures import SIGNATURES, Result, agrees, answer
from game.student.slides import SlideFunctions

_TOLERANCE = 1e-7
"""By how much a number may differ, times the result's size where that is above 1: far below what can be seen."""
_OURS, _SLIDES = EngineFunctions(), SlideFunctions()


class AnswerVerdict(Enum):
    """What an answer is: ours; the slides', where ours goes beyond them; neither; or of no right or wrong."""

    OURS = "as ours"
    SLIDES = "as the slides have it"
    DIFFERS = "differs"
    UNDEFINED = "the slides divide by zero"


class OwnAnswer(NamedTuple):
    """An answer to a call.

    yours: the result; None also where there is a problem. ours: the engine's result. verdict: of yours.
    """

    call: OwnCall
    yours: object
    ours: Result
    verdict: AnswerVerdict
    problem: str | None = None


def own_answers(functions: AnsweringFunctions, calls: Sequence[OwnCall]) -> list[OwnAnswer]:
    """The answers to those of the calls whose functions the file defines. While it answers nothing, there are none."""
    asked = [call for call in calls if call.function in functions.own]
    replies = answers_to(functions, [(call.function, call.arguments) for call in asked])
    return [_judged(call, reply) for call, reply in zip(asked, replies, strict=True) if reply.defined]


def _judged(call: OwnCall, reply: Reply) -> OwnAnswer:
    """An answer, and what it is."""
    kind, ours = SIGNATURES[call.function].result, answer(_OURS, call.function, call.arguments)
    try:
        slides = answer(_SLIDES, call.function, call.arguments)
    except ZeroDivisionError:
        return OwnAnswer(call, reply.result, ours, AnswerVerdict.UNDEFINED, reply.problem)
    verdict = AnswerVerdict.DIFFERS
    if reply.problem is None and agrees(kind, reply.result, ours, _TOLERANCE * _size(ours)):
        verdict = AnswerVerdict.OURS
    elif reply.problem is None and agrees(kind, reply.result, slides, _TOLERANCE * _size(slides)):
        verdict = AnswerVerdict.SLIDES
    return OwnAnswer(call, reply.result, ours, verdict, reply.problem)


def _size(result: Result) -> float:
    """The size of a result's largest number, at least 1."""
    numbers = result if isinstance(result, list) else [result]
    return max([1.0, *[abs(number) for number in numbers if isinstance(number, float)]])
