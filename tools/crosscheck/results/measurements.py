"""What a comparison measured: every error with the bound it is held to, and the measurements worth showing."""

import math
from array import array
from enum import IntEnum
from typing import NamedTuple

from tools.crosscheck.pymunk_model.ring_model import Geometry, Part


class Comparison(IntEnum):
    """What is compared, in the order of the table."""

    TARGET = 0
    NORMAL_EXACT = 1
    NORMAL_FACETS = 2
    PRESENCE_TICK = 3
    PRESENCE_HIT = 4
    TIME = 5
    BOUNCE = 6
    VELOCITY = 7
    PHASE = 8
    SET_FREE = 9
    TURN = 10


class ContactVerdict(IntEnum):
    """Why two engines differ at a contact, from the harmless to what must not be."""

    EXACT = 0
    GRAZING = 1
    TIE = 2
    RULE = 3
    UNEXPLAINED = 4


VERDICT_NAMES = {
    ContactVerdict.EXACT: "agrees",
    ContactVerdict.GRAZING: "grazing",
    ContactVerdict.TIE: "tie between two features",
    ContactVerdict.RULE: "source rule",
    ContactVerdict.UNEXPLAINED: "unexplained",
}
VERDICT_MEANINGS = {
    ContactVerdict.EXACT: "pymunk's exact shape gives the same answers; the differences are rounding",
    ContactVerdict.GRAZING: "the ball passes within rounding of a graze: hit and miss are both right",
    ContactVerdict.TIE: "two shapes are equally near to within rounding; each engine names one of them",
    ContactVerdict.RULE: "pymunk knows no fixed speed and carries no ball; with these rules its velocity is ours",
    ContactVerdict.UNEXPLAINED: "none of these: one of the two engines is wrong",
}

FEATURES = ("outer face", "inner face", "end", "corner")
"""By the value of `physics.Feature`."""

FEATURE_OF_PART = {
    Part.OUTER_FACET: FEATURES[0],
    Part.OUTER_CIRCLE: FEATURES[0],
    Part.INNER_FACET: FEATURES[1],
    Part.INNER_CIRCLE: FEATURES[1],
    Part.END: FEATURES[2],
    Part.CORNER: FEATURES[3],
}

ANYWHERE = "anywhere"
"""The feature of what is compared away from contacts."""

Key = tuple[Comparison, str]
"""A row of the table: the comparison and the feature."""


class Compared(NamedTuple):
    """What one comparison gave.

    what: one sentence. error, bound: in the comparison's unit. ours, pymunks: both normals or both velocities; 0 where the
    comparison has none.
    """

    comparison: Comparison
    verdict: ContactVerdict
    what: str
    error: float
    bound: float
    ours: complex = 0j
    pymunks: complex = 0j


class Situation(NamedTuple):
    """Where and when something was compared: all that is needed to draw it and to repeat it.

    feature: as pymunk judges it. options: of the command that shows it again. time: seconds after the tick's start. slot: -1
    away from contacts. position: of the ball's centre. angle: of the ring's slot 0 at that time, radians. alive: which of
    the ring's slots hold material.
    """

    feature: str
    options: str
    tick: int
    time: float
    ball: int
    ring: int
    slot: int
    position: complex
    ball_radius: float
    geometry: Geometry
    angle: float
    alive: tuple[bool, ...]


class Measurement(NamedTuple):
    """One comparison with its situation."""

    compared: Compared
    situation: Situation


class Samples:
    """The errors of one row and their bounds.

    zeros: how many errors of exactly 0 there are beside those listed. worst: the measurement of the largest error.
    """

    def __init__(self) -> None:
        """Start empty."""
        self.errors = array("d")
        self.bounds = array("d")
        self.zeros = 0
        self.worst: Measurement | None = None

    def __len__(self) -> int:
        return len(self.errors) + self.zeros

    def add(self, error: float, bound: float) -> bool:
        """Take one error; whether it is the largest so far."""
        largest = self.worst is None or error > self.worst.compared.error
        self.errors.append(error)
        self.bounds.append(bound)
        return largest

    def merge(self, other: "Samples") -> None:
        """Take all that another game measured."""
        self.errors.extend(other.errors)
        self.bounds.extend(other.bounds)
        self.zeros += other.zeros
        if other.worst is not None and (self.worst is None or other.worst.compared.error > self.worst.compared.error):
            self.worst = other.worst

    def summary(self) -> "Summary | None":
        """The row's numbers; None for an empty row."""
        if not len(self):
            return None
        ordered = sorted(self.errors)
        largest = max(range(len(self.errors)), key=self.errors.__getitem__, default=None)
        shares = [_share(error, bound) for error, bound in zip(self.errors, self.bounds, strict=True)]
        return Summary(
            len(self),
            _quantile(ordered, self.zeros, 0.5),
            _quantile(ordered, self.zeros, 0.99),
            ordered[-1] if ordered else 0.0,
            math.nan if largest is None else self.bounds[largest],
            max(shares, default=0.0),
        )


class Summary(NamedTuple):
    """A row of the table.

    bound: the one that the largest error was held to; nan where every error is 0. share: the largest fraction that any error
    is of its own bound.
    """

    count: int  # type: ignore[assignment]  # hides tuple.count, which nothing needs
    median: float
    p99: float
    maximum: float
    bound: float
    share: float


def _share(error: float, bound: float) -> float:
    """The fraction that an error is of its bound."""
    if bound > 0.0:
        return error / bound
    return math.inf if error > 0.0 else 0.0


def _quantile(ordered: list[float], zeros: int, fraction: float) -> float:
    """A quantile of errors of which `zeros` more are 0."""
    index = math.ceil(fraction * (zeros + len(ordered))) - 1 - zeros
    return ordered[index] if index >= 0 else 0.0
