"""What a hit is in an array: one row."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from physics.step import Hit

HIT = np.dtype(
    [
        ("game", np.int64),
        ("tick", np.int64),
        ("time", np.float64),
        ("ball", np.int64),
        ("ring", np.int64),
        ("slot", np.int64),
        ("layers", np.int64),
        ("feature", np.int64),
        ("gap", np.float64),
        ("normal", np.complex128),
        ("point", np.complex128),
        ("before", np.complex128),
        ("after", np.complex128),
    ]
)
"""The game, the tick of the step, from 0, and the fields of `physics.Hit` and of its contact."""


class Rows(NamedTuple):
    """Rows that compiled code fills with hits.

    Attributes:
        hits: rows of `HIT`.
        now: how many are filled; the game and tick of the hits to come.
    """

    hits: npt.NDArray[Any]
    now: npt.NDArray[np.int64]

    def append(self, hit: Hit) -> None:
        """Fill the next row: so the physics, not compiled, adds its hits."""
        write_hit(self, hit)


def new_rows(number: int) -> Rows:
    """So many empty rows."""
    return Rows(np.empty(number, HIT), np.zeros(3, np.int64))


def joined(parts: Sequence[npt.NDArray[Any]]) -> npt.NDArray[Any]:
    """The rows of all parts in one array of `HIT`. They are copied as bytes, since numpy copies such rows field by field."""
    return np.concatenate([part.view(np.uint8) for part in parts]).view(HIT)


def write_hit(rows: Rows, hit: Hit) -> None:
    """Fill the next row."""
    row = rows.hits[rows.now[0]]
    rows.now[0] += 1
    row["game"], row["tick"], row["time"] = rows.now[1], rows.now[2], hit.time
    row["ball"], row["ring"], row["slot"], row["layers"] = hit.ball, hit.ring, hit.slot, hit.layers
    row["normal"], row["point"], row["gap"] = hit.contact.normal, hit.contact.point, hit.contact.gap
    row["feature"] = hit.contact.feature.value
    row["before"], row["after"] = hit.before, hit.after
