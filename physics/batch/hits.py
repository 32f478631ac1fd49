"""What a hit is in an array: one row."""

import numpy as np

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
