"""How loud a waveform can still become."""

import numpy as np

from game.sound.voices import TAIL_STEP, Tail
from game.sound.waves import Waveform


def tail(wave: Waveform, rate: int) -> Tail:
    """The largest amplitude that is still to come, every TAIL_STEP seconds, and a last 0. rate: samples per second."""
    starts = np.arange(0, len(wave), max(round(TAIL_STEP * rate), 1))
    loudest = np.maximum.reduceat(np.abs(wave), starts)
    return [*np.maximum.accumulate(loudest[::-1])[::-1].tolist(), 0.0]
