"""Which kinds of contact were compared? Every contact belongs to one cell; the cells that no contact fell into are named."""

import itertools
import math
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from tools.crosscheck.pymunk_model.ring_model import Part
from tools.crosscheck.results.measurements import FEATURE_OF_PART, FEATURES

MOTIONS = ("resting", "with the ball", "against it")
"""The surface at the contact moves along the ball's velocity, or against it."""
WIDTHS = ("edge 0", "side 0", "middle", "side 1", "edge 1")
"""Fifths of a feature: of a face clockwise to counter-clockwise, of an end inward to outward, of a corner's quarter circle from
the end's normal to the face's."""
INCIDENCES = ("head-on", "slanted", "glancing")
"""Angle between the relative velocity and the normal: below 30 degrees, below 60, up to 90."""
FRICTIONS = ("no friction", "some friction", "friction 1")
SECTORS = ("narrow", "wide", "beyond half a turn")
"""Half angle of the sector: below 20 degrees, up to 90, above."""
BALLS = ("one ball", "several balls")

_NARROW, _HALF_TURN = math.radians(20.0), math.pi / 2.0
_HEAD_ON, _SLANTED = math.cos(math.radians(30.0)), math.cos(math.radians(60.0))


class CoverageCell(NamedTuple):
    """One kind of contact; every field is an index into the names above, in this order."""

    feature: int
    motion: int
    width: int
    incidence: int
    friction: int
    sector: int
    balls: int

    @property
    def words(self) -> str:
        """The cell in words."""
        return ", ".join([names[index] for names, index in zip(NAMES.values(), self, strict=True)])


NAMES = {
    "feature": FEATURES,
    "surface": MOTIONS,
    "position": WIDTHS,
    "incidence": INCIDENCES,
    "friction": FRICTIONS,
    "sector": SECTORS,
    "balls": BALLS,
}
"""The dimensions of a cell, in its order, and what their values mean."""

ALL_CELLS = tuple([CoverageCell(*indices) for indices in itertools.product(*[range(len(names)) for names in NAMES.values()])])


class Judged(NamedTuple):
    """A contact as pymunk judges it, in numbers.

    part: of the shape. across: position across the feature, from 0 to 1. normal: unit. surface_velocity, velocity: of the
    surface at the contact and of the ball before it. half_angle: of the sector. balls: in play.
    """

    part: Part
    across: float
    normal: complex
    surface_velocity: complex
    velocity: complex
    friction: float
    half_angle: float
    balls: int


def cell_of(judged: Judged) -> CoverageCell:
    """The cell that a contact belongs to."""
    relative = judged.velocity - judged.surface_velocity
    steep = -_dot(relative, judged.normal) / (abs(relative) or 1.0)
    along = _dot(judged.surface_velocity, judged.velocity)
    return CoverageCell(
        FEATURES.index(FEATURE_OF_PART[judged.part]),
        0 if judged.surface_velocity == 0.0 else (1 if along >= 0.0 else 2),
        min(max(int(judged.across * len(WIDTHS)), 0), len(WIDTHS) - 1),
        0 if steep > _HEAD_ON else (1 if steep > _SLANTED else 2),
        0 if judged.friction == 0.0 else (2 if judged.friction == 1.0 else 1),
        0 if judged.half_angle < _NARROW else (1 if judged.half_angle <= _HALF_TURN else 2),
        min(judged.balls, 2) - 1,
    )


class Margin(NamedTuple):
    """All contacts with one feature and one value of one dimension.

    cells: how many of the `possible` cells have a contact.
    """

    feature: str
    dimension: str
    value: str
    contacts: int
    cells: int
    possible: int


def margins(cells: Counter[CoverageCell]) -> Iterator[Margin]:
    """The contacts by feature and by the value of every other dimension."""
    for feature, name in enumerate(FEATURES):
        for axis, (dimension, values) in enumerate(NAMES.items()):
            if axis == 0:
                continue
            for value, word in enumerate(values):
                possible = [cell for cell in ALL_CELLS if cell.feature == feature and cell[axis] == value]
                counts = [cells[cell] for cell in possible]
                yield Margin(name, dimension, word, sum(counts), sum([count > 0 for count in counts]), len(possible))


def empty_cells(cells: Counter[CoverageCell]) -> list[CoverageCell]:
    """The cells without a contact."""
    return [cell for cell in ALL_CELLS if not cells[cell]]


def _dot(a: complex, b: complex) -> float:
    return (a.conjugate() * b).real
