"""What a scene looks like, as a value: marks in the world, the formula with its numbers, and the line that decides.

World units, y up; angles in radians, counter-clockwise. A mark is coloured by its role, and drawn only while its toggle is on;
None is always on.
"""

from enum import Enum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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
    ONE, TWO, THREE, FOUR: what must be told apart, such as velocities.
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


class Field(NamedTuple):
    """Signed numbers on a grid of cells, in one colour above 0 and another below.

    lower, upper: the lower left and the upper right corner of the grid.
    values: [column, row] from the lower left; NaN where there is none.
    span: this number and its negative have the full colours.
    """

    lower: complex
    upper: complex
    values: NDArray[np.float64]
    span: float
    toggle: Toggle | None = None


Mark = Disc | Circle | AnnularSector | Annulus | Line | Arrow | PointMark | Arc | Words | Field


class Pane(NamedTuple):
    """One world. Several stand side by side, each seen through the same camera.

    marks: from back to front. has_handles: whether the scene's handles are in it, too. lines: of text, below, with their roles.
    """

    marks: tuple[Mark, ...]
    title: str = ""
    has_handles: bool = True
    lines: tuple[tuple[str, Role], ...] = ()


class Picture(NamedTuple):
    """All there is to see and to read.

    formula: lines of the phase's formula with the numbers in it, in the source's letters.
    cited: the line that decided. note: what is special about these values, and why.
    """

    panes: tuple[Pane, ...]
    formula: tuple[str, ...]
    cited: CitedLine
    note: str = ""

    @property
    def toggles(self) -> frozenset[Toggle]:
        """What of it can be hidden."""
        return frozenset([mark.toggle for pane in self.panes for mark in pane.marks if mark.toggle is not None])


def single(marks: tuple[Mark, ...], formula: tuple[str, ...], cited: CitedLine, note: str = "") -> Picture:
    """A picture of one world."""
    return Picture((Pane(marks),), formula, cited, note)
