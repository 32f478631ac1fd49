"""What a comparison measured: every error with the bound it is held to, and the cases worth showing."""

import math
from array import array
from enum import IntEnum
from typing import NamedTuple

from tools.crosscheck.pymunk_model.ring_model import Geometry


class Comparison(IntEnum):
    """What is compared, in the order of the table."""

    NORMAL_EXACT = 0
    NORMAL_FACETS = 1
    PRESENCE_TICK = 2
    PRESENCE_HIT = 3
    TIME = 4
    BOUNCE = 5
    VELOCITY = 6


class Class(IntEnum):
    """Why two engines differ, from the harmless to what must not be."""

    EXACT = 0
    FACETS = 1
    GRAZING = 2
    TIE = 3
    RULE = 4
    UNEXPLAINED = 5


CLASS_NAMES = {
    Class.EXACT: "agrees on exact shapes",
    Class.FACETS: "within the facet bound",
    Class.GRAZING: "grazing",
    Class.TIE: "tie between two features",
    Class.RULE: "source rule",
    Class.UNEXPLAINED: "unexplained",
}
CLASS_MEANINGS = {
    Class.EXACT: "pymunk has the exact shape; the difference is rounding",
    Class.FACETS: "an inner face: pymunk only has chords, and differs by no more than they do from the arc",
    Class.GRAZING: "the ball comes no deeper than the chords' sagitta: hit or miss is the polygon's choice",
    Class.TIE: "two shapes are equally near; each engine names one of them",
    Class.RULE: "pymunk knows no fixed speed and carries no ball; with these rules applied to its velocity, it is ours",
    Class.UNEXPLAINED: "none of these: one of the two engines is wrong",
}

FEATURES = ("outer face", "inner face", "end", "corner")
"""By the value of `physics.Feature`."""

ANYWHERE = "anywhere"
"""The feature of what is compared away from hits."""

Key = tuple[Comparison, str]
"""A row of the table: the comparison and the feature."""


class Case(NamedTuple):
    """One comparison of one contact (or tick), with all that is needed to list, draw and repeat it."""

    kind: Class
    comparison: Comparison
    feature: str
    what: str  # one sentence
    options: str  # of the command that shows it again
    tick: int
    time: float  # seconds after the tick's start
    ball: int
    ring: int
    slot: int
    error: float
    bound: float
    ours: complex  # normal or velocity
    pymunks: complex
    position: complex  # of the ball's centre
    ball_radius: float
    geometry: Geometry
    angle: float  # of the ring's slot 0 at that time
    alive: tuple[bool, ...]  # which of the ring's slots hold material


class Samples:
    """The errors of one row and their bounds."""

    def __init__(self) -> None:
        """Start empty. zeros: how many errors of exactly 0 there are beside those listed."""
        self.errors = array("d")
        self.bounds = array("d")
        self.zeros = 0
        self.worst: Case | None = None

    def __len__(self) -> int:
        return len(self.errors) + self.zeros

    def add(self, error: float, bound: float) -> bool:
        """Take one error; whether it is the largest so far."""
        largest = self.worst is None or error > self.worst.error
        self.errors.append(error)
        self.bounds.append(bound)
        return largest

    def merge(self, other: "Samples") -> None:
        """Take all that another game measured."""
        self.errors.extend(other.errors)
        self.bounds.extend(other.bounds)
        self.zeros += other.zeros
        if other.worst is not None and (self.worst is None or other.worst.error > self.worst.error):
            self.worst = other.worst

    def summary(self) -> "Summary | None":
        """The row's numbers; None for an empty row."""
        if not len(self):
            return None
        ordered = sorted(self.errors)
        largest = max(range(len(self.errors)), key=self.errors.__getitem__, default=None)
        shares = [error / bound for error, bound in zip(self.errors, self.bounds, strict=True) if bound > 0.0]
        return Summary(
            len(self),
            _quantile(ordered, self.zeros, 0.5),
            _quantile(ordered, self.zeros, 0.99),
            ordered[-1] if ordered else 0.0,
            math.nan if largest is None else self.bounds[largest],
            max(shares, default=0.0),
        )


class Summary(NamedTuple):
    """A row of the table."""

    count: int  # type: ignore[assignment]  # hides tuple.count, which nothing needs
    median: float
    p99: float
    maximum: float
    bound: float  # the one that the largest error was held to; nan where every error is 0
    share: float  # the largest fraction that any error is of its own bound


def _quantile(ordered: list[float], zeros: int, fraction: float) -> float:
    """A quantile of errors of which `zeros` more are 0."""
    place = math.ceil(fraction * (zeros + len(ordered))) - 1 - zeros
    return ordered[place] if place >= 0 else 0.0
