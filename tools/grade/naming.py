"""Which mistake explains wrong answers: the one whose own answers are the same ones."""

import itertools
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from tools.grade.grading import CheckedVector, FunctionGrade
from tools.grade.mistakes import MISTAKES, NamedMistake
from tools.vectors.signatures import Result, agrees, answer
from tools.vectors.slides import SlideFunctions
from tools.vectors.vector import size

_EXPLAINED = 0.9
"""Share of the wrong answers that a mistake must repeat, and of the right ones that it must leave right."""


class _Repeated(NamedTuple):
    """How well a mistake's answers repeat the program's: the wrong ones, and the right ones; shares from 0 to 1."""

    wrong: float
    right: float


def named_mistakes(graded: FunctionGrade) -> tuple[NamedMistake, ...]:
    """The mistake in a function, or two that were made together; none where no mistake of the catalogue explains its answers.

    Vectors with more than one right answer are left aside, so that a refinement beyond the source hides no mistake.
    """
    answered = [checked for checked in graded.counted if checked.reply.problem is None and not checked.vector.also]
    if all([checked.right for checked in answered]):
        return ()
    single = _best([(mistake,) for mistake in MISTAKES], answered)
    return single or _best(itertools.combinations(_that_matter(answered), 2), answered)


def _best(candidates: Iterable[tuple[NamedMistake, ...]], answered: Sequence[CheckedVector]) -> tuple[NamedMistake, ...]:
    """The candidate that repeats the answers best, if it does so well enough; the first of equals."""
    best, found = (0.0, 0.0), ()
    for candidate in candidates:
        repeated = _repeated(_combined(candidate), answered)
        quality = (min(repeated), sum(repeated))
        if min(repeated) >= _EXPLAINED and quality > best:
            best, found = quality, candidate
    return found


def _that_matter(answered: Sequence[CheckedVector]) -> list[NamedMistake]:
    """The mistakes that change an answer of the function at all."""
    sample = answered[:: max(len(answered) // 100, 1)]
    return [mistake for mistake in MISTAKES if _changes(mistake.functions(), sample)]


def _changes(functions: SlideFunctions, answered: Sequence[CheckedVector]) -> bool:
    """Whether the functions answer anything differently."""
    return any([not agrees("", _answer(functions, one), one.vector.expected, 1e-6) for one in answered])


def _combined(mistakes: Sequence[NamedMistake]) -> SlideFunctions:
    """The source's functions with all of the mistakes."""
    kinds = [type(mistake.functions()) for mistake in mistakes]
    return kinds[0]() if len(kinds) == 1 else type("Combined", tuple(kinds), {})()  # type: ignore[call-arg]


def _repeated(functions: SlideFunctions, answered: Sequence[CheckedVector]) -> _Repeated:
    """How well the functions repeat the program's answers."""
    shares = []
    for right in (False, True):
        group = [checked for checked in answered if checked.right is right]
        same = [_is_same(_answer(functions, checked), checked) for checked in group]
        shares.append(sum(same) / len(same) if same else 1.0)
    return _Repeated(*shares)


def _answer(functions: SlideFunctions, checked: CheckedVector) -> Result:
    """The functions' answer to the vector."""
    try:
        return answer(functions, checked.vector.function, checked.vector.arguments)
    except ZeroDivisionError:
        return "division by zero"


def _is_same(expected: Result, checked: CheckedVector) -> bool:
    """Whether the program answered that."""
    return agrees("", checked.reply.result, expected, 1e-6 * size(expected))
