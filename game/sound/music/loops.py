"""The layers of the piece as loops of samples, computed note by note so that nobody waits for them.

What rings on beyond the end of a loop begins it: so it has no seam. All loops have the same length.
"""

import math
from collections.abc import Callable, Iterator

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


def length(rate: int) -> int:
    """Samples of a loop at a number of samples per second."""
    return round(BARS * BEATS_PER_BAR * 60.0 / BEATS_PER_MINUTE * rate)


def composed(layer: Layer, rate: int) -> Iterator[Loop | None]:
    """The loop of a layer, last; before it None after every note, so that the work can be spread over many frames."""
    loop = np.zeros((2, length(rate)), dtype=np.float32)
    per_beat = 60.0 / BEATS_PER_MINUTE
    for note in notes(layer):
        wave = _VOICES[layer](note, note.beats * per_beat, rate)
        for later, share in ((0.0, 1.0), *(_ECHOES if layer in {Layer.ARPEGGIO, Layer.MELODY} else ())):
            side = note.side if later == 0.0 else -note.side
            left, right = panned(side)
            gain = np.float32(note.loudness * share)
            _add(loop[0], wave, round((note.beat + later) * per_beat * rate), gain * np.float32(left))
            _add(loop[1], wave, round((note.beat + later) * per_beat * rate), gain * np.float32(right))
        yield None
    loop -= loop.mean(axis=1, keepdims=True)
    yield loop * np.float32(_gain(layer, loop))


def _gain(layer: Layer, loop: Loop) -> float:
    """What a loop is multiplied by to have its level, and to stay within its share of PEAK."""
    rms = math.sqrt(float(np.mean(np.square(loop, dtype=np.float64))))
    peak = float(np.abs(loop).max())
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
