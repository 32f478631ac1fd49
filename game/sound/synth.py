"""Every sound of the game as a formula: sums of fading sines, glides and a little noise. No window, no mixer, no file.

A waveform is a one-dimensional float64 array, mono, within -1 to 1, that begins and ends at silence.
"""

from collections.abc import Callable

import numpy as np

from game.sound.arcade_sounds import ARCADE_SOUNDS
from game.sound.notes import Note
from game.sound.patches import Patch
from game.sound.tuning import bell, melody, pitch
from game.sound.waves import Partial, Waveform, finished, glide, hiss, sequence, swell, tone


def waveform(note: Note, rate: int) -> Waveform:
    """The sound of a note at `rate` samples per second."""
    if note.patch is Patch.BRICK:
        return _brick(pitch(note.step), note.layers, rate)
    return _VOICES[note.patch](rate)


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
    wave = tone(frequency, partials, seconds, rate)
    wave += (0.22 if layers == 0 else 0.10) * hiss(seconds, 0.012, 6000.0 if layers == 0 else 2500.0, rate)
    return finished(wave, 1.0, rate)


def _serve(rate: int) -> Waveform:
    """A short sweep upwards."""
    wave = glide(pitch(-5), pitch(0), 0.16, rate) + 0.3 * glide(pitch(0), pitch(5), 0.16, rate)
    return finished(wave * swell(len(wave)), 0.9, rate)


def _paddle(rate: int) -> Waveform:
    """A wooden knock, well below the bricks."""
    partials = (Partial(1.0, 1.0, 0.045), Partial(3.93, 0.4, 0.016), Partial(9.2, 0.15, 0.008))
    wave = tone(pitch(-3), partials, 0.18, rate) + 0.12 * hiss(0.18, 0.006, 3000.0, rate)
    return finished(wave, 0.85, rate)


def _wall(rate: int) -> Waveform:
    """A clang: the partials of a free steel bar, which are no multiples of one another."""
    partials = (
        Partial(1.0, 0.8, 0.11),
        Partial(2.756, 1.0, 0.08),
        Partial(5.404, 0.6, 0.05),
        Partial(8.933, 0.3, 0.025),
    )
    return finished(tone(311.0, partials, 0.36, rate), 0.75, rate)


def _nudge(rate: int) -> Waveform:
    """Two quick taps: the ball is turned a little."""
    tap = tone(pitch(2), (Partial(1.0, 1.0, 0.02), Partial(2.0, 0.3, 0.01)), 0.10, rate)
    return finished(sequence([(0.0, tap), (0.07, tap)], rate), 0.5, rate)


def _lost(rate: int) -> Waveform:
    """A fall of an octave and a half."""
    wave = glide(pitch(-1), pitch(-9), 0.55, rate) + 0.4 * glide(pitch(4), pitch(-4), 0.55, rate)
    return finished(wave * swell(len(wave)), 1.1, rate)


def _cleared(rate: int) -> Waveform:
    """A chord of G, one note after the other."""
    return finished(melody((0, 2, 3, 5), 0.085, 0.22, rate), 1.0, rate)


def _won(rate: int) -> Waveform:
    """Up an octave and a half, and the chord to end on."""
    climb = melody((0, 2, 3, 5, 7, 8), 0.10, 0.20, rate)
    chord = sequence([(0.0, bell(pitch(step), 0.45, 1.2, rate)) for step in (0, 2, 3, 5)], rate)
    return finished(sequence([(0.0, climb / np.max(climb)), (0.62, chord / np.max(chord))], rate), 1.15, rate)


def _over(rate: int) -> Waveform:
    """Down the scale, slower and slower, to a low end."""
    notes = [(0.0, bell(pitch(0), 0.2, 0.5, rate)), (0.2, bell(pitch(-1), 0.2, 0.5, rate))]
    notes += [(0.42, bell(pitch(-2), 0.22, 0.6, rate)), (0.70, bell(pitch(-5), 0.4, 0.9, rate))]
    return finished(sequence(notes, rate), 1.1, rate)


_VOICES: dict[Patch, Callable[[int], Waveform]] = {
    Patch.SERVE: _serve,
    Patch.PADDLE: _paddle,
    Patch.WALL: _wall,
    Patch.NUDGE: _nudge,
    Patch.LOST: _lost,
    Patch.CLEARED: _cleared,
    Patch.WON: _won,
    Patch.OVER: _over,
    **ARCADE_SOUNDS,
}
