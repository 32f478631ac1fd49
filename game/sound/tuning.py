"""The scale that everything is tuned in, and the bell that plays it."""

import math
from collections.abc import Sequence

from game.sound.waves import Partial, Waveform, sequence, tone

BASE = 392.0
"""The first brick's pitch in Hz: G above middle C. Everything tuned is in G."""

_PENTATONIC = (0, 2, 4, 7, 9)
"""Semitones of a scale in which any two notes go together: two bricks at once never clash."""


def pitch(step: int) -> float:
    """Frequency of a step of the scale in Hz; below 0 the scale goes on downwards."""
    octave, degree = divmod(step, len(_PENTATONIC))
    return BASE * math.exp2(octave + _PENTATONIC[degree] / 12.0)


def bell(frequency: float, fade: float, seconds: float, rate: int) -> Waveform:
    """A note of the jingles' instrument."""
    partials = (Partial(1.0, 1.0, fade), Partial(2.0, 0.35, fade * 0.6), Partial(4.0, 0.12, fade * 0.3))
    return tone(frequency, partials, seconds, rate)


def melody(steps: Sequence[int], apart: float, fade: float, rate: int) -> Waveform:
    """Steps of the scale at equal times."""
    seconds = 3.2 * fade
    notes = [(i * apart, bell(pitch(step), fade, seconds, rate)) for i, step in enumerate(steps)]
    return sequence(notes, rate)
