"""The layers of the piece as loops of samples, computed note by note so that nobody waits for them.

What rings on beyond the end of a loop begins it: so it has no seam. All loops have the same length.
"""

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.sound.music.score import BARS, BEATS_PER_BAR, BEATS_PER_MINUTE, Drum, Layer, ScoreNote, notes
from game.sound.tuning import BASE
from game.sound.voices import panned
from game.sound.waves import Partial, Waveform, hiss, tone

Loop = NDArray[np.float32]
"""Two rows, left and right, within -1 to 1."""

PEAK = 0.26
"""The largest amplitude of all layers together: what is above is left to the sounds of the game."""
_LOWEST = BASE / 2.0
"""Hz; pitch 0."""
_LEVELS = {Layer.PAD: 0.055, Layer.BASS: 0.075, Layer.ARPEGGIO: 0.05, Layer.DRUMS: 0.05, Layer.MELODY: 0.045}
"""RMS of the loops before they are brought to PEAK together: how loud the layers are beside each other."""
_SHARES = {Layer.PAD: 0.40, Layer.BASS: 0.40, Layer.ARPEGGIO: 0.28, Layer.DRUMS: 0.34, Layer.MELODY: 0.25}
"""Of PEAK, what each layer may take at most; their peaks do not coincide."""
_ECHOES = ((0.75, 0.35), (1.5, 0.14))
"""Beats after a note of arpeggio and melody, and share of its loudness, of its echoes."""
_ATTACK, _RELEASE = 0.9, 1.6
"""Seconds in which a note of the pad comes and goes."""


class Placement(NamedTuple):
    """Where a note, or an echo of it, is in a loop. second: when it begins. left, right: gains of the ears."""

    second: float
    left: float
    right: float


def length(rate: int) -> int:
    """Samples of a loop at a number of samples per second."""
    return round(BARS * BEATS_PER_BAR * 60.0 / BEATS_PER_MINUTE * rate)


def composed(layer: Layer, rate: int) -> Iterator[Loop | None]:
    """The loop of a layer, last; before it None after every note, so that the work can be spread over many frames."""
    for loop in mixed(layer, rate):
        if loop is not None:
            np.multiply(loop, np.float32(gain_of(layer, loop)), out=loop)  # in place: another array would take 7 MB
        yield loop


def mixed(layer: Layer, rate: int) -> Iterator[Loop | None]:
    """As `composed`, but as loud as the notes are by themselves."""
    loop = np.zeros((2, length(rate)), dtype=np.float32)
    for note in notes(layer):
        wave = waveform_of(layer, note, rate)
        for placed in placements(layer, note):
            start = round(placed.second * rate)
            _add(loop[0], wave, start, np.float32(placed.left))
            _add(loop[1], wave, start, np.float32(placed.right))
        yield None
    loop -= loop.mean(axis=1, keepdims=True)
    yield loop


def waveform_of(layer: Layer, note: ScoreNote, rate: int) -> Waveform:
    """What a note sounds like; of its values, pitch and length matter."""
    return _VOICES[layer](note, note.beats * 60.0 / BEATS_PER_MINUTE, rate)


def placements(layer: Layer, note: ScoreNote) -> Iterator[Placement]:
    """Where a note is to be heard, and its echoes."""
    for later, share in ((0.0, 1.0), *(_ECHOES if layer in {Layer.ARPEGGIO, Layer.MELODY} else ())):
        left, right = panned(note.side if later == 0.0 else -note.side)
        gain = note.loudness * share
        yield Placement((note.beat + later) * 60.0 / BEATS_PER_MINUTE, gain * left, gain * right)


def gain_of(layer: Layer, loop: Loop) -> float:
    """What a loop is multiplied by to have its level, and to stay within its share of PEAK."""
    rms = math.sqrt(float(np.einsum("ij,ij->", loop, loop, dtype=np.float64)) / loop.size)
    peak = float(max(loop.max(), -loop.min()))
    return min(_LEVELS[layer] / max(rms, 1e-9), _SHARES[layer] * PEAK / max(peak, 1e-9))


def _add(row: NDArray[np.float32], wave: Waveform, start: int, gain: np.float32) -> None:
    """Add a waveform to a loop from a sample on; what goes beyond its end comes at its beginning."""
    start %= len(row)
    part = (wave * gain).astype(np.float32)
    while len(part):
        fitting = min(len(part), len(row) - start)
        row[start : start + fitting] += part[:fitting]
        part, start = part[fitting:], 0


def _frequency(pitch: float) -> float:
    """Hz of a pitch."""
    return _LOWEST * math.exp2(pitch / 12.0)


def _pad(note: ScoreNote, seconds: float, rate: int) -> Waveform:
    """A voice of a soft choir: it swells and fades."""
    whole = seconds + _RELEASE
    partials = (Partial(1.0, 1.0, 60.0), Partial(2.0, 0.28, 60.0), Partial(3.0, 0.10, 60.0))
    wave = tone(_frequency(note.pitch), partials, whole, rate)
    time = np.arange(len(wave)) / rate
    rise, fall = np.clip(time / _ATTACK, 0.0, 1.0), np.clip((whole - time) / _RELEASE, 0.0, 1.0)
    return np.asarray(wave * np.square(np.sin(0.5 * math.pi * rise)) * np.square(np.sin(0.5 * math.pi * fall)))


def _bass(note: ScoreNote, seconds: float, rate: int) -> Waveform:
    """A round, plucked string."""
    fade = 0.35 + 0.25 * seconds
    partials = (Partial(1.0, 1.0, fade), Partial(2.0, 0.45, fade * 0.5), Partial(3.0, 0.16, fade * 0.3))
    return _plucked(tone(_frequency(note.pitch), partials, seconds + 0.25, rate), seconds, rate)


def _bell(note: ScoreNote, seconds: float, rate: int) -> Waveform:
    """A small bell that leaves room for the bricks'."""
    partials = (Partial(1.0, 1.0, 0.20), Partial(2.0, 0.22, 0.10), Partial(3.98, 0.10, 0.05))
    return _plucked(tone(_frequency(note.pitch), partials, 0.8, rate), max(seconds, 0.5), rate)


def _flute(note: ScoreNote, seconds: float, rate: int) -> Waveform:
    """A breath of a tone that trembles a little."""
    whole = seconds + 0.2
    wave = tone(_frequency(note.pitch), (Partial(1.0, 1.0, 4.0), Partial(2.0, 0.18, 2.0), Partial(3.0, 0.07, 1.0)), whole, rate)
    time = np.arange(len(wave)) / rate
    rise, fall = np.clip(time / 0.06, 0.0, 1.0), np.clip((whole - time) / 0.25, 0.0, 1.0)
    tremble = 1.0 + 0.12 * np.sin(math.tau * 5.0 * time) * np.clip(time / 0.5, 0.0, 1.0)
    return np.asarray(wave * rise * rise * fall * fall * tremble)


def _drum(note: ScoreNote, _seconds: float, rate: int) -> Waveform:
    """A kick that falls, a hat of high noise, a clap of lower noise."""
    if note.pitch == Drum.KICK:
        time = np.arange(round(0.3 * rate)) / rate
        return np.asarray(np.sin(math.tau * (48.0 * time + 3.2 * (1.0 - np.exp(-time / 0.03)))) * np.exp(-time / 0.09))
    if note.pitch == Drum.HAT:
        bright = hiss(0.12, 0.022, 12000.0, rate)
        return np.asarray(0.5 * np.diff(bright, append=0.0))
    return np.asarray(0.55 * hiss(0.3, 0.06, 2200.0, rate))


def _plucked(wave: Waveform, seconds: float, rate: int) -> Waveform:
    """A tone that begins within 4 ms, and is damped when its time is over."""
    time = np.arange(len(wave)) / rate
    rise, fall = np.clip(time / 0.004, 0.0, 1.0), np.clip((len(wave) / rate - time) / 0.2, 0.0, 1.0)
    damped = np.where(time > seconds, np.exp(-(time - seconds) / 0.06), 1.0)
    return np.asarray(wave * rise * fall * damped)


_VOICES: dict[Layer, Callable[[ScoreNote, float, int], Waveform]] = {
    Layer.PAD: _pad,
    Layer.BASS: _bass,
    Layer.ARPEGGIO: _bell,
    Layer.DRUMS: _drum,
    Layer.MELODY: _flute,
}
