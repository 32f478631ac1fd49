"""The grade in words, slide by slide."""

from collections.abc import Iterator

from game.student.signatures import OUTCOMES, SIGNATURES
from tools.grade.findings import FunctionFindings
from tools.grade.grading import CheckedVector, FunctionGrade, Grade
from tools.vectors.beyond import TOPICS
from tools.vectors.vector import ConformanceVector

_SLIDES = {
    2: "Collision detection: broad phase",
    3: "Broad phase: the paddles",
    4: "Narrow phase, case 1",
    5: "Narrow phase, case 2",
    10: "Collision response (slides 6 to 10)",
    11: "Implementation notes: angles and polar coordinates",
}


def report_lines(grade: Grade, findings: dict[str, FunctionFindings]) -> Iterator[str]:
    """All lines; the verdict is the last one."""
    if grade.title:
        yield grade.title
    slide = 0
    for found in grade.functions:
        if SIGNATURES[found.name].slide != slide:
            slide = SIGNATURES[found.name].slide
            yield f"Slide {slide}: {_SLIDES[slide]}"
        yield from _function_lines(found, findings[found.name])
    beyond = list(_beyond_lines(grade))
    if beyond:
        yield "Beyond the source (does not count)"
        yield from beyond
    yield verdict(grade)


def verdict(grade: Grade) -> str:
    """The last line: whether all is right, and the score."""
    right = sum([found.right for found in grade.graded])
    word = "RIGHT" if grade.right else "WRONG"
    return f"{word}: score {floored(grade.score)} of 100, {right} of {len(grade.graded)} functions right, seed {grade.seed}"


def floored(score: float) -> str:
    """With one decimal, rounded down, so that only full marks are written as such."""
    tenths = int(score * 10.0 + 1e-9)
    return f"{tenths // 10}.{tenths % 10}"


def call_text(vector: ConformanceVector) -> str:
    """The call of a vector, with the names of its arguments."""
    signature = SIGNATURES[vector.function]
    rest, parts = list(vector.arguments), []
    for name in signature.parameters:
        if name == "positions":
            parts.append(
                f"{name}=[{', '.join([f'({r!r}, {theta!r})' for r, theta in zip(rest[::2], rest[1::2], strict=True)])}]"
            )
        elif name in signature.points:
            parts.append(f"{name}=({rest.pop(0)!r}, {rest.pop(0)!r})")
        else:
            parts.append(f"{name}={rest.pop(0)!r}")
    return f"{vector.function}({', '.join(parts)})"


def result_text(result: object) -> str:
    """A result in one line."""
    if isinstance(result, list):
        return f"({', '.join([result_text(part) for part in result])})"[:200]
    return result if result in OUTCOMES and isinstance(result, str) else repr(result)[:200]


def answer_text(checked: CheckedVector) -> str:
    """What the program did with a vector."""
    return checked.reply.problem or result_text(checked.reply.result)


def wrong_traps(found: FunctionGrade) -> str:
    """The traps that a function falls into, and how often."""
    wrong = [f"{trap} ({count - right} of {count})" for trap, (right, count) in found.traps.items() if right < count]
    return ", ".join(wrong)


def _function_lines(found: FunctionGrade, findings: FunctionFindings) -> Iterator[str]:
    """A function's counts; what is wrong with it."""
    if not found.defined:
        yield f"  {found.name:<25}not defined{'' if found.weight == 0.0 else ', but it counts'}"
        return
    passed = len([checked for checked in found.counted if checked.right])
    note = "" if found.weight > 0.0 else "   (does not count)"
    word = "right" if found.right else f"wrong, {floored(100.0 * found.score)} %"
    yield f"  {found.name:<24}{passed:>4} of {len(found.counted):<5}{word}{note}"
    if found.right:
        return
    yield f"    wrong at: {wrong_traps(found)}"
    if findings.simplest is not None:
        yield f"    simplest: {call_text(findings.simplest.vector)}"
        yield f"      expected {result_text(findings.simplest.vector.expected)}, got {answer_text(findings.simplest)}"
    if findings.lab_line is not None:
        yield f"      python -m game lab '{findings.lab_line}'"
    for mistake in findings.mistakes:
        yield f"    mistake: {mistake.name}. {mistake.hint}"
    problems = [checked for checked in found.wrong if checked.reply.problem is not None]
    if problems and problems[0] is not findings.simplest:
        yield f"    no answer: {len(problems)} times, such as {answer_text(problems[0])}"


def _beyond_lines(grade: Grade) -> Iterator[str]:
    """Where the slides have one answer and a better one exists; and where they have none."""
    for found in grade.functions:
        for topic, (own, beyond) in found.topics.items():
            if own and topic != "segment and wide sector":
                yield f"  {found.name}, {topic}: {own} answers as on the slides: {TOPICS[topic].source}."
            if beyond:
                yield f"  {found.name}, {topic}: {beyond} answers beyond them: {TOPICS[topic].beyond}."
        for trap in dict.fromkeys([checked.vector.trap for checked in found.undefined]):
            first = next(checked for checked in found.undefined if checked.vector.trap == trap)
            yield f"  {found.name}, {trap}: the slides divide by zero; the answer was {answer_text(first)}."
