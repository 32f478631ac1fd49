"""Every function asked about every vector, and what the answers are worth."""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from game.student.reply import AskedFunctions, Reply
from game.student.signatures import SIGNATURES, agrees
from game.system.errors import BadInputError
from tools.grade.scheme import Scheme
from tools.vectors.vector import ConformanceVector

MOST_ENDINGS = 5
"""How often the program may end, or hang, in one function; then its other questions are lost, too."""


class CheckedVector(NamedTuple):
    """A vector and the answer. right: it is the source's, or a topic's beyond it. topic: its name, "" for the source's."""

    vector: ConformanceVector
    reply: Reply
    right: bool
    topic: str = ""


class FunctionGrade(NamedTuple):
    """What a function's answers are worth.

    defined: whether the program has it. checked: all vectors of the function; none where it is not defined. weight: in the
    score; 0 where it does not count.
    """

    name: str
    defined: bool
    checked: tuple[CheckedVector, ...]
    weight: float

    @property
    def counted(self) -> list[CheckedVector]:
        """The vectors that the source has an answer to."""
        return [checked for checked in self.checked if checked.vector.defined]

    @property
    def undefined(self) -> list[CheckedVector]:
        """The vectors that the source has no answer to."""
        return [checked for checked in self.checked if not checked.vector.defined]

    @property
    def wrong(self) -> list[CheckedVector]:
        """Those answered wrongly, the simplest numbers first."""
        wrong = [checked for checked in self.counted if not checked.right]
        return sorted(wrong, key=lambda checked: (_letters(checked.vector), checked.vector.number))

    @property
    def right(self) -> bool:
        """Whether every counted answer is."""
        return self.defined and not self.wrong

    @property
    def traps(self) -> dict[str, tuple[int, int]]:
        """For each trap how many answers are right, and of how many."""
        all_of = Counter([checked.vector.trap for checked in self.counted])
        right = Counter([checked.vector.trap for checked in self.counted if checked.right])
        return {trap: (right[trap], count) for trap, count in all_of.items()}

    @property
    def score(self) -> float:
        """From 0 to 1: every trap is worth the same, however many vectors it has."""
        traps = self.traps
        return sum([right / count for right, count in traps.values()]) / len(traps) if traps else 0.0

    @property
    def topics(self) -> dict[str, tuple[int, int]]:
        """For each topic beyond the source: how many answers are the source's own, and how many go beyond it."""
        touched = [(topic, checked) for checked in self.checked for topic in checked.vector.also if checked.right]
        own = Counter([topic for topic, checked in touched if not checked.topic])
        beyond = Counter([topic for topic, checked in touched if checked.topic == topic])
        return {topic: (own[topic], beyond[topic]) for topic in dict.fromkeys([topic for topic, _ in touched])}


class Grade(NamedTuple):
    """What the program is worth: a grade for each function, in the order of the slides; and the seed of the vectors."""

    functions: tuple[FunctionGrade, ...]
    seed: int
    title: str

    @property
    def graded(self) -> list[FunctionGrade]:
        """The functions that count."""
        return [found for found in self.functions if found.weight > 0.0]

    @property
    def score(self) -> float:
        """From 0 to 100."""
        weights = sum([found.weight for found in self.graded])
        return 100.0 * sum([found.weight * found.score for found in self.graded]) / weights if weights else 0.0

    @property
    def right(self) -> bool:
        """Whether every function that counts is right, and there is one."""
        return bool(self.graded) and all([found.right for found in self.graded])


def grade(
    student: AskedFunctions,
    vectors: Sequence[ConformanceVector],
    scheme: Scheme,
    seed: int = 0,
    most_endings: int = MOST_ENDINGS,
) -> Grade:
    """Ask about every vector, function by function. What the scheme does not count is asked, too, at a weight of 0.

    BadInputError is raised for a program that does not survive a first question, about a function that nobody has.
    """
    reply = student.ask("ready", [0.0])
    if reply.ended:
        raise BadInputError(f"the program answers no question: {reply.problem}")
    functions = []
    for name in SIGNATURES:
        checked = _checked(student, [vector for vector in vectors if vector.function == name], scheme, most_endings)
        defined = checked is not None
        required = scheme.functions is not None
        weight = scheme.weight(name) if scheme.counts(name) and (defined or required) else 0.0
        functions.append(FunctionGrade(name, defined, tuple(checked or ()), weight))
    return Grade(tuple(functions), seed, scheme.title)


def _checked(
    student: AskedFunctions, vectors: Sequence[ConformanceVector], scheme: Scheme, most_endings: int
) -> list[CheckedVector] | None:
    """The answers to all vectors of a function; None where the program does not have it."""
    checked, endings = [], 0
    for vector in vectors:
        if endings < most_endings:
            reply = student.ask(vector.function, vector.arguments)
        else:
            reply = Reply(problem=f"not asked: the program had ended or hung {most_endings} times in this function")
        if not reply.defined:
            return None
        endings += reply.ended
        checked.append(_judged(vector, reply, scheme))
    return checked


def _judged(vector: ConformanceVector, reply: Reply, scheme: Scheme) -> CheckedVector:
    """Whether an answer is the source's, or one that goes beyond it."""
    if not vector.defined or reply.problem is not None:
        return CheckedVector(vector, reply, right=not vector.defined)
    kind = SIGNATURES[vector.function].result
    for topic, expected in {"": vector.expected, **vector.also}.items():
        if agrees(kind, reply.result, expected, scheme.tolerance_of(vector, expected)):
            return CheckedVector(vector, reply, right=True, topic=topic)
    return CheckedVector(vector, reply, right=False)


def _letters(vector: ConformanceVector) -> int:
    """How long the arguments are when written."""
    return sum([len(repr(number)) for number in vector.arguments])
