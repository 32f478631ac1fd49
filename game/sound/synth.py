"""Every sound of the game as a formula: sums of fading sines, glides and a little noise. No window, no mixer, no file.

A waveform is a one-dimensional float64 array, mono, within -1 to 1, that begins and ends at silence.
"""

import cmath
import math
from collections.abc import Callable, Sequence
from enum import Enum, auto
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Waveform = NDArray[np.float64]
"""One-dimensional, mono, within -1 to 1."""

STEPS = 13
"""Pitches a row of bricks climbs through; the last one stays."""
MOST_LAYERS = 3
"""From this many layers left on, stacks sound alike."""
BASE = 392.0
"""The first brick's pitch in Hz: G above middle C. Everything tuned is in G."""

_PENTATONIC = (0, 2, 4, 7, 9)
"""Semitones of a scale in which any two notes go together: two bricks at once never clash."""
_EDGE = 0.004
"""Seconds from silence to sound and back: shorter ones are heard as a click."""
_AUDIBLE_FADES = 12.0
"""After so many fades a tone is at 6e-6, below one step of a 16-bit sample."""
_LOUDNESS_BLOCK = 0.1
"""Seconds over which the ear adds up what it hears, roughly."""
_FFT_STEP = 2048
"""Lengths that an FFT is quick with are multiples of this."""
_REFERENCE = 0.1
"""Loudness of a brick: three at once stay below full scale in any ear, with room for a jingle."""


class Patch(Enum):
    """A kind of sound."""

    SERVE = auto()
    PADDLE = auto()
    BRICK = auto()
    WALL = auto()
    NUDGE = auto()
    LOST = auto()
    CLEARED = auto()
    WON = auto()
    OVER = auto()


class Note(NamedTuple):
    """One sound.

    patch: its kind.
    step: of the scale, 0 to STEPS - 1, for a brick; else 0.
    layers: left after the hit, 0 to MOST_LAYERS, for a brick; else 0.
    """

    patch: Patch
    step: int = 0
    layers: int = 0


class Partial(NamedTuple):
    """One sine of a tone.

    ratio: its frequency over the tone's.
    amplitude: at its beginning.
    fade: seconds in which it fades to 1/e.
    """

    ratio: float
    amplitude: float
    fade: float


def every_note() -> tuple[Note, ...]:
    """All sounds the game can make."""
    bricks = [Note(Patch.BRICK, step, layers) for layers in range(MOST_LAYERS + 1) for step in range(STEPS)]
    return (*[Note(patch) for patch in Patch if patch is not Patch.BRICK], *bricks)


def brick(combo: int, layers: int) -> Note:
    """The sound of a brick hit. combo: bricks in a row, this one included. layers: left after the hit."""
    return Note(Patch.BRICK, min(max(combo - 1, 0), STEPS - 1), min(max(layers, 0), MOST_LAYERS))


def pitch(step: int) -> float:
    """Frequency of a step of the scale in Hz; below 0 the scale goes on downwards."""
    octave, degree = divmod(step, len(_PENTATONIC))
    return BASE * math.exp2(octave + _PENTATONIC[degree] / 12.0)


def waveform(note: Note, rate: int) -> Waveform:
    """The sound of a note at `rate` samples per second."""
    if note.patch is Patch.BRICK:
        return _brick(pitch(note.step), note.layers, rate)
    return _VOICES[note.patch](rate)


def loudness(wave: Waveform, rate: int) -> float:
    """RMS of the loudest 0.1 s, weighted as the ear does: after the shape of ITU-R BS.1770's two filters."""
    half = round(_LOUDNESS_BLOCK * rate / 2.0)
    halves = np.zeros((len(wave) // half + 3, half))
    halves.ravel()[half : half + len(wave)] = wave
    blocks = np.hstack((halves[:-1], halves[1:]))
    squared = np.square(np.fft.rfftfreq(2 * half, 1.0 / rate))
    low_cut = squared / (squared + 38.0**2)
    high_shelf = (1681.0**2 + 1.58 * squared) / (1681.0**2 + squared)
    # Parseval: the power of a block is the sum of its spectrum's, both halves of it, over the length twice.
    powers = np.square(np.abs(np.fft.rfft(blocks) * low_cut * high_shelf)).sum(axis=1)
    return math.sqrt(2.0 * float(np.max(powers))) / (2 * half)


def _brick(frequency: float, layers: int, rate: int) -> Waveform:
    """A bar of glass that breaks bright; the more layers are left beneath it, the more wooden, lower-bodied and shorter."""
    seconds = 0.30 - 0.04 * layers
    fade = 0.085 - 0.014 * layers
    bright = 0.5 / (1.0 + 1.5 * layers)
    body = 0.16 * layers
    partials = (
        Partial(1.0, 1.0, fade),
        Partial(0.5, body, fade * 0.8),
        Partial(2.0, bright, fade * 0.7),
        Partial(3.0, bright * 0.5, fade * 0.5),
        Partial(5.4, bright * 0.35, fade * 0.25),
    )
    wave = _tone(frequency, partials, seconds, rate)
    wave += (0.22 if layers == 0 else 0.10) * _hiss(seconds, 0.012, 6000.0 if layers == 0 else 2500.0, rate)
    return _finished(wave, 1.0, rate)


def _serve(rate: int) -> Waveform:
    """A short sweep upwards."""
    wave = _glide(pitch(-5), pitch(0), 0.16, rate) + 0.3 * _glide(pitch(0), pitch(5), 0.16, rate)
    return _finished(wave * _swell(len(wave)), 0.9, rate)


def _paddle(rate: int) -> Waveform:
    """A wooden knock, well below the bricks."""
    partials = (Partial(1.0, 1.0, 0.045), Partial(3.93, 0.4, 0.016), Partial(9.2, 0.15, 0.008))
    wave = _tone(pitch(-3), partials, 0.18, rate) + 0.12 * _hiss(0.18, 0.006, 3000.0, rate)
    return _finished(wave, 0.85, rate)


def _wall(rate: int) -> Waveform:
    """A clang: the partials of a free steel bar, which are no multiples of one another."""
    partials = (
        Partial(1.0, 0.8, 0.11),
        Partial(2.756, 1.0, 0.08),
        Partial(5.404, 0.6, 0.05),
        Partial(8.933, 0.3, 0.025),
    )
    return _finished(_tone(311.0, partials, 0.36, rate), 0.75, rate)


def _nudge(rate: int) -> Waveform:
    """Two quick taps: the ball is turned a little."""
    tap = _tone(pitch(2), (Partial(1.0, 1.0, 0.02), Partial(2.0, 0.3, 0.01)), 0.10, rate)
    return _finished(_sequence([(0.0, tap), (0.07, tap)], rate), 0.5, rate)


def _lost(rate: int) -> Waveform:
    """A fall of an octave and a half."""
    wave = _glide(pitch(-1), pitch(-9), 0.55, rate) + 0.4 * _glide(pitch(4), pitch(-4), 0.55, rate)
    return _finished(wave * _swell(len(wave)), 1.1, rate)


def _cleared(rate: int) -> Waveform:
    """A chord of G, one note after the other."""
    return _finished(_melody((0, 2, 3, 5), 0.085, 0.22, rate), 1.0, rate)


def _won(rate: int) -> Waveform:
    """Up an octave and a half, and the chord to end on."""
    climb = _melody((0, 2, 3, 5, 7, 8), 0.10, 0.20, rate)
    chord = _sequence([(0.0, _bell(pitch(step), 0.45, 1.2, rate)) for step in (0, 2, 3, 5)], rate)
    return _finished(_sequence([(0.0, climb / np.max(climb)), (0.62, chord / np.max(chord))], rate), 1.15, rate)


def _over(rate: int) -> Waveform:
    """Down the scale, slower and slower, to a low end."""
    notes = [(0.0, _bell(pitch(0), 0.2, 0.5, rate)), (0.2, _bell(pitch(-1), 0.2, 0.5, rate))]
    notes += [(0.42, _bell(pitch(-2), 0.22, 0.6, rate)), (0.70, _bell(pitch(-5), 0.4, 0.9, rate))]
    return _finished(_sequence(notes, rate), 1.1, rate)


_VOICES: dict[Patch, Callable[[int], Waveform]] = {
    Patch.SERVE: _serve,
    Patch.PADDLE: _paddle,
    Patch.WALL: _wall,
    Patch.NUDGE: _nudge,
    Patch.LOST: _lost,
    Patch.CLEARED: _cleared,
    Patch.WON: _won,
    Patch.OVER: _over,
}


def _times(seconds: float, rate: int) -> Waveform:
    """The time of each sample."""
    return np.arange(round(seconds * rate)) / rate


def _tone(frequency: float, partials: Sequence[Partial], seconds: float, rate: int) -> Waveform:
    """Fading sines over one frequency; those too high for the rate are left out."""
    wave = np.zeros(round(seconds * rate))
    for ratio, amplitude, fade in partials:
        if amplitude and frequency * ratio < 0.45 * rate:
            sine = _fading_sine(frequency * ratio, fade, len(wave), rate)
            wave[: len(sine)] += amplitude * sine
    return wave


def _fading_sine(frequency: float, fade: float, length: int, rate: int) -> Waveform:
    """The imaginary part of z^n, z = exp((i tau f - 1 / fade) / rate); at most `length` samples, fewer once inaudible.

    Twice as many powers come from those there are by one multiplication: ten times as fast as exp and sin.
    """
    count = min(length, round(_AUDIBLE_FADES * fade * rate))
    z = cmath.exp(complex(-1.0 / fade, math.tau * frequency) / rate)
    powers = np.ones(count, np.complex128)
    done = 1
    while done < count:
        more = min(done, count - done)
        powers[done : done + more] = powers[:more] * z**done
        done += more
    return powers.imag


def _bell(frequency: float, fade: float, seconds: float, rate: int) -> Waveform:
    """A note of the jingles' instrument."""
    partials = (Partial(1.0, 1.0, fade), Partial(2.0, 0.35, fade * 0.6), Partial(4.0, 0.12, fade * 0.3))
    return _tone(frequency, partials, seconds, rate)


def _glide(start: float, end: float, seconds: float, rate: int) -> Waveform:
    """A sine whose frequency goes from start to end, the same musical interval in any equal time."""
    t = _times(seconds, rate)
    bend = math.log(end / start) / seconds
    return np.sin(math.tau * start / bend * np.expm1(bend * t))


@cache
def _hiss(seconds: float, fade: float, cutoff: float, rate: int) -> Waveform:
    """Fading noise below a frequency, the same in every run, about as strong as a sine."""
    t = _times(min(seconds, _AUDIBLE_FADES * fade), rate)
    size = math.ceil(len(t) / _FFT_STEP) * _FFT_STEP
    spectrum = np.fft.rfft(np.random.default_rng(1).standard_normal(size))
    spectrum /= 1.0 + np.square(np.fft.rfftfreq(size, 1.0 / rate) / cutoff)
    noise = np.fft.irfft(spectrum, size)
    hiss = np.zeros(round(seconds * rate))
    hiss[: len(t)] = noise[: len(t)] / np.std(noise) * np.exp(t / -fade)
    hiss.flags.writeable = False
    return hiss


def _swell(length: int) -> Waveform:
    """An envelope from 0 to 0 that is highest early."""
    return np.square(np.sin(math.pi * np.sqrt(np.linspace(0.0, 1.0, length))))


def _melody(steps: Sequence[int], apart: float, fade: float, rate: int) -> Waveform:
    """Steps of the scale at equal times."""
    seconds = 3.2 * fade
    notes = [(i * apart, _bell(pitch(step), fade, seconds, rate)) for i, step in enumerate(steps)]
    return _sequence(notes, rate)


def _sequence(parts: Sequence[tuple[float, Waveform]], rate: int) -> Waveform:
    """The sum of some waveforms, each after its start in seconds, faded in and out so that none clicks."""
    starts = [round(start * rate) for start, _ in parts]
    wave = np.zeros(max([start + len(part) for start, (_, part) in zip(starts, parts, strict=True)]))
    for start, (_, part) in zip(starts, parts, strict=True):
        wave[start : start + len(part)] += part * _edges(len(part), rate)
    return wave


def _edges(length: int, rate: int) -> Waveform:
    """An envelope of 1 that begins and ends at 0, each with half a raised cosine; the end takes longer."""
    rise, fall = round(_EDGE * rate), round(5.0 * _EDGE * rate)
    window = np.ones(length)
    window[:rise] = 0.5 - 0.5 * np.cos(np.linspace(0.0, math.pi, rise))
    window[-fall:] = 0.5 + 0.5 * np.cos(np.linspace(0.0, math.pi, fall))
    return window


def _finished(wave: Waveform, level: float, rate: int) -> Waveform:
    """The waveform with silent ends, no constant part, and `level` times the loudness of a brick."""
    window = _edges(len(wave), rate)
    wave = wave * window
    wave -= window * (np.sum(wave) / np.sum(window))
    return wave * (level * _REFERENCE / loudness(wave, rate))
