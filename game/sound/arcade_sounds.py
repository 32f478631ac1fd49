"""The sounds of what only the arcade rules have."""

from collections.abc import Callable

import numpy as np

from game.sound.patches import Patch
from game.sound.tuning import bell, melody, pitch
from game.sound.waves import Partial, Waveform, finished, glide, hiss, sequence, swell, tone


def _drop(rate: int) -> Waveform:
    """A drop into water: a short glide upwards that rings."""
    drop = glide(pitch(1), pitch(6), 0.09, rate)
    return finished(sequence([(0.0, drop * swell(len(drop))), (0.05, 0.5 * bell(pitch(6), 0.08, 0.3, rate))], rate), 0.6, rate)


def _gift(rate: int) -> Waveform:
    """Three bells upwards."""
    return finished(melody((3, 5, 8), 0.06, 0.16, rate), 0.95, rate)


def _trap(rate: int) -> Waveform:
    """Two low reeds downwards."""
    reed = (Partial(1.0, 1.0, 0.16), Partial(3.0, 0.5, 0.1), Partial(5.0, 0.3, 0.06))
    notes = [(0.0, tone(pitch(-4), reed, 0.26, rate)), (0.14, tone(pitch(-6), reed, 0.4, rate))]
    return finished(sequence(notes, rate), 0.85, rate)


def _power_off(rate: int) -> Waveform:
    """Two soft bells downwards."""
    return finished(melody((2, 0), 0.11, 0.14, rate), 0.6, rate)


def _life(rate: int) -> Waveform:
    """A turn of bells that ends high."""
    return finished(melody((0, 3, 5, 8, 10), 0.075, 0.25, rate), 1.1, rate)


def _balls(rate: int) -> Waveform:
    """Two glass marbles."""
    click = (Partial(1.0, 1.0, 0.03), Partial(2.32, 0.7, 0.02), Partial(4.25, 0.4, 0.012))
    return finished(tone(1960.0, click, 0.14, rate), 0.6, rate)


def _catch(rate: int) -> Waveform:
    """A soft, damped thud."""
    wave = tone(pitch(-7), (Partial(1.0, 1.0, 0.05), Partial(2.0, 0.2, 0.02)), 0.22, rate)
    return finished(wave + 0.25 * hiss(0.22, 0.03, 900.0, rate), 0.8, rate)


def _release(rate: int) -> Waveform:
    """A cork that pops."""
    wave = glide(pitch(-6), pitch(0), 0.12, rate)
    return finished(wave * swell(len(wave)), 0.7, rate)


def _faster(rate: int) -> Waveform:
    """A whirr upwards in two steps."""
    step = glide(pitch(-3), pitch(1), 0.13, rate)
    more = glide(pitch(0), pitch(4), 0.17, rate)
    return finished(sequence([(0.0, step * swell(len(step))), (0.1, more * swell(len(more)))], rate), 0.65, rate)


def _shield(rate: int) -> Waveform:
    """A gong that hums."""
    partials = (Partial(1.0, 1.0, 0.4), Partial(1.5, 0.5, 0.3), Partial(2.02, 0.6, 0.25), Partial(3.9, 0.3, 0.12))
    return finished(tone(pitch(-8), partials, 1.0, rate), 1.0, rate)


def _bumper(rate: int) -> Waveform:
    """A spring: a tone whose pitch wobbles as it dies away."""
    seconds = 0.34
    time = np.arange(round(seconds * rate)) / rate
    phase = pitch(0) * time + 0.9 * np.sin(np.pi * 2.0 * 17.0 * time) * np.exp(-time / 0.1)
    wave = (np.sin(np.pi * 2.0 * phase) + 0.35 * np.sin(np.pi * 4.0 * phase)) * np.exp(-time / 0.09)
    return finished(np.asarray(wave), 0.9, rate)


def _regrown(rate: int) -> Waveform:
    """A bubble that rises, and another."""
    bubble = glide(pitch(-8), pitch(-3), 0.1, rate)
    return finished(sequence([(0.0, bubble * swell(len(bubble))), (0.08, 0.7 * bubble * swell(len(bubble)))], rate), 0.6, rate)


def _crumbled(rate: int) -> Waveform:
    """A little gravel that falls."""
    gravel = hiss(0.12, 0.06, 900.0, rate)
    return finished(sequence([(0.0, gravel), (0.09, 0.6 * gravel)], rate), 0.6, rate)


def _core(rate: int) -> Waveform:
    """A wall that comes down, and a bright chord over it."""
    rumble = 1.4 * hiss(1.1, 0.3, 260.0, rate)
    bells = [(0.05 * k, bell(pitch(step), 0.4, 1.2, rate)) for k, step in enumerate((0, 3, 5, 8))]
    chord = sequence(bells, rate)
    return finished(sequence([(0.0, rumble / np.max(np.abs(rumble))), (0.12, 0.6 * chord / np.max(chord))], rate), 1.15, rate)


ARCADE_SOUNDS: dict[Patch, Callable[[int], Waveform]] = {
    Patch.DROP: _drop,
    Patch.GIFT: _gift,
    Patch.TRAP: _trap,
    Patch.POWER_OFF: _power_off,
    Patch.LIFE: _life,
    Patch.BALLS: _balls,
    Patch.CATCH: _catch,
    Patch.RELEASE: _release,
    Patch.FASTER: _faster,
    Patch.SHIELD: _shield,
    Patch.BUMPER: _bumper,
    Patch.REGROWN: _regrown,
    Patch.CRUMBLED: _crumbled,
    Patch.CORE: _core,
}
"""The kinds, and what makes them, at a number of samples per second."""
