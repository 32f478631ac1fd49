"""Every sound of the game, measured: levels, ends, spectra."""

import itertools

import numpy as np
import pytest

from game.sound.notes import MOST_LAYERS, STEPS, Note, brick, every_note
from game.sound.patches import Patch
from game.sound.synth import waveform
from game.sound.tuning import pitch
from game.sound.waves import loudness

RATE = 44100
NOTES = every_note()
WAVES = {note: waveform(note, RATE) for note in NOTES}
HITS = {Patch.BRICK, Patch.PADDLE, Patch.WALL, Patch.NUDGE, Patch.BALLS, Patch.CATCH, Patch.RELEASE, Patch.BUMPER}
BRICKS = [note for note in NOTES if note.patch is Patch.BRICK]


def name(note):
    return f"{note.patch.name.lower()}-{note.step}-{note.layers}"


def spectrum(wave, rate=RATE):
    """Frequencies and amplitudes, finely spaced."""
    size = 8 * len(wave)
    return np.fft.rfftfreq(size, 1.0 / rate), np.abs(np.fft.rfft(wave, size))


def strongest(wave, rate=RATE):
    """The frequency with the most in it."""
    frequencies, amplitudes = spectrum(wave, rate)
    return frequencies[np.argmax(amplitudes)]


def centroid(wave):
    """How bright it is: the middle of its energy, in Hz."""
    frequencies, amplitudes = spectrum(wave)
    return np.sum(frequencies * amplitudes**2) / np.sum(amplitudes**2)


def decibels(ratio):
    return 20.0 * np.log10(ratio)


def test_every_patch_and_every_brick_is_among_the_notes():
    """`every_note` has every patch and every brick once."""
    assert len(set(NOTES)) == len(NOTES)
    assert {note.patch for note in NOTES} == set(Patch)
    assert {(note.step, note.layers) for note in BRICKS} == set(itertools.product(range(STEPS), range(MOST_LAYERS + 1)))


@pytest.mark.parametrize("note", NOTES, ids=name)
def test_a_sound_begins_and_ends_at_silence_and_stays_in_range(note):
    """It has no NaN, no click at either end, a peak well below full scale, and no constant part."""
    wave = WAVES[note]
    peak = np.max(np.abs(wave))
    assert wave[0] == wave[-1] == 0.0
    assert np.all(np.isfinite(wave))
    assert 0.1 < peak < 0.5
    assert abs(np.mean(wave)) < 1e-6
    ends = np.abs(np.concatenate([wave[: RATE // 5000], wave[-RATE // 1000 :]]))
    assert np.max(ends) < 0.02 * peak


@pytest.mark.parametrize("note", NOTES, ids=name)
def test_a_sound_is_short(note):
    """A hit takes at most 0.4 s, a jingle at most 2 s."""
    seconds = len(WAVES[note]) / RATE
    assert 0.1 < seconds <= (0.4 if note.patch in HITS else 2.0)


@pytest.mark.parametrize("note", BRICKS, ids=name)
def test_a_brick_has_the_pitch_of_its_step(note):
    """The strongest frequency is the asked one, to a tenth of a semitone."""
    assert strongest(WAVES[note]) == pytest.approx(pitch(note.step), rel=2.0 ** (0.1 / 12.0) - 1.0)


@pytest.mark.parametrize("layers", range(MOST_LAYERS + 1))
def test_a_longer_row_is_higher_in_pitch(layers):
    """Each brick of a row is higher than the one before, up to the last step."""
    heard = [strongest(WAVES[brick(combo, layers)]) for combo in range(1, STEPS + 3)]
    assert all(low < high for low, high in itertools.pairwise(heard[:STEPS]))
    assert heard[STEPS - 1] == heard[STEPS] == heard[STEPS + 1]


def test_no_two_steps_clash():
    """An octave is five steps, and no two steps are a semitone, a tritone or a major seventh apart, in any octave."""
    for low, high in itertools.combinations(range(-10, STEPS), 2):
        semitones = 12.0 * np.log2(pitch(high) / pitch(low))
        assert semitones == pytest.approx(round(semitones), abs=1e-9)
        assert round(semitones) % 12 not in {1, 6, 11}
        assert (round(semitones) == 12) == (high - low == 5)


@pytest.mark.parametrize("step", range(STEPS))
def test_the_fewer_layers_are_left_the_brighter_and_longer_it_rings(step):
    """With fewer layers left a brick's sound is brighter and longer; its pitch belongs to the row alone."""
    waves = [WAVES[Note(Patch.BRICK, step, layers)] for layers in range(MOST_LAYERS + 1)]
    assert all(centroid(fewer) > centroid(more) for fewer, more in itertools.pairwise(waves))
    assert all(len(fewer) > len(more) for fewer, more in itertools.pairwise(waves))


@pytest.mark.parametrize(("combo", "layers", "note"), [(0, -1, (0, 0)), (1, 0, (0, 0)), (99, 99, (STEPS - 1, MOST_LAYERS))])
def test_any_combo_and_any_stack_has_a_sound(combo, layers, note):
    """A combo or a number of layers out of range has the sound of the nearest one in range."""
    assert brick(combo, layers) == Note(Patch.BRICK, *note)


def test_the_wall_clangs():
    """Its strong partials are no multiples of the lowest, as those of metal are not."""
    frequencies, amplitudes = spectrum(WAVES[Note(Patch.WALL)])
    lowest = frequencies[np.argmax(amplitudes * (frequencies < 400.0))]
    for low, high in ((600.0, 1200.0), (1400.0, 2000.0)):
        band = amplitudes * ((frequencies > low) & (frequencies < high))
        ratio = frequencies[np.argmax(band)] / lowest
        assert np.max(band) > 0.1 * np.max(amplitudes)
        assert abs(ratio - round(ratio)) > 0.2


def test_loss_falls_and_serve_rises():
    """A loss falls and a serve rises by at least half an octave from its first third to its last."""
    for patch, direction in ((Patch.LOST, -1.0), (Patch.SERVE, 1.0)):
        wave = WAVES[Note(patch)]
        third = len(wave) // 3
        assert direction * np.log2(strongest(wave[-third:]) / strongest(wave[:third])) > 0.5


def test_loudness_is_what_the_ear_adds_up():
    """Proportional to the amplitude; the same wherever the sound lies; less for a rumble, more for a hiss of equal power."""
    t = np.arange(RATE // 5) / RATE
    middle, low, high = [np.sin(2.0 * np.pi * f * t) for f in (500.0, 25.0, 5000.0)]
    assert loudness(middle, RATE) == pytest.approx(np.sqrt(0.5), rel=0.05)
    assert loudness(0.25 * middle, RATE) == pytest.approx(0.25 * loudness(middle, RATE))
    assert loudness(np.append(np.zeros(RATE), middle), RATE) == pytest.approx(loudness(middle, RATE), rel=0.05)
    assert loudness(low, RATE) < 0.5 * loudness(middle, RATE) < 0.5 * loudness(high, RATE)


def test_the_sounds_are_balanced():
    """Bricks are equally loud whatever their pitch; a nudge is the softest, 6 dB below, and nothing is more than 2 dB above."""
    brick_level = loudness(WAVES[brick(1, 0)], RATE)
    over = {note: decibels(loudness(wave, RATE) / brick_level) for note, wave in WAVES.items()}
    assert max(abs(over[note]) for note in BRICKS) < 0.1
    assert min(over, key=over.get) == Note(Patch.NUDGE)
    assert over[Note(Patch.NUDGE)] > -6.5
    assert max(over.values()) < 2.0


@pytest.mark.parametrize("note", [Note(Patch.WON), brick(4, 1), brick(STEPS, 0)], ids=name)
def test_another_rate_changes_neither_pitch_nor_length(note):
    """At 22050 and 48000 samples per second a sound has the same pitch and length."""
    for rate in (22050, 48000):
        wave = waveform(note, rate)
        assert len(wave) / rate == pytest.approx(len(WAVES[note]) / RATE, abs=1e-3)
        assert strongest(wave, rate) == pytest.approx(strongest(WAVES[note]), rel=3e-3)


def test_a_rate_too_low_for_a_partial_leaves_it_out():
    """At 8000 samples per second 10.7 kHz would be heard as 2.7 kHz, which nothing in the note is."""
    frequencies, amplitudes = spectrum(waveform(brick(STEPS, 0), 8000), 8000)
    mirrored = abs(5.4 * pitch(STEPS - 1) - 8000.0)
    assert np.max(amplitudes[np.abs(frequencies - mirrored) < 50.0]) < 0.02 * np.max(amplitudes)


@pytest.mark.parametrize("note", [Note(Patch.PADDLE), Note(Patch.WON), brick(1, 0)], ids=name)
def test_a_sound_is_the_same_every_time(note):
    """Computed again, a sound has the same samples, noise included."""
    assert np.array_equal(waveform(note, RATE), WAVES[note])


def test_the_sounds_of_a_game_are_soon_drawn():
    """The work is bounded by what there is to draw: no sound above 2 s, and all but the bricks' below 14 s together."""
    seconds = [len(WAVES[note]) / RATE for note in NOTES if note.patch is not Patch.BRICK]
    assert max(seconds) < 2.0
    assert sum(seconds) < 14.0
