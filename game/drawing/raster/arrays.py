"""The kinds of arrays that points and numbers are drawn from."""

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]
