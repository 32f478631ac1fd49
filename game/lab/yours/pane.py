"""A pane more: the scene's own bodies, and on them what the player's functions answer, red where it differs."""

from game.lab.kit.parameters import Given
from game.lab.kit.picture import Arrow, Mark, Pane, Picture, PointMark, Role, Stroke, Words
from game.lab.kit.scene import LabScene
from game.lab.yours.answers import AnswerVerdict, OwnAnswer, own_answers
from game.lab.yours.calls import calls_of
from game.student.answering import AnsweringFunctions
from game.student.signatures import SIGNATURES, is_number

_ROLES = {
    AnswerVerdict.OURS: Role.GOOD,
    AnswerVerdict.SLIDES: Role.THREE,
    AnswerVerdict.DIFFERS: Role.SOURCE,
    AnswerVerdict.UNDEFINED: Role.FAINT,
}
_LARGE = 1e4
"""A number above it is written by its power of ten, and no vector so long is drawn."""
_SITUATION = 2
"""Steps of a reveal that show the question: the bodies, then the ball's angle or its velocity."""
_BODIES = frozenset({Role.BALL, Role.SECTOR, Role.OTHER, Role.PLAIN, Role.FAINT})
"""Roles of the marks that are there before anything is answered."""


def with_yours(picture: Picture, scene: LabScene, given: Given, functions: AnsweringFunctions | None) -> Picture:
    """The picture, and a pane with the answers of the player's functions; the picture itself where the scene asks for none."""
    calls = () if functions is None else calls_of(scene.name, given)
    if functions is None or not calls:
        return picture
    answers = own_answers(functions, calls)
    if not answers and not functions.problem:
        return picture
    marks = [mark for mark in _situation(picture) if _is_body(mark)]
    marks += [mark for one in answers for mark in _drawn(one)]
    lines = [line for one in answers for line in _written(one)] or [(functions.problem, Role.SOURCE)]
    return picture._replace(panes=(*picture.panes, Pane(tuple(marks), f"yours: {functions.name}", lines=tuple(lines))))


def _situation(picture: Picture) -> list[Mark]:
    """The marks of the first pane that are there before anything is computed; all, where the picture is not made of steps."""
    if not picture.steps:
        return list(picture.panes[0].marks)
    return [mark for step in picture.steps[:_SITUATION] for mark in step.marks[0]]


def _is_body(mark: Mark) -> bool:
    """Whether a mark is a ball, a sector or a help line, and no answer."""
    role = getattr(mark, "role", None)
    return role in _BODIES and getattr(mark, "toggle", None) is None and not isinstance(mark, Words)


def _drawn(one: OwnAnswer) -> list[Mark]:
    """An answer as an arrow or a point; nothing where it is neither."""
    start, label, role = one.call.start, one.call.label, _ROLES[one.verdict]
    yours, ours, scale = _vector(one.yours), _vector(one.ours), one.call.scale
    if yours is not None and max(abs(yours.real), abs(yours.imag)) > _LARGE:
        yours = None  # nothing of it would be in sight
    if not label:
        return []
    if start is None:
        return [] if yours is None else [PointMark(yours, role, None, label)]
    marks: list[Mark] = []
    if ours is not None and one.verdict is not AnswerVerdict.OURS:
        marks.append(Arrow(start, ours * scale, Role.FAINT, None, Stroke.DASHED, "ours"))
    if yours is not None:
        marks.append(Arrow(start, yours * scale, role, None, Stroke.THICK, label))
    return marks


def _written(one: OwnAnswer) -> list[tuple[str, Role]]:
    """An answer in words and numbers, and ours below it where it is another one."""
    role, kind = _ROLES[one.verdict], SIGNATURES[one.call.function].result
    name = f"{one.call.case}{one.call.function}"
    if one.problem is not None:
        return [(f"{name}: {one.problem}", role)]
    lines = [(f"{name} = {_words(one.yours, kind)}", role)]
    if one.verdict is not AnswerVerdict.OURS:
        lines.append((f"ours: {_words(one.ours, kind)}", Role.PLAIN))
    if one.verdict in {AnswerVerdict.SLIDES, AnswerVerdict.UNDEFINED}:
        lines[0] = (f"{lines[0][0]}, {one.verdict.value}", role)
    return lines


def _vector(result: object) -> complex | None:
    """A result that is a point or a vector."""
    if isinstance(result, list) and len(result) == 2 and all([is_number(part) for part in result]):
        return complex(*result)
    return None


def _number(number: float) -> str:
    """Two decimals, or the power of ten of what is too large for a pane."""
    return f"{number + 0.0:.2f}" if abs(number) < _LARGE else f"{number:.1e}"


def _words(result: object, kind: str) -> str:
    """A result in a few letters."""
    if result is None:
        return "no contact" if kind == "normal" else "None"
    vector = _vector(result)
    if kind == "polar" and vector is not None:
        return f"({_number(vector.real)}, {vector.imag:.5g} rad)"
    if vector is not None:
        return f"({_number(round(vector.real, 2))}, {_number(round(vector.imag, 2))})"
    if is_number(result):
        return f"{result:.6g} rad"
    return str(result)[:24]
