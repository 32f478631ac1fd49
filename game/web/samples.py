"""Every sound of the game as numbers for a browser: 16-bit samples in one file, and what is known of each.

The file has third differences, which are small where a sound is smooth, and so compress to less than half.
"""

import numpy as np
from numpy.typing import NDArray

from game.sound.notes import every_note
from game.sound.synth import waveform
from game.sound.tails import tail
from game.web.client.sounds import RATE, SoundEntry, SoundIndex

Samples = NDArray[np.int16]
_FULL = 32767
_ORDER = 3
"""How often differences are taken: what compresses best of 0 to 4."""
_SHIFT = 16
"""Bits of a sample."""


def differences(samples: Samples) -> bytes:
    """Third differences of samples, modulo 2^16: all low bytes, then all high bytes. Their sign is in the lowest bit."""
    taken = samples.astype(np.int64)
    for _ in range(_ORDER):
        taken = np.diff(taken, prepend=0)
    wrapped = taken.astype(np.int16).astype(np.int64)
    folded = (wrapped << 1) ^ (wrapped >> (_SHIFT - 1))
    return folded.astype("<u2").view(np.uint8).reshape(-1, 2).T.tobytes()


def rendered() -> tuple[bytes, SoundIndex]:
    """All samples, one sound after the other, as `differences` has them; and where each sound begins."""
    pieces: list[Samples] = []
    entries: list[SoundEntry] = []
    start = 0
    for note in every_note():
        wave = waveform(note, RATE)
        samples = np.rint(np.clip(wave, -1.0, 1.0) * _FULL).astype(np.int16)
        levels = [round(level, 4) for level in tail(wave, RATE)]
        entries.append(SoundEntry(note.patch.name, note.step, note.layers, start, len(samples), levels))
        pieces.append(samples)
        start += len(samples)
    return differences(np.concatenate(pieces)), SoundIndex(RATE, entries)
