"""The functions of `game.maths` on numpy's arrays."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.maths import Maths

Arrays = NDArray[np.floating[Any]]


def _picked(numbers: Sequence[float], index: Arrays) -> Arrays:
    """The number at each index; indices are rounded down."""
    return np.array(numbers, dtype=index.dtype)[index.astype(np.int64)]


ARRAYS = Maths[Arrays](np.sin, np.cos, np.sqrt, np.hypot, np.arctan2, np.expm1, np.clip, np.minimum, _picked)
