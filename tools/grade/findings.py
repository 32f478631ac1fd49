"""What else a report says of a function: the mistakes in it, and its simplest wrong answer."""

from typing import NamedTuple

from tools.grade.grading import CheckedVector, FunctionGrade, Grade
from tools.grade.lab_line import lab_line
from tools.grade.mistakes import NamedMistake
from tools.grade.naming import named_mistakes


class FunctionFindings(NamedTuple):
    """What is wrong with a function.

    mistakes: those that explain it. simplest: the wrong answer with the shortest numbers, among those that a scene of the lab
    shows, if there are any. lab_line: opens it in the lab; None where no scene shows it.
    """

    mistakes: tuple[NamedMistake, ...] = ()
    simplest: CheckedVector | None = None
    lab_line: str | None = None


def all_findings(grade: Grade) -> dict[str, FunctionFindings]:
    """For every function by its name."""
    named = named_mistakes(grade)
    return {found.name: _findings(found, named.get(found.name, ())) for found in grade.functions}


def _findings(found: FunctionGrade, mistakes: tuple[NamedMistake, ...]) -> FunctionFindings:
    """For one function."""
    wrong = found.wrong
    for checked in wrong:
        line = lab_line(checked.vector)
        if line is not None:
            return FunctionFindings(mistakes, checked, line)
    return FunctionFindings(mistakes, wrong[0] if wrong else None)
