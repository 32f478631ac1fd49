"""The vectors themselves: inputs with results from 50-digit arithmetic, or where no mpmath is from that of floats."""

from collections.abc import Iterator, Mapping
from functools import cache
from random import Random
from typing import Any, NamedTuple

from game.student.signatures import SIGNATURES, Result, agrees, answer
from game.student.slides import SlideFunctions
from tools.vectors.beyond import alternatives
from tools.vectors.inputs.angles import angle_lists, angle_plans
from tools.vectors.inputs.chosen import ChosenInput, InputPlan
from tools.vectors.inputs.detection import detection_lists, detection_plans
from tools.vectors.inputs.response import response_lists, response_plans

DIGITS = 50
TOLERANCE = 1e-9
"""Of every number of a result, times its size where that is above 1."""

_DISTURBANCE = 1e-6
_JUMP = 1e-3
"""A drawn input is left out if changing its numbers by _DISTURBANCE changes a number of the result by more than _JUMP: it is
so near to a boundary that rounding would decide."""


class ConformanceVector(NamedTuple):
    """One call of one function.

    number: 1, 2, ... among the vectors of its function. arguments: in the order of `Signature.numbers`. expected: the source's
    result. defined: False where the source divides by zero, so that every answer is right. also: other right answers, by the
    name of their topic in `beyond.TOPICS`. tolerance: of each number of the result.
    """

    function: str
    number: int
    trap: str
    arguments: tuple[float, ...]
    expected: Result
    defined: bool
    also: Mapping[str, Result]
    tolerance: float

    @property
    def name(self) -> str:
        """A name that a report can point to: min_difference-17."""
        return f"{self.function}-{self.number}"


def vectors(seed: int, *, exact: bool = True) -> list[ConformanceVector]:
    """All vectors of a seed, in the order of the slides. Seed 0 is the published set.

    exact: whether the results are of 50 digits, which needs mpmath; those of floats are the same within the tolerance.
    """
    numbers = dict.fromkeys(SIGNATURES, 0)
    by_function: dict[str, list[ConformanceVector]] = {name: [] for name in SIGNATURES}
    for chosen in _inputs(Random(seed)):
        numbers[chosen.function] += 1
        by_function[chosen.function].append(vector_of(chosen, numbers[chosen.function], exact=exact))
    return [vector for name in SIGNATURES for vector in by_function[name]]


def vector_of(chosen: ChosenInput, number: int, *, exact: bool = True) -> ConformanceVector:
    """The vector of an input. exact: as of `vectors`."""
    functions, of_library = (_exact(), _context().mpf) if exact else (_of_floats(), float)
    also: dict[str, Result] = {}
    try:
        expected, defined = answer(functions[""], chosen.function, chosen.arguments, of_library), True
    except ZeroDivisionError:
        return ConformanceVector(chosen.function, number, chosen.trap, chosen.arguments, None, False, also, TOLERANCE)
    tolerance = TOLERANCE * size(expected)
    for topic in alternatives(chosen.function):
        other = answer(functions[topic], chosen.function, chosen.arguments, of_library)
        if not agrees(SIGNATURES[chosen.function].result, other, expected, tolerance):
            also[topic] = other
    return ConformanceVector(chosen.function, number, chosen.trap, chosen.arguments, expected, defined, also, tolerance)


def size(result: Result) -> float:
    """The largest number of a result, at least 1."""
    numbers = result if isinstance(result, list) else [result] if isinstance(result, float) else []
    return max([1.0, *[abs(number) for number in numbers]])


def _inputs(chance: Random) -> Iterator[ChosenInput]:
    """Every input; no call twice."""
    seen: set[tuple[str, tuple[float, ...]]] = set()
    for chosen in (*angle_lists(), *detection_lists(), *response_lists()):
        seen.add((chosen.function, chosen.arguments))
        yield chosen
    for plan in (*angle_plans(), *detection_plans(), *response_plans()):
        yield from _drawn(plan, chance, seen)


def _drawn(plan: InputPlan, chance: Random, seen: set[tuple[str, tuple[float, ...]]]) -> Iterator[ChosenInput]:
    """The inputs of one trap, none of them near to a boundary."""
    count = 0
    while count < plan.amount:
        arguments = tuple([number + 0.0 for number in plan.draw(chance)])
        new = (plan.function, arguments) not in seen
        if new and is_asked(plan.function, arguments) and is_stable(plan.function, arguments):
            seen.add((plan.function, arguments))
            count += 1
            yield ChosenInput(plan.function, plan.trap, arguments)


def is_asked(function: str, arguments: tuple[float, ...]) -> bool:
    """Whether the slides ever ask for that: case 2 only where the ball's angle is outside of the sector's."""
    if function != "narrow_phase_case_2":
        return True
    _, _, _, theta, _, theta_p, _, phi_p = arguments
    return bool(SlideFunctions().min_difference(theta, theta_p) > phi_p)


def is_stable(function: str, arguments: tuple[float, ...]) -> bool:
    """Whether small changes of the arguments, one at a time, change every accepted answer a little only."""
    kind = SIGNATURES[function].result
    shifted = [
        (*arguments[:k], number + step, *arguments[k + 1 :])
        for k, number in enumerate(arguments)
        for step in (-_DISTURBANCE, _DISTURBANCE)
    ]
    for functions in (SlideFunctions(), *[topic.functions() for topic in alternatives(function).values()]):
        try:
            found = answer(functions, function, arguments)
            if not all([agrees(kind, answer(functions, function, other), found, _JUMP) for other in shifted]):
                return False
        except ZeroDivisionError:
            return False
    return True


@cache
def _context() -> Any:
    """Arithmetic with DIGITS decimal digits, whatever else uses the library."""
    import mpmath  # noqa: PLC0415  # a browser has none

    context = mpmath.MPContext()
    context.dps = DIGITS
    return context


@cache
def _exact() -> Mapping[str, SlideFunctions]:
    """The source's functions in that arithmetic, under "", and those of every topic."""
    return _functions(_context(), _context().mpc)


@cache
def _of_floats() -> Mapping[str, SlideFunctions]:
    """The same functions in the arithmetic of floats."""
    return _functions()


def _functions(*library: Any) -> Mapping[str, SlideFunctions]:
    """The source's functions, under "", and those of every topic. library: as of `SlideFunctions`."""
    topics = {name: topic for function in SIGNATURES for name, topic in alternatives(function).items()}
    return {"": SlideFunctions(*library)} | {name: topic.functions(*library) for name, topic in topics.items()}
