"""What a scene looks like, as a value: marks in the world, the formula with its numbers, the line that decides.

World units, y up; angles in radians, counter-clockwise. Colours are named for their role, never for a hue.
"""

from enum import Enum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.lab.kit.cited_line import CitedLine


class Toggle(Enum):
    """What can be shown or hidden."""

    CONTACTS = "contacts"
    NORMALS = "normals"
    GAP = "gap"
    BANDS = "bands"
    CLOSEST = "closest points"
    SWEPT = "swept path"
    PYMUNK = "pymunk"


class Tone(Enum):
    """The role a mark plays."""

    PLAIN = "plain"  # what the eye should find first after the ball
    FAINT = "faint"  # help lines
    BALL = "ball"
    GHOST = "ghost"  # where a ball was or will be
    SECTOR = "sector"
    OTHER = "other"  # a sector that is not the one looked at
    OURS = "ours"  # our normal, our answer
    SOURCE = "source"  # the answer of the source taken literally, where it errs
    PYMUNK = "pymunk"
    GOOD = "good"
    ONE = "one"  # four that are told apart: velocities, outcomes
    TWO = "two"
    THREE = "three"
    FOUR = "four"


class Stroke(Enum):
    """How a line is drawn."""

    SOLID = "solid"
    THICK = "thick"
    DASHED = "dashed"


class Disc(NamedTuple):
    """A filled circle."""

    centre: complex
    radius: float
    tone: Tone
    toggle: Toggle | None = None


class Circle(NamedTuple):
    """The line of a circle."""

    centre: complex
    radius: float
    tone: Tone
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.SOLID


class Sector(NamedTuple):
    """A filled annular sector around the origin."""

    radius: float
    half_width: float
    angle: float
    half_angle: float
    tone: Tone
    toggle: Toggle | None = None
    strength: float = 1.0  # 0 transparent to 1 opaque


class Band(NamedTuple):
    """A filled ring around the origin, drawn faintly."""

    inner: float
    outer: float
    tone: Tone
    toggle: Toggle | None = None
    strength: float = 0.25


class Line(NamedTuple):
    """A line through points."""

    points: tuple[complex, ...]
    tone: Tone
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.SOLID
    label: str = ""  # beside its middle


class Arrow(NamedTuple):
    """A vector."""

    start: complex
    way: complex
    tone: Tone
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.THICK
    label: str = ""  # at its tip


class Dot(NamedTuple):
    """A point."""

    place: complex
    tone: Tone
    toggle: Toggle | None = None
    label: str = ""


class Arc(NamedTuple):
    """A part of a circle's line: an angle."""

    centre: complex
    radius: float
    start: float
    sweep: float  # > 0 counter-clockwise
    tone: Tone
    toggle: Toggle | None = None
    stroke: Stroke = Stroke.SOLID
    label: str = ""  # beside its middle


class Words(NamedTuple):
    """A few words in the picture."""

    place: complex
    text: str
    tone: Tone
    toggle: Toggle | None = None


class Field(NamedTuple):
    """Signed numbers on a grid of cells, drawn in two colours with a line where they are 0."""

    lower: complex  # the lower left corner
    upper: complex  # the upper right one
    values: NDArray[np.float64]  # [column, row], from the lower left; NaN where there is none
    span: float  # this number, and its negative, have the full colours
    toggle: Toggle | None = None


Mark = Disc | Circle | Sector | Band | Line | Arrow | Dot | Arc | Words | Field


class Pane(NamedTuple):
    """One world. Two of them stand side by side, seen through the same camera."""

    marks: tuple[Mark, ...]  # from back to front
    title: str = ""


class Picture(NamedTuple):
    """All there is to see and to read."""

    panes: tuple[Pane, ...]
    formula: tuple[str, ...]  # of the phase, with the numbers in it, in the source's letters
    cited: CitedLine  # the line that decided
    note: str = ""  # what is special about these values, and why

    @property
    def toggles(self) -> frozenset[Toggle]:
        """What of it can be hidden."""
        return frozenset([mark.toggle for pane in self.panes for mark in pane.marks if mark.toggle is not None])


def single(marks: tuple[Mark, ...], formula: tuple[str, ...], cited: CitedLine, note: str = "") -> Picture:
    """A picture of one world."""
    return Picture((Pane(marks),), formula, cited, note)
