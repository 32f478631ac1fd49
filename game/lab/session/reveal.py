"""How much of a picture is shown, and what was drawn by hand before the rest of it."""

from typing import NamedTuple

from game.lab.kit.handles import Handle
from game.lab.kit.marks import angle_between
from game.lab.kit.picture import Arrow, Mark, Picture, PointMark, Prediction, Role, Stroke
from physics import length

GUESS = "guess"
"""What a drag of the answer's handle asks to change; no parameter has this name."""
_FIRST = 1.5 + 1.0j
"""World units from where an arrow begins, or from the scene's first handle, to where its tip is at first."""


class Reveal(NamedTuple):
    """The state of showing a picture step by step.

    seen: the steps that are shown; None for the whole picture. predicts: whether answers are drawn by hand before they show.
    guess: where the hand put the next step's answer, world units; None where it was not touched yet.
    judged: the step shown last and the answer that was drawn for it; None where none was.
    """

    seen: int | None = None
    predicts: bool = False
    guess: complex | None = None
    judged: tuple[int, complex] | None = None

    def shown(self, picture: Picture) -> int:
        """How many steps of a picture are shown, which has fewer after a change of its values."""
        return len(picture.steps) if self.seen is None else min(self.seen, len(picture.steps))


WHOLE = Reveal()
"""All of a picture at once."""


def begun(reveal: Reveal) -> Reveal:
    """At the first step."""
    return Reveal(1, reveal.predicts)


def whole(reveal: Reveal) -> Reveal:
    """All of the picture."""
    return Reveal(None, reveal.predicts)


def next_step(reveal: Reveal, picture: Picture) -> Reveal:
    """One step more; after the last the whole picture, which is the same with its note."""
    if reveal.seen is None:
        return reveal
    count = reveal.shown(picture)
    asked = prediction(reveal, picture)
    if count >= len(picture.steps):
        return whole(reveal)
    judged = (count, guess_tip(reveal, asked)) if asked is not None else None
    return Reveal(count + 1, reveal.predicts, None, judged)


def previous_step(reveal: Reveal, picture: Picture) -> Reveal:
    """One step less: from the whole picture, without its last one; the first step stays."""
    return Reveal(max(reveal.shown(picture) - 1, 1), reveal.predicts)


def prediction(reveal: Reveal, picture: Picture) -> Prediction | None:
    """What is asked for before the next step; None where nothing is."""
    if not reveal.predicts or reveal.seen is None or reveal.shown(picture) >= len(picture.steps):
        return None
    return picture.steps[reveal.shown(picture)].prediction


def step_name(reveal: Reveal, picture: Picture) -> str:
    """Which step of a reveal is shown; empty for the whole picture."""
    if reveal.seen is None or not picture.steps:
        return ""
    shown = reveal.shown(picture)
    return f"{shown} of {len(picture.steps)}: {picture.steps[shown - 1].name}"


def step_words(reveal: Reveal, picture: Picture) -> str:
    """Which step of a reveal is shown, and what is asked for before the next one."""
    asked, name = prediction(reveal, picture), step_name(reveal, picture)
    return name if asked is None else f"{name}.   Now drag your {asked.asked}"


def guess_tip(reveal: Reveal, asked: Prediction) -> complex:
    """Where the drawn answer is; before it was touched, at a place that tells nothing."""
    if reveal.guess is not None:
        return reveal.guess
    return _FIRST + (asked.start if asked.start is not None else 0j)


def guess_handle(reveal: Reveal, picture: Picture) -> Handle | None:
    """The handle of the answer that is to be drawn."""
    asked = prediction(reveal, picture)
    if asked is None:
        return None
    return Handle(f"your {asked.asked}", lambda _: guess_tip(reveal, asked), lambda _given, target: {GUESS: target})


def shown_picture(reveal: Reveal, picture: Picture) -> Picture:
    """What is seen of a picture: its first steps, the answer that is being drawn, and the judged one with its error."""
    if reveal.seen is None or not picture.steps:
        return picture
    seen = picture.revealed(reveal.shown(picture))
    asked = prediction(reveal, picture)
    if asked is not None:
        seen = _with_marks(seen, _guess_marks(asked, guess_tip(reveal, asked)))
    if reveal.judged is not None and reveal.judged[0] < len(picture.steps):
        index, tip = reveal.judged
        answered = picture.steps[index].prediction
        if answered is not None:
            marked = _with_marks(seen, _guess_marks(answered, tip))
            seen = marked._replace(note=judgement(answered, tip))
    return seen


def judgement(asked: Prediction, tip: complex) -> str:
    """How far a drawn answer is from the right one, in words."""
    error = length(tip - asked.tip) / asked.scale
    if asked.start is None:
        return f"Your {asked.asked} is off by {error:.2f}."
    yours, right = tip - asked.start, asked.tip - asked.start
    if min(length(yours), length(right)) < 1e-9:
        return f"Your {asked.asked} is off by {error:.2f}."
    ratio = length(yours) / length(right)
    turned = angle_between(yours, right)
    return f"Your {asked.asked} is off by {error:.2f}: turned by {turned}, {ratio:.2f} times as long."


def _guess_marks(asked: Prediction, tip: complex) -> tuple[Mark, ...]:
    """The drawn answer."""
    name = f"your {asked.asked}"
    if asked.start is None:
        return (PointMark(tip, Role.GUESS, label=name),)
    return (Arrow(asked.start, tip - asked.start, Role.GUESS, None, Stroke.DASHED, name),)


def _with_marks(picture: Picture, marks: tuple[Mark, ...]) -> Picture:
    """A picture with more marks in its first pane."""
    first, *others = picture.panes
    return picture._replace(panes=(first._replace(marks=(*first.marks, *marks)), *others))
