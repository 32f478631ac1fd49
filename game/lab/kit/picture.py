"""What a scene looks like, as a value: marks in the world, the formula with its numbers, and the line that decides.

World units, y up; angles in radians, counter-clockwise. A mark is coloured by its role, and drawn only while its toggle is on;
None is always on.
"""

from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple, Protocol

from game.lab.kit.cited_line import CitedLine


class Toggle(Enum):
    """What can be shown or hidden. The value is written beside the check box."""

    CONTACTS = "contacts"
    NORMALS = "normals"
    GAP = "gap"
    BANDS = "bands"
    CLOSEST = "closest points"
    SWEPT = "swept path"
    PYMUNK = "pymunk"


class Role(Enum):
    """What a mark stands for; the theme gives each role a colour.

    PLAIN: what the eye should find first after the ball. FAINT: help lines. GHOST: where a ball was or will be.
    SECTOR: the sector that the scene looks at. OTHER: every other sector.
    OURS: the answer of the physics. SOURCE: the answer of the source taken literally, where it differs.
    PYMUNK: the second engine's answer. GOOD: a result to keep.
    ONE, TWO, THREE, FOUR: what must be told apart, such as velocities. GUESS: an answer that was drawn by hand.
    """

    PLAIN = "plain"
    FAINT = "faint"
    BALL = "ball"
    GHOST = "ghost"
    SECTOR = "sector"
    OTHER = "other"
    OURS = "ours"
    SOURCE = "source"
    PYMUNK = "pymunk"
    GOOD = "good"
    ONE = "one"
    TWO = "two"
    THREE = "three"
    FOUR = "four"
    GUESS = "guess"


class Stroke(Enum):
    """How a line is drawn."""

    SOLID = "solid"
    THICK = "thick"
    DASHED = "dashed"


class Disc(NamedTuple):
    """A filled circle that can be seen through."""

    centre: complex
    radius: float
    role: Role
    toggle: Toggle | None = None


class Circle(NamedTuple):
    """The line of a circle."""

    centre: complex
    radius: float
    role: Role
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.SOLID


class AnnularSector(NamedTuple):
    """A filled annular sector around the origin. opacity: 0 transparent to 1 opaque."""

    radius: float
    half_width: float
    angle: float
    half_angle: float
    role: Role
    toggle: Toggle | None = None
    opacity: float = 1.0


class Annulus(NamedTuple):
    """A filled ring around the origin. opacity: 0 transparent to 1 opaque."""

    inner: float
    outer: float
    role: Role
    toggle: Toggle | None = None
    opacity: float = 0.25


class Line(NamedTuple):
    """A line through points. label: beside its middle."""

    points: tuple[complex, ...]
    role: Role
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.SOLID
    label: str = ""


class Arrow(NamedTuple):
    """A vector drawn from a point. label: at its tip."""

    start: complex
    vector: complex
    role: Role
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.THICK
    label: str = ""


class PointMark(NamedTuple):
    """A point. label: beside it."""

    position: complex
    role: Role
    toggle: Toggle | None = None
    label: str = ""


class Arc(NamedTuple):
    """A part of a circle's line, such as an angle. sweep: above 0 counter-clockwise. label: beside its middle."""

    centre: complex
    radius: float
    start: float
    sweep: float
    role: Role
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.SOLID
    label: str = ""


class Words(NamedTuple):
    """A few words in the picture, centred at a position."""

    position: complex
    text: str
    role: Role
    toggle: Toggle | None = None


class FieldValues(Protocol):
    """A signed number at every position. Two that answer the same are equal, so that what is made of one can be cached."""

    def __hash__(self) -> int:
        """Of two that are equal the same."""

    def at(self, p: complex) -> float:
        """The number."""


class ScalarField(NamedTuple):
    """A signed number at every position, in one colour above 0 and another below.

    lower, upper: the lower left and the upper right corner of what it covers.
    span: this number and its negative have the full colours.
    """

    lower: complex
    upper: complex
    values: FieldValues
    span: float
    toggle: Toggle | None = None


Mark = Disc | Circle | AnnularSector | Annulus | Line | Arrow | PointMark | Arc | Words | ScalarField


class Pane(NamedTuple):
    """One world. Several stand side by side, each seen through the same camera.

    marks: from back to front. has_handles: whether the scene's handles are in it, too. lines: of text, below, with their roles.
    """

    marks: tuple[Mark, ...]
    title: str = ""
    has_handles: bool = True
    lines: tuple[tuple[str, Role], ...] = ()


class Prediction(NamedTuple):
    """What can be drawn by hand before a step shows it.

    asked: its name, in the source's letters. start: where the arrow begins; None where a point is asked for.
    tip: where the arrow ends, or the point. scale: world units drawn per unit of what is asked for.
    """

    asked: str
    start: complex | None
    tip: complex
    scale: float = 1.0


class RevealStep(NamedTuple):
    """What of a picture appears at once.

    name: what it is, in a few words. marks: those that appear in each pane, from back to front. formula: the lines that appear.
    prediction: what can be drawn by hand before; None for nothing.
    """

    name: str
    marks: tuple[tuple[Mark, ...], ...]
    formula: tuple[str, ...] = ()
    prediction: Prediction | None = None


class Picture(NamedTuple):
    """All there is to see and to read.

    formula: lines of the phase's formula with the numbers in it, in the source's letters.
    cited: the line that decided; None while it would tell too much. note: what is special about these values, and why.
    steps: those that the picture is made of, in which it can be revealed; none for a picture that is shown at once.
    """

    panes: tuple[Pane, ...]
    formula: tuple[str, ...]
    cited: CitedLine | None
    note: str = ""
    steps: tuple[RevealStep, ...] = ()

    @property
    def toggles(self) -> frozenset[Toggle]:
        """What of it can be hidden."""
        return frozenset([mark.toggle for pane in self.panes for mark in pane.marks if mark.toggle is not None])

    def revealed(self, count: int) -> "Picture":
        """What is seen after so many of its steps, at least one; all of it after the last.

        A pane that was added to the picture, and that no step has marks of, appears with the last.
        """
        if count >= len(self.steps):
            return self
        steps = self.steps[: max(count, 1)]
        panes = self.panes[: len(steps[0].marks)]
        return self._replace(panes=_with_marks(panes, steps), formula=_formula_of(steps), cited=None, note="")


def single(marks: tuple[Mark, ...], formula: tuple[str, ...], cited: CitedLine, note: str = "") -> Picture:
    """A picture of one world."""
    return Picture((Pane(marks),), formula, cited, note)


def in_steps(steps: Sequence[RevealStep], cited: CitedLine, note: str = "", panes: tuple[Pane, ...] = (Pane(()),)) -> Picture:
    """A picture made of steps. panes: without marks; each gets its own of every step."""
    steps = tuple(steps)
    return Picture(_with_marks(panes, steps), _formula_of(steps), cited, note, steps)


def one_step(name: str, marks: Sequence[Mark], formula: Sequence[str] = (), prediction: Prediction | None = None) -> RevealStep:
    """A step of a picture of one world."""
    return RevealStep(name, (tuple(marks),), tuple(formula), prediction)


def with_more_marks(step: RevealStep, marks: Sequence[Mark]) -> RevealStep:
    """A step with more marks in its first pane."""
    first, *others = step.marks
    return step._replace(marks=((*first, *marks), *others))


def _with_marks(panes: tuple[Pane, ...], steps: tuple[RevealStep, ...]) -> tuple[Pane, ...]:
    """The panes with all marks of some steps."""
    marks = [tuple([mark for step in steps for mark in step.marks[index]]) for index in range(len(panes))]
    return tuple([pane._replace(marks=seen) for pane, seen in zip(panes, marks, strict=True)])


def _formula_of(steps: tuple[RevealStep, ...]) -> tuple[str, ...]:
    """All lines of some steps."""
    return tuple([line for step in steps for line in step.formula])
