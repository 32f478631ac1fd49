"""The piece: eight bars that go round, in G like all sounds, note by note for every layer.

Times and lengths are in beats, pitches in semitones above the G below middle C (0 is 196 Hz).
"""

from collections.abc import Callable, Iterator
from enum import IntEnum
from typing import NamedTuple

BEATS_PER_MINUTE = 92.0
BEATS_PER_BAR, BARS = 4, 8


class Layer(IntEnum):
    """What plays together, from what is always there to what comes last."""

    PAD = 0
    BASS = 1
    ARPEGGIO = 2
    DRUMS = 3
    MELODY = 4


class Drum(IntEnum):
    """What a note of the drums is, in place of a pitch."""

    KICK = 0
    HAT = 1
    CLAP = 2


class ScoreNote(NamedTuple):
    """One note.

    beat, beats: when it begins, and for how long. pitch: semitones; of the drums a `Drum`.
    loudness: 0 to 1. side: -1 left to 1 right.
    """

    beat: float
    beats: float
    pitch: float
    loudness: float
    side: float = 0.0


class _Chord(NamedTuple):
    """The chord of a bar: the bass, and the four notes above it."""

    bass: int
    notes: tuple[int, int, int, int]


_CHORDS = (
    _Chord(-12, (0, 4, 7, 14)),  # G with an added A
    _Chord(-15, (-3, 4, 7, 12)),  # E minor seventh
    _Chord(-19, (-3, 0, 4, 9)),  # C major seventh
    _Chord(-17, (-5, 2, 7, 12)),  # D with a fourth in place of the third
    _Chord(-8, (0, 4, 7, 11)),  # G major seventh over B
    _Chord(-10, (2, 5, 9, 12)),  # A minor seventh
    _Chord(-19, (0, 4, 7, 9)),  # C major ninth
    _Chord(-17, (2, 7, 11, 14)),  # D
)
_DETUNED = 0.026
"""Semitones."""
_ARPEGGIO = (0, 2, 1, 3, 2, 4, 3, 5, 4, 3, 2, 4, 3, 2, 1, 2)
"""The notes of a bar's sixteenths: numbers in the chord, from 4 on an octave higher."""
_BASS = ((0.0, 1.4, 0), (1.5, 0.4, 0), (2.0, 0.9, 12), (3.0, 0.4, 0), (3.5, 0.4, 7))
"""Beat, length and semitones above the root of the bass in a bar."""
_MELODY = (
    ((0.0, 1.5, 19), (1.5, 0.5, 16), (2.0, 1.0, 14), (3.0, 1.0, 16)),
    ((0.0, 2.0, 12), (2.0, 1.0, 9), (3.0, 1.0, 12)),
    ((0.0, 1.5, 16), (1.5, 0.5, 14), (2.0, 2.0, 12)),
    ((0.0, 3.0, 14), (3.0, 1.0, 19)),
    ((0.0, 1.5, 21), (1.5, 0.5, 19), (2.0, 2.0, 16)),
    ((0.0, 1.0, 17), (1.0, 1.0, 16), (2.0, 2.0, 14)),
    ((0.0, 1.0, 12), (1.0, 1.0, 14), (2.0, 1.0, 16), (3.0, 1.0, 19)),
    ((0.0, 4.0, 14),),
)
"""Beat, length and pitch of the melody's notes, bar by bar."""


def notes(layer: Layer) -> Iterator[ScoreNote]:
    """All notes of a layer, from the first to the last."""
    for bar in range(BARS):
        for note in _BAR_OF[layer](bar):
            yield note._replace(beat=note.beat + bar * BEATS_PER_BAR)


def _bar_of_pad(bar: int) -> Iterator[ScoreNote]:
    """The bar's chord, spread from left to right, every note by two voices that are not quite in tune."""
    for number, pitch in enumerate(_CHORDS[bar].notes):
        for detuned in (-_DETUNED, _DETUNED):
            yield ScoreNote(0.0, BEATS_PER_BAR, pitch + detuned, 0.5, 0.4 * (number - 1.5))


def _bar_of_bass(bar: int) -> Iterator[ScoreNote]:
    """The root, its octave and its fifth."""
    for beat, beats, above in _BASS:
        yield ScoreNote(beat, beats, _CHORDS[bar].bass + above, 0.9 if beat == 0.0 else 0.65)


def _bar_of_arpeggio(bar: int) -> Iterator[ScoreNote]:
    """Sixteenths up and down the chord, from side to side."""
    for step, number in enumerate(_ARPEGGIO):
        pitch = _CHORDS[bar].notes[number % 4] + 12 * (1 + number // 4)
        yield ScoreNote(step / 4.0, 0.5, pitch, 0.42 if step % 4 else 0.6, 0.5 if step % 2 else -0.5)


def _bar_of_melody(bar: int) -> Iterator[ScoreNote]:
    """A tune, a little to the right."""
    for beat, beats, pitch in _MELODY[bar]:
        yield ScoreNote(beat, beats, pitch, 0.7, 0.15)


def _bar_of_drums(bar: int) -> Iterator[ScoreNote]:
    """Kick on one and three, clap on two and four, hats between; the last bar has a kick more."""
    for beat in (0.0, 2.0, *((2.75, 3.5) if bar == BARS - 1 else (2.5,))):
        yield ScoreNote(beat, 0.5, Drum.KICK, 0.9 if beat in {0.0, 2.0} else 0.6)
    for beat in (1.0, 3.0):
        yield ScoreNote(beat, 0.5, Drum.CLAP, 0.5, -0.1)
    for step in range(8):
        yield ScoreNote(step / 2.0, 0.25, Drum.HAT, 0.4 if step % 2 else 0.22, 0.25)


_BAR_OF: dict[Layer, Callable[[int], Iterator[ScoreNote]]] = {
    Layer.PAD: _bar_of_pad,
    Layer.BASS: _bar_of_bass,
    Layer.ARPEGGIO: _bar_of_arpeggio,
    Layer.DRUMS: _bar_of_drums,
    Layer.MELODY: _bar_of_melody,
}
