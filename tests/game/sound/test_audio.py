"""The mixer: that sounds reach it as they were chosen, and that nothing happens without one."""

import os
import random
import subprocess
import sys
import textwrap
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pygame
import pytest

from game.autopilot import Autopilot
from game.levels import classic
from game.replays.state_hash import state_hash
from game.rules import Event, EventKind, new_game, tick
from game.sound.mixer import Audio
from game.sound.music.player import CHANNELS
from game.sound.notes import every_note
from game.sound.voices import VOICES
from tests.support.children import eventually
from tests.support.clock import Clock
from tests.support.paths import ROOT

SERVED = [Event(EventKind.SERVED)]


def side(position):
    """Where a position is heard, in an arena of ten units."""
    return position.real / 10.0


@pytest.fixture
def audio(monkeypatch):
    """Sound on SDL's dummy driver."""
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    made = Audio(clock=Clock())
    yield made
    made.close()


def sounding():
    """How many voices the mixer plays."""
    return sum(pygame.mixer.Channel(channel).get_busy() for channel in range(VOICES))


def run(code, **environment):
    """What a program wrote, run on its own."""
    command = [sys.executable, "-c", textwrap.dedent(code)]
    return subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}, capture_output=True, text=True, check=False)


def test_every_event_but_a_levels_start_is_played(audio):
    """Each takes one channel of a mixer with two sides and sixteen bits."""
    assert audio.problem is None
    assert pygame.mixer.get_init() == (44100, -16, 2)
    for count, kind in enumerate(EventKind):
        audio._clock.now = 3.0 * count
        pygame.mixer.stop()
        audio.play([Event(kind)], side, 1)
        assert sounding() == (kind not in {EventKind.LEVEL_STARTED, EventKind.DROP_LOST, EventKind.AIMED})


def test_no_more_voices_than_there_are(audio):
    """A hundred events in one frame take no more than VOICES channels."""
    audio.play([Event(kind) for kind in EventKind] + [Event(EventKind.BRICK_HIT)] * 90, side, 95)
    assert 3 <= sounding() <= VOICES
    assert pygame.mixer.get_num_channels() == VOICES + CHANNELS


def test_sounds_are_computed_when_first_heard_or_one_a_frame(audio):
    """The start computes none. What is heard is computed at once, and once; `prepare` adds one a frame until there are all."""
    assert len(audio._sounds) == 0
    for combo in (3, 3, 4):
        audio.play([Event(EventKind.BRICK_HIT)], side, combo)
    assert len(audio._sounds) == 2
    computed = dict(audio._sounds)
    for count in range(len(every_note())):
        before = len(audio._sounds)
        audio.prepare()
        assert len(audio._sounds) <= before + 1, count
    assert set(audio._sounds) == set(every_note())
    assert all(audio._sounds[note] is sound for note, sound in computed.items())
    audio.prepare()


def test_mute_ends_what_sounds_and_starts_nothing(audio):
    """Muted, the mixer falls silent and plays nothing; unmuted, it plays again."""
    audio.play(SERVED, side, 0)
    assert sounding() == 1
    audio.muted = True
    eventually(lambda: sounding() == 0)
    audio.play(SERVED, side, 0)
    assert sounding() == 0
    audio.muted = False
    audio.play(SERVED, side, 0)
    assert (sounding(), audio.muted) == (1, False)


def test_volume_stays_between_0_and_1(audio):
    """A volume out of range becomes the nearest one in range."""
    for wanted, limited in ((0.25, 0.25), (1.5, 1.0), (-0.5, 0.0)):
        audio.volume = wanted
        assert audio.volume == limited


def test_another_rate_is_played_too(monkeypatch):
    """Sounds at 22050 samples per second are played on a mixer of that rate."""
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    audio = Audio(sample_rate=22050)
    audio.play(SERVED, side, 0)
    assert pygame.mixer.get_init() == (22050, -16, 2)
    assert sounding() == 1
    audio.close()


def test_without_a_card_there_is_one_line_and_silence(monkeypatch, capfd):
    """The line is written once and held in `problem`; playing, muting and closing do nothing more."""
    monkeypatch.setenv("SDL_AUDIODRIVER", "nonexistent")
    audio = Audio()
    said = capfd.readouterr().err
    audio.play(SERVED, side, 0)
    audio.volume, audio.muted = 0.5, True
    audio.play(SERVED, side, 0)
    audio.close()
    assert said == f"{audio.problem}\n"
    assert said.startswith("no sound: ")
    assert capfd.readouterr() == ("", "")
    assert (audio.volume, audio.muted) == (0.5, True)


@pytest.mark.parametrize("console", ["None", "sys.stderr"])
def test_no_card_is_no_error(console):
    """The exit code is 0 with and without a console, and C libraries add nothing to the one line."""
    done = run(
        f"""
        import os, sys
        sys.stderr = {console}
        if sys.stderr is None:
            os.close(2)
        from game.sound.mixer import Audio
        audio = Audio()
        audio.play([], None, 0)
        audio.close()
        print(audio.problem)
        """,
        SDL_AUDIODRIVER="nonexistent",
        PYGAME_HIDE_SUPPORT_PROMPT="1",
    )
    assert done.returncode == 0
    assert done.stdout.startswith("no sound: ")
    assert done.stderr == ("" if console == "None" else done.stdout)


@pytest.mark.parametrize("ending", [pygame.quit, pygame.mixer.quit])
def test_a_mixer_taken_away_is_silence(audio, ending):
    """After pygame has closed the mixer, playing, muting and closing do nothing."""
    audio.play(SERVED, side, 0)
    ending()
    audio.play(SERVED, side, 0)
    audio.volume, audio.muted = 0.5, True
    audio.close()
    assert pygame.mixer.get_init() is None


def test_closed_twice_and_played_after(audio):
    """Closing again and playing afterwards do nothing, and another mixer may be opened."""
    audio.close()
    audio.close()
    audio.play(SERVED, side, 0)
    assert pygame.mixer.get_init() is None
    again = Audio(clock=Clock())
    again.play(SERVED, side, 0)
    assert sounding() == 1
    again.close()


def test_a_game_with_sound_is_the_game_without(audio):
    """The state after 4000 ticks is the same, and Python's own generator is left alone."""

    def state(listener):
        game, pilot = new_game(classic()[:1], 5), Autopilot()
        heard = 0
        for _ in range(4000):
            ticked = tick(game, pilot.controls(game))
            game = ticked.game
            heard += len(ticked.events)
            listener(ticked.events, side, game.combo)
        return state_hash(game), heard

    chance = random.getstate()
    with_sound = state(audio.play)
    assert random.getstate() == chance
    assert with_sound == state(lambda *_: None)
    assert with_sound[1] > 10
    assert set(audio._sounds) <= set(every_note())


def recorded(path, x=0.0, volume=1.0, *, muted=False):
    """The left and the right ear's peak of the sound that reaches the card when a ball is lost at x, and of 3 s after it."""
    done = run(
        f"""
        import os, time
        from game.sound.mixer import Audio
        from game.rules import Event, EventKind
        audio = Audio()
        audio.volume, audio.muted = {volume}, {muted}
        audio.play([Event(EventKind.BALL_LOST, position=complex({x}))], lambda position: position.real / 10.0, 0)
        before = os.path.getsize({str(path)!r}) if os.path.exists({str(path)!r}) else 0
        while audio.problem is None and os.path.getsize({str(path)!r}) < before + 3 * 4 * 44100:
            time.sleep(0.005)
        audio.close()
        print(audio.problem)
        """,
        SDL_AUDIODRIVER="disk",
        SDL_DISKAUDIOFILE=str(path),
        SDL_DISKAUDIODELAY="2",  # ms from buffer to buffer: faster than they would sound
    )
    assert done.returncode == 0, done.stderr
    if "None" not in done.stdout:
        pytest.skip("this SDL cannot play to a file")
    assert done.stderr == "", "SDL's own lines about its driver are kept off"
    return np.max(np.abs(np.fromfile(path, np.int16).reshape(-1, 2).astype(float)), axis=0)


def test_the_card_hears_left_right_volume_and_mute(tmp_path):
    """Played to a file instead of a card: panned with constant power, half the volume a quarter of the amplitude, mute 0."""
    played = {"left": {"x": -10.0}, "middle": {}, "right": {"x": 10.0}, "half": {"volume": 0.5}, "silent": {"muted": True}}
    with ThreadPoolExecutor() as several:
        peaks = [several.submit(recorded, tmp_path / name, **given) for name, given in played.items()]
    left, middle, right, half, silent = [peak.result() for peak in peaks]
    assert left[0] > 3.0 * left[1] > 0.0
    assert left == pytest.approx(right[::-1], rel=0.02)
    assert middle[0] == pytest.approx(middle[1], rel=0.02)
    assert np.sum(left**2) == pytest.approx(np.sum(middle**2), rel=0.03)
    assert half == pytest.approx(0.25 * middle, rel=0.05)
    assert list(silent) == [0.0, 0.0]
