"""The music for a browser: the notes of every layer as samples, and where each is to be heard. The page mixes them.

A note is rendered once, however often it is played. The pad's notes are longer than all the others together, so it is rendered
as a whole: what both ears hear, and by what they differ.
"""

import msgspec
import numpy as np

from game.sound.music.loops import Loop, gain_of, length, mixed, placements, waveform_of
from game.sound.music.score import Layer, notes
from game.sound.waves import Waveform
from game.web.archives import page_archive
from game.web.client.music import MusicIndex, MusicLayer
from game.web.samples import differences

_RATES = {Layer.PAD: 8000, Layer.BASS: 8000, Layer.ARPEGGIO: 12000, Layer.DRUMS: 24000, Layer.MELODY: 8000}
"""Samples per second: above twice the highest partial. No browser needs to have less than 8000."""
_BITS = {Layer.PAD: 8, Layer.BASS: 9, Layer.ARPEGGIO: 9, Layer.DRUMS: 10, Layer.MELODY: 9}
"""Of a sample, beside its sign."""

_Notes = list[tuple[int, int, float, float]]


def rendered_music() -> bytes:
    """An archive for the page: the index, and a file of samples for every layer."""
    files, layers = {}, []
    for layer in Layer:
        waves, heard = _pad() if layer is Layer.PAD else _notes(layer)
        most, start, pieces, entries = 2 ** _BITS[layer] - 1, 0, [], []
        for wave in waves:
            peak = max(float(np.abs(wave).max()), 1e-9)
            pieces.append(np.rint(wave / peak * most).astype(np.int16))
            entries.append((start, len(wave), peak / most))
            start += len(wave)
        files[str(int(layer))] = differences(np.concatenate(pieces))
        rate = _RATES[layer]
        layers.append(MusicLayer(rate, length(rate), gain_of(layer, _loop(layer, rate)), entries, heard))
    seconds = length(_RATES[Layer.DRUMS]) / _RATES[Layer.DRUMS]
    return page_archive(files | {"index": msgspec.json.encode(MusicIndex(seconds, layers))})


def _notes(layer: Layer) -> tuple[list[Waveform], _Notes]:
    """The different notes of a layer, and where they are heard."""
    waves: dict[tuple[float, float], Waveform] = {}
    heard: _Notes = []
    for note in notes(layer):
        key = note.pitch, note.beats
        if key not in waves:
            waves[key] = waveform_of(layer, note, _RATES[layer])
        number = list(waves).index(key)
        for placed in placements(layer, note):
            heard.append((number, round(placed.second * _RATES[layer]), round(placed.left, 4), round(placed.right, 4)))
    return list(waves.values()), heard


def _pad() -> tuple[list[Waveform], _Notes]:
    """The whole pad as two waves."""
    left, right = _loop(Layer.PAD, _RATES[Layer.PAD]).astype(np.float64)
    return [(left + right) / 2.0, (left - right) / 2.0], [(0, 0, 1.0, 1.0), (1, 0, 1.0, -1.0)]


def _loop(layer: Layer, rate: int) -> Loop:
    """A whole layer, as loud as its notes are by themselves."""
    *_, loop = mixed(layer, rate)
    assert loop is not None, "it comes last"
    return loop
