"""Which mistake explains wrong answers: the one whose own answers are the same ones."""

import itertools
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from game.student.signatures import Result, agrees, answer
from game.student.slides import SlideFunctions
from tools.grade.grading import CheckedVector, FunctionGrade, Grade
from tools.grade.mistakes import MISTAKES, NamedMistake
from tools.vectors.vector import size

_EXPLAINED = 0.9
"""Share of the wrong answers that a mistake must repeat, and of the right ones that it must leave right."""
_SAMPLE = 60
"""Vectors of a function that tell whether a mistake changes it."""


class _Repeated(NamedTuple):
    """How well a mistake's answers repeat the program's: the wrong ones, and the right ones; shares from 0 to 1."""

    wrong: float
    right: float


def named_mistakes(grade: Grade) -> Mapping[str, tuple[NamedMistake, ...]]:
    """For each wrong function the mistake in it, or two that were made together; none where none explains its answers.

    Where several mistakes explain a function equally well, it is the one that would make just those functions wrong that are
    wrong: so that a fault in `normalize_angle` has one name in all functions that call it.
    """
    wrong = {found.name for found in grade.functions if found.defined and not found.right}
    if not wrong:
        return {}
    present = {found.name: _answered(found) for found in grade.functions if found.defined}
    astray = [len({name for name in present if _changes(mistake, present[name])} ^ wrong) for mistake in MISTAKES]
    ordered = [MISTAKES[k] for k in sorted(range(len(MISTAKES)), key=lambda k: astray[k])]
    return {name: _explanation(present[name], ordered) for name in wrong}


def _answered(graded: FunctionGrade) -> list[CheckedVector]:
    """What a function answered.

    Vectors with more than one right answer are left out, so that a refinement beyond the source hides no mistake.
    """
    return [checked for checked in graded.counted if checked.reply.problem is None and not checked.vector.also]


def _explanation(answered: Sequence[CheckedVector], mistakes: Sequence[NamedMistake]) -> tuple[NamedMistake, ...]:
    """The first mistake that repeats a function's answers best; else two of those that change it at all."""
    if all([checked.right for checked in answered]):
        return ()
    single = _best([(mistake,) for mistake in mistakes], answered)
    return single or _best(itertools.combinations([one for one in mistakes if _changes(one, answered)], 2), answered)


def _best(candidates: Iterable[tuple[NamedMistake, ...]], answered: Sequence[CheckedVector]) -> tuple[NamedMistake, ...]:
    """The candidate that repeats the answers best, if it does so well enough; the first of equals."""
    best = (0.0, 0.0)
    found: tuple[NamedMistake, ...] = ()
    for candidate in candidates:
        repeated = _repeated(_combined(candidate), answered)
        quality = (min(repeated), sum(repeated))
        if min(repeated) >= _EXPLAINED and quality > best:
            best, found = quality, candidate
    return found


def _changes(mistake: NamedMistake, answered: Sequence[CheckedVector]) -> bool:
    """Whether a mistake changes an answer."""
    functions, sample = mistake.functions(), answered[:: max(len(answered) // _SAMPLE, 1)]
    return any([not agrees("", _answer(functions, one), one.vector.expected, 1e-6) for one in sample])


def _combined(mistakes: Sequence[NamedMistake]) -> SlideFunctions:
    """The source's functions with all of the mistakes."""
    kinds = [type(mistake.functions()) for mistake in mistakes]
    return kinds[0]() if len(kinds) == 1 else type("Combined", tuple(kinds), {})()


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
