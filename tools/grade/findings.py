"""What else a report says of a function: the mistakes in it, and its simplest wrong answer as a line of the lab."""

from typing import NamedTuple

from tools.grade.grading import FunctionGrade, Grade
from tools.grade.lab_line import lab_line
from tools.grade.mistakes import NamedMistake
from tools.grade.naming import named_mistakes


class FunctionFindings(NamedTuple):
    """lab_line: opens the simplest wrong answer in the lab; None where no scene shows it. mistakes: those that explain it."""

    mistakes: tuple[NamedMistake, ...] = ()
    lab_line: str | None = None


def all_findings(grade: Grade) -> dict[str, FunctionFindings]:
    """For every function by its name."""
    return {found.name: _findings(found) for found in grade.functions}


def _findings(found: FunctionGrade) -> FunctionFindings:
    """For one function."""
    if not found.defined or found.right:
        return FunctionFindings()
    return FunctionFindings(named_mistakes(found), lab_line(found.wrong[0].vector))
