"""Every sound of the game as numbers for a browser: 16-bit samples in one file, and what is known of each."""

import numpy as np

from game.sound.notes import every_note
from game.sound.synth import waveform
from game.sound.tails import tail
from game.web.client.sounds import RATE, SoundEntry, SoundIndex

_FULL = 32767


def rendered() -> tuple[bytes, SoundIndex]:
    """All samples, little-endian, one sound after the other; and where each sound begins."""
    pieces: list[bytes] = []
    entries: list[SoundEntry] = []
    start = 0
    for note in every_note():
        wave = waveform(note, RATE)
        samples = np.rint(np.clip(wave, -1.0, 1.0) * _FULL).astype("<i2")
        levels = [round(level, 4) for level in tail(wave, RATE)]
        entries.append(SoundEntry(note.patch.name, note.step, note.layers, start, len(samples), levels))
        pieces.append(samples.tobytes())
        start += len(samples)
    return b"".join(pieces), SoundIndex(RATE, entries)
