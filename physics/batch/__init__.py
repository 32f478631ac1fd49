"""Many games at once, on the same physics, compiled: needs the extra [batch], which brings numba.

Only this package of the physics imports numpy and numba, and nothing of the physics or the game imports it.
"""

from physics.batch.batch import Batch, Steps
from physics.batch.compilation import Compiled, compiled
from physics.batch.hits import HIT

__all__ = ["HIT", "Batch", "Compiled", "Steps", "compiled"]
