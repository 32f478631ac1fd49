"""The music: loops without seams that never clip, layers that follow the play, all of them together on the mixer."""

import itertools

import numpy as np
import pygame
import pytest

from game.levels import classic
from game.rules import Phase, Ruleset, new_game
from game.sound.mixer import Audio
from game.sound.music.loops import PEAK, composed, length
from game.sound.music.mood import CALM, SILENT, Mood, mood_of, nearer, wanted
from game.sound.music.player import CHANNELS
from game.sound.music.score import BARS, BEATS_PER_BAR, Drum, Layer, notes
from game.sound.voices import VOICES
from tests.support.clock import Clock

RATE = 11025
LOOPS = {layer: list(composed(layer, RATE))[-1] for layer in Layer}


@pytest.mark.parametrize("layer", Layer)
def test_a_loop_has_no_seam(layer):
    """From its last sample to its first it steps no more than within it; and it is as long as all others."""
    loop = LOOPS[layer]
    assert loop.shape == (2, length(RATE))
    assert np.abs(loop[:, 0] - loop[:, -1]).max() <= np.abs(np.diff(loop, axis=1)).max()
    assert np.isfinite(loop).all()


def test_no_choice_of_layers_is_louder_than_its_share():
    """Whatever layers play, their sum stays within PEAK, which the sounds of the game leave to them."""
    for count in range(1, CHANNELS + 1):
        for some in itertools.combinations(LOOPS.values(), count):
            assert np.abs(sum(some)).max() <= PEAK


def test_every_note_is_in_the_piece_and_in_its_key():
    """Notes begin within the eight bars; but for the drums every pitch is of G major."""
    for layer in Layer:
        for note in notes(layer):
            assert 0.0 <= note.beat < BARS * BEATS_PER_BAR
            if layer is Layer.DRUMS:
                assert note.pitch in set(Drum)
            else:
                assert round(note.pitch) % 12 in {0, 2, 4, 5, 7, 9, 11}


def test_layers_come_with_the_row_and_with_few_bricks():
    """Calm has the pad alone; the longer the row, the more layers; and with few layers of bricks left all of them play."""
    assert [layer for layer in Layer if wanted(CALM)[layer]] == [Layer.PAD]
    counts = [sum(gain > 0.0 for gain in wanted(Mood(playing=True, combo=combo))) for combo in range(9)]
    assert counts == sorted(counts)
    assert (counts[0], counts[-1]) == (2, CHANNELS)
    assert wanted(Mood(playing=True, combo=0, left=0.05)) == (1.0,) * CHANNELS


def test_layers_come_and_go_slowly():
    """No gain jumps, each reaches its goal, and they go more slowly than they come."""
    everything = (1.0,) * CHANNELS
    up, down = 0, 0
    gains = SILENT
    while gains != everything:
        later = nearer(gains, everything, 0.1)
        assert max(later) - max(gains) < 0.15
        gains, up = later, up + 1
    while gains != SILENT:
        gains, down = nearer(gains, SILENT, 0.1), down + 1
    assert 5 < up < down < 60


def test_the_mood_is_of_the_game():
    """Before the serve it is not that of play; all layers are there."""
    game = new_game(classic(), 1, Ruleset())
    assert mood_of(game) == Mood(playing=False, combo=0, left=1.0)
    assert mood_of(game._replace(phase=Phase.PLAYING, combo=4)).combo == 4


@pytest.fixture
def audio(monkeypatch):
    """Sound on SDL's dummy driver, its loops already computed."""
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    monkeypatch.setattr("game.sound.music.player.composed", lambda layer, _rate: iter([None, LOOPS[layer]]))
    made = Audio(RATE, clock=Clock())
    made._waiting.clear()
    yield made
    made.close()


def frames(audio, count, mood=CALM):
    """Let some frames of a 60th of a second go by."""
    for _ in range(count):
        audio._clock.now += 1.0 / 60.0
        audio.follow(mood)
        audio.prepare()


def playing():
    """The channels of the music that play, and how loud."""
    channels = [pygame.mixer.Channel(VOICES + number) for number in range(CHANNELS)]
    return [channel.get_volume() for channel in channels if channel.get_busy()]


def test_all_layers_play_together_and_follow_the_mood(audio):
    """Once computed all channels play, and only the wanted layers can be heard; without news from a game it grows calm."""
    audio.music_volume = 1.0
    frames(audio, 200)
    volumes = playing()
    assert len(volumes) == CHANNELS
    assert [volume > 0.0 for volume in volumes] == [True, False, False, False, False]
    frames(audio, 120, Mood(playing=True, combo=8))
    assert min(playing()) > 0.9
    for _ in range(400):
        audio._clock.now += 1.0 / 60.0
        audio.prepare()
    assert [volume > 0.0 for volume in playing()] == [True, False, False, False, False]


def test_no_music_without_its_volume(audio):
    """At a volume of 0 nothing is computed or played, and sounds may be as loud as without music."""
    audio.music_volume = 0.0
    frames(audio, 30)
    assert playing() == []
    assert audio._music._loops == []
    audio.muted = True
    audio.music_volume = 1.0
    frames(audio, 30)
    assert playing() == []
