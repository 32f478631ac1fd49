"""Waveforms: fading sines, glides, noise, envelopes, and how loud they are.

A waveform is a one-dimensional float64 array, mono, within -1 to 1.
"""

import cmath
import math
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Waveform = NDArray[np.float64]
"""One-dimensional, mono, within -1 to 1."""

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


class Partial(NamedTuple):
    """One sine of a tone.

    ratio: its frequency over the tone's.
    amplitude: at its beginning.
    fade: seconds in which it fades to 1/e.
    """

    ratio: float
    amplitude: float
    fade: float


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


def finished(wave: Waveform, level: float, rate: int) -> Waveform:
    """The waveform with silent ends, no constant part, and `level` times the loudness of a brick."""
    window = _edges(len(wave), rate)
    wave = wave * window
    wave -= window * (np.sum(wave) / np.sum(window))
    return wave * (level * _REFERENCE / loudness(wave, rate))


def tone(frequency: float, partials: Sequence[Partial], seconds: float, rate: int) -> Waveform:
    """Fading sines over one frequency; those too high for the rate are left out."""
    wave = np.zeros(round(seconds * rate))
    for ratio, amplitude, fade in partials:
        if amplitude and frequency * ratio < 0.45 * rate:
            sine = _fading_sine(frequency * ratio, fade, len(wave), rate)
            wave[: len(sine)] += amplitude * sine
    return wave


def glide(start: float, end: float, seconds: float, rate: int) -> Waveform:
    """A sine whose frequency goes from start to end, the same musical interval in any equal time."""
    t = times(seconds, rate)
    bend = math.log(end / start) / seconds
    return np.sin(math.tau * start / bend * np.expm1(bend * t))


@cache
def hiss(seconds: float, fade: float, cutoff: float, rate: int) -> Waveform:
    """Fading noise below a frequency, the same in every run, about as strong as a sine."""
    t = times(min(seconds, _AUDIBLE_FADES * fade), rate)
    size = math.ceil(len(t) / _FFT_STEP) * _FFT_STEP
    spectrum = np.fft.rfft(np.random.default_rng(1).standard_normal(size))
    spectrum /= 1.0 + np.square(np.fft.rfftfreq(size, 1.0 / rate) / cutoff)
    noise = np.fft.irfft(spectrum, size)
    hiss = np.zeros(round(seconds * rate))
    hiss[: len(t)] = noise[: len(t)] / np.std(noise) * np.exp(t / -fade)
    hiss.flags.writeable = False
    return hiss


def swell(length: int) -> Waveform:
    """An envelope from 0 to 0 that is highest early."""
    return np.square(np.sin(math.pi * np.sqrt(np.linspace(0.0, 1.0, length))))


def sequence(parts: Sequence[tuple[float, Waveform]], rate: int) -> Waveform:
    """The sum of some waveforms, each after its start in seconds, faded in and out so that none clicks."""
    starts = [round(start * rate) for start, _ in parts]
    wave = np.zeros(max([start + len(part) for start, (_, part) in zip(starts, parts, strict=True)]))
    for start, (_, part) in zip(starts, parts, strict=True):
        wave[start : start + len(part)] += part * _edges(len(part), rate)
    return wave


def times(seconds: float, rate: int) -> Waveform:
    """The time of each sample."""
    return np.arange(round(seconds * rate)) / rate


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


def _edges(length: int, rate: int) -> Waveform:
    """An envelope of 1 that begins and ends at 0, each with half a raised cosine; the end takes longer."""
    rise, fall = round(_EDGE * rate), round(5.0 * _EDGE * rate)
    window = np.ones(length)
    window[:rise] = 0.5 - 0.5 * np.cos(np.linspace(0.0, math.pi, rise))
    window[-fall:] = 0.5 + 0.5 * np.cos(np.linspace(0.0, math.pi, fall))
    return window
